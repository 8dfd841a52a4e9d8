#include "Glue/FileErrors.h"

#include "vtkErrorCode.h"

#include <exception>

namespace glue
{
//------------------------------------------------------------------------------
unsigned long ErrorCodeOf(conformal::ParseCode code)
{
  switch (code)
  {
    case conformal::ParseCode::Ok:
    case conformal::ParseCode::Aborted:
      return vtkErrorCode::NoError;
    case conformal::ParseCode::FileNotFound:
      return vtkErrorCode::FileNotFoundError;
    case conformal::ParseCode::CannotOpen:
      return vtkErrorCode::CannotOpenFileError;
    case conformal::ParseCode::UnrecognizedType:
      return vtkErrorCode::UnrecognizedFileTypeError;
    case conformal::ParseCode::PrematureEnd:
      return vtkErrorCode::PrematureEndOfFileError;
    case conformal::ParseCode::Malformed:
      return vtkErrorCode::FileFormatError;
    case conformal::ParseCode::OutOfMemory:
      break;
  }
  return vtkErrorCode::UnknownError;
}

//------------------------------------------------------------------------------
unsigned long ErrorCodeOf(conformal::WriteCode code)
{
  switch (code)
  {
    case conformal::WriteCode::Ok:
      return vtkErrorCode::NoError;
    case conformal::WriteCode::InvalidName:
      return vtkErrorCode::UserError;
    case conformal::WriteCode::OutOfDiskSpace:
      return vtkErrorCode::OutOfDiskSpaceError;
    case conformal::WriteCode::CannotOpen:
      break;
  }
  return vtkErrorCode::CannotOpenFileError;
}

//------------------------------------------------------------------------------
ReadOutcome ReadFile(const char* fileName, const std::function<void(const std::string&)>& read)
{
  if (!fileName || !fileName[0])
  {
    return { vtkErrorCode::NoFileNameError, "FileName is not set" };
  }
  const std::string name = fileName;
  try
  {
    read(name);
    return {};
  }
  catch (const conformal::ParseError& error)
  {
    const bool isAborted = error.status().Code == conformal::ParseCode::Aborted;
    return { ErrorCodeOf(error.status().Code),
      isAborted ? "" : name + ": " + error.status().text() };
  }
  catch (const std::exception& error)
  {
    return { vtkErrorCode::UserError, name + ": " + error.what() };
  }
}
}
