// Errors of files, as VTK counts them.
#ifndef GlueFileErrors_h
#define GlueFileErrors_h

#include "Bytes/ParseStatus.h" // for ParseCode
#include "Files/WriteFiles.h"  // for WriteCode

#include <stdexcept> // for WriteError
#include <string>    // for messages

namespace glue
{
/// Why no file was written, with an error code of vtkErrorCode.
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

///@{
/// Return the code of vtkErrorCode for the end of reading or writing; none after an abort.
unsigned long ErrorCodeOf(conformal::ParseCode code);
unsigned long ErrorCodeOf(conformal::WriteCode code);
///@}
}

#endif
