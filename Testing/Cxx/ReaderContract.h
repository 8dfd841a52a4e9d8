// Read a file with any reader of the module IO/Surface, and record the messages.
#ifndef ReaderContract_h
#define ReaderContract_h

#include "FilterContract.h"

#include "vtkErrorCode.h"
#include "vtkSmartPointer.h"
#include "vtkStringArray.h"
#include "vtkSurfaceFileReader.h"

#include <string>
#include <vector>

namespace contract
{
struct Reading
{
  Reading(vtkSmartPointer<vtkSurfaceFileReader> reader, const std::string& path)
    : Reader(reader)
    , Seen(reader)
  {
    this->Reader->SetFileName(path.c_str());
    this->Reader->Update();
    this->Output = this->Reader->GetOutput();
  }
  vtkSmartPointer<vtkSurfaceFileReader> Reader;
  Observed Seen;
  vtkPolyData* Output = nullptr;
};

template <typename Reader>
Reading Read(const std::string& path)
{
  return Reading(vtkSmartPointer<Reader>::New(), path);
}

inline std::vector<std::string> ReadFileNames(vtkSurfaceFileReader* reader)
{
  vtkStringArray* names = reader->GetReadFileNames();
  std::vector<std::string> result;
  for (vtkIdType i = 0; i < names->GetNumberOfValues(); ++i)
  {
    result.push_back(names->GetValue(i));
  }
  return result;
}

inline void ExpectRead(const Reading& reading)
{
  EXPECT_FALSE(reading.Seen.Error()) << reading.Seen.ErrorMessage();
  EXPECT_FALSE(reading.Seen.Warning()) << reading.Seen.WarningMessage();
  EXPECT_EQ(reading.Reader->GetErrorCode(), static_cast<unsigned long>(vtkErrorCode::NoError));
}

inline void ExpectRefused(const Reading& reading, unsigned long code, const std::string& part)
{
  EXPECT_EQ(reading.Reader->GetErrorCode(), code) << reading.Seen.ErrorMessage();
  EXPECT_TRUE(reading.Seen.Error());
  EXPECT_NE(reading.Seen.ErrorMessage().find(part), std::string::npos)
    << reading.Seen.ErrorMessage();
  EXPECT_EQ(reading.Output->GetNumberOfPoints(), 0);
  EXPECT_EQ(reading.Output->GetNumberOfCells(), 0);
}

inline void ExpectWarned(const Reading& reading, const char* array, vtkIdType count)
{
  EXPECT_FALSE(reading.Seen.Error());
  EXPECT_TRUE(reading.Seen.Warning());
  EXPECT_NE(
    reading.Seen.WarningMessage().find(" " + std::to_string(count) + " "), std::string::npos);
  ExpectArray(reading.Output->GetFieldData(), array, VTK_ID_TYPE, 1, 1);
  EXPECT_EQ(reading.Output->GetFieldData()->GetArray(array)->GetComponent(0, 0), count);
}
}

#endif
