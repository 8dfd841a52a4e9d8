#include "vtkSurfaceFileReader.h"

#include "../Cxx/FilterContract.h"
#include "../TemporaryFolder.h"
#include "Clouds.h"
#include "vtkConformalOFFReader.h"
#include "vtkConformalPLYReader.h"
#include "vtkConformalSOM.h"
#include "vtkPCDReader.h"
#include "vtkTextCloudReader.h"

#include "vtkErrorCode.h"
#include "vtkMultiProcessStream.h"

#include <optional>
#include <sstream>

namespace
{
// Files that the first rank writes for all.
class SharedFolder
{
public:
  SharedFolder()
  {
    if (clouds::Rank() == 0)
    {
      this->Folder.emplace();
      this->Prefix = this->Folder->file("");
    }
    vtkMultiProcessStream stream;
    stream << this->Prefix;
    clouds::Controller()->Broadcast(stream, 0);
    stream >> this->Prefix;
  }
  ~SharedFolder() { clouds::Controller()->Barrier(); }

  std::string write(const std::string& name, const std::string& bytes)
  {
    if (this->Folder)
    {
      this->Folder->write(name, bytes);
    }
    clouds::Controller()->Barrier();
    return this->Prefix + name;
  }

private:
  std::optional<TemporaryFolder> Folder;
  std::string Prefix;
};

constexpr vtkIdType Size = 3001;

std::string Text(vtkPolyData* cloud)
{
  std::ostringstream text;
  text.precision(17);
  for (vtkIdType i = 0; i < cloud->GetNumberOfPoints(); ++i)
  {
    const double* x = cloud->GetPoint(i);
    text << x[0] << " " << x[1] << " " << x[2] << " " << 1.0 + std::abs(x[2]) << "\n";
  }
  return text.str();
}

std::string Binary(vtkPolyData* cloud, const std::string& head)
{
  return head +
    std::string(static_cast<const char*>(cloud->GetPoints()->GetVoidPointer(0)),
      3 * sizeof(double) * cloud->GetNumberOfPoints());
}

// A little-endian machine's own doubles.
std::string PLY(vtkPolyData* cloud)
{
  return Binary(cloud,
    "ply\nformat binary_little_endian 1.0\nelement vertex " +
      std::to_string(cloud->GetNumberOfPoints()) +
      "\nproperty double x\nproperty double y\nproperty double z\nend_header\n");
}

std::string PCD(vtkPolyData* cloud)
{
  const std::string size = std::to_string(cloud->GetNumberOfPoints());
  return Binary(cloud,
    "VERSION .7\nFIELDS x y z\nSIZE 8 8 8\nTYPE F F F\nCOUNT 1 1 1\nWIDTH " + size +
      "\nHEIGHT 1\nPOINTS " + size + "\nDATA binary\n");
}

vtkSmartPointer<vtkConformalSOM> Learn(vtkAlgorithm* reader, const char* priority)
{
  auto filter = vtkSmartPointer<vtkConformalSOM>::New();
  filter->SetInputConnection(reader->GetOutputPort());
  filter->SetNumberOfNeurons(362);
  filter->SetStartingShapeToSphere();
  filter->SetPriorityArrayName(priority);
  return filter;
}

// Every rank reads some of the file, and together they learn what one that reads all learns.
template <typename Reader>
void ExpectSharedReading(const std::string& path, const char* priority, bool isCut)
{
  vtkNew<Reader> whole, own;
  whole->SetFileName(path.c_str());
  own->SetFileName(path.c_str());
  auto alone = Learn(whole, priority);
  alone->SetController(nullptr);
  alone->Update();
  EXPECT_EQ(whole->GetOutput()->GetNumberOfPoints(), Size);

  auto filter = Learn(own, priority);
  contract::Observed observed(own);
  filter->Update(); // asks for pieces by itself
  EXPECT_FALSE(observed.Error() || observed.Warning());
  const vtkIdType points = own->GetOutput()->GetNumberOfPoints();
  if (isCut)
  {
    EXPECT_NEAR(static_cast<double>(points), 1.0 * Size / clouds::NumberOfRanks(), 20.0);
    EXPECT_EQ(own->GetOutput()->GetNumberOfVerts(), points);
  }
  else
  {
    EXPECT_EQ(points, clouds::Rank() == 0 ? Size : 0);
  }
  clouds::ExpectOnFirstRank(filter->GetOutput(), alone->GetOutput());
}
}

TEST(SurfaceFileReader, RanksShareACloudAndLearnFromIt)
{
  auto cloud = clouds::Ellipsoid(Size);
  SharedFolder folder;
  ExpectSharedReading<vtkConformalPLYReader>(folder.write("a.ply", PLY(cloud)), nullptr, true);
  ExpectSharedReading<vtkPCDReader>(folder.write("a.pcd", PCD(cloud)), nullptr, true);
  ExpectSharedReading<vtkTextCloudReader>(
    folder.write("a.xyz", "x y z weight\n" + Text(cloud)), "weight", true);
  ExpectSharedReading<vtkTextCloudReader>(
    folder.write("a.pts", std::to_string(Size) + "\n" + Text(cloud)), "Intensity", false);
}

TEST(SurfaceFileReader, WhatCannotBeCutIsReadByTheFirstRank)
{
  SharedFolder folder;
  vtkNew<vtkConformalOFFReader> reader;
  reader->SetFileName(folder.write("a.off", "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n").c_str());
  reader->UpdatePiece(clouds::Rank(), clouds::NumberOfRanks(), 0);
  EXPECT_EQ(reader->GetOutput()->GetNumberOfPolys(), clouds::Rank() == 0 ? 1 : 0);
  EXPECT_EQ(reader->GetErrorCode(), static_cast<unsigned long>(vtkErrorCode::NoError));
}

TEST(SurfaceFileReader, AnErrorOfOneRankIsOneOfAll)
{
  SharedFolder folder;
  const std::string path = folder.write("a.xyz", Text(clouds::Ellipsoid(Size)) + "no point\n");
  vtkNew<vtkTextCloudReader> reader;
  reader->SetFileName(path.c_str());
  auto filter = Learn(reader, nullptr);
  contract::Observed observed(reader);
  filter->Update();
  EXPECT_TRUE(observed.Error());
  EXPECT_NE(observed.ErrorMessage().find("no point"), std::string::npos);
  if (clouds::NumberOfRanks() > 1)
  {
    const std::string last = std::to_string(clouds::NumberOfRanks() - 1);
    EXPECT_NE(observed.ErrorMessage().find("on process " + last + ": "), std::string::npos);
  }
  EXPECT_EQ(reader->GetErrorCode(), static_cast<unsigned long>(vtkErrorCode::FileFormatError));
  EXPECT_EQ(reader->GetOutput()->GetNumberOfPoints(), 0);

  vtkNew<vtkConformalPLYReader> missing;
  missing->SetFileName((path + " is not there").c_str());
  contract::Observed nothing(missing);
  Learn(missing, nullptr)->Update();
  EXPECT_TRUE(nothing.Error());
  EXPECT_EQ(missing->GetErrorCode(), static_cast<unsigned long>(vtkErrorCode::FileNotFoundError));
}

TEST(SurfaceFileReader, AbortOfOneRankLeavesNothingAnywhere)
{
  SharedFolder folder;
  vtkNew<vtkTextCloudReader> reader;
  reader->SetFileName(folder.write("a.xyz", Text(clouds::Ellipsoid(Size))).c_str());
  vtkNew<vtkCallbackCommand> stop;
  stop->SetCallback([](vtkObject* caller, unsigned long, void*, void*)
    { static_cast<vtkAlgorithm*>(caller)->SetAbortExecute(1); });
  if (clouds::Rank() == 0)
  {
    reader->AddObserver(vtkCommand::ProgressEvent, stop);
  }
  contract::Observed observed(reader);
  reader->UpdatePiece(clouds::Rank(), clouds::NumberOfRanks(), 0);
  EXPECT_FALSE(observed.Error());
  EXPECT_EQ(reader->GetOutput()->GetNumberOfPoints(), 0);
}
