// Convert errors of reading and writing files to the error codes of VTK (vtkErrorCode).
#ifndef GlueFileErrors_h
#define GlueFileErrors_h

#include "Bytes/ParseStatus.h" // for ParseCode
#include "Files/WriteFiles.h"  // for WriteCode

#include <functional> // for ReadFile
#include <stdexcept>  // for WriteError
#include <string>     // for messages

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
/// Return the code of vtkErrorCode for the result of reading or writing a file. If the operation
/// was aborted, the code is NoError.
unsigned long ErrorCodeOf(conformal::ParseCode code);
unsigned long ErrorCodeOf(conformal::WriteCode code);
///@}

/// How a reader's request ended: a code of vtkErrorCode, and the text of the error, if any.
struct ReadOutcome
{
  unsigned long Code = 0;
  std::string Error;
};

/// Call a function that reads a file and throws exceptions of errors. If it is aborted, that is not
/// an error.
/// @param[in] fileName  property of the reader, can be null
/// @param[in] read      called with a copy of the name, which observers cannot change
ReadOutcome ReadFile(const char* fileName, const std::function<void(const std::string&)>& read);
}

#endif
