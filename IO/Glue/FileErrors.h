// Convert errors of files to codes of vtkErrorCode.
#ifndef GlueFileErrors_h
#define GlueFileErrors_h

#include "Bytes/ParseStatus.h" // for ParseCode
#include "Files/WriteFiles.h"  // for WriteCode

#include <stdexcept> // for WriteError
#include <string>    // for messages

namespace glue
{
/// Error of writing a file, with a code of vtkErrorCode.
class WriteError : public std::runtime_error
{
public:
  WriteError(unsigned long code, const std::string& message)
    : std::runtime_error(message)
    , Code(code)
  {
  }
  const unsigned long Code;
};

/// @{
/// Return the code of vtkErrorCode for the result of reading or writing a file. The code after an
/// abort is NoError.
unsigned long ErrorCodeOf(conformal::ParseCode code);
unsigned long ErrorCodeOf(conformal::WriteCode code);
///@}
}

#endif
