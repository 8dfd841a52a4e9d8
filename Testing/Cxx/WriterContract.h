// Make a surface with all kinds of arrays, and check that writers keep them.
#ifndef WriterContract_h
#define WriterContract_h

#include "../CommaLocale.h"
#include "../TemporaryFolder.h"
#include "ReaderCheck.h"
#include "ReaderContract.h"

#include "vtkDoubleArray.h"
#include "vtkFloatArray.h"
#include "vtkSphereSource.h"
#include "vtkSurfaceFileWriter.h"
#include "vtkUnsignedCharArray.h"

namespace contract
{
template <typename Array>
vtkSmartPointer<Array> NumbersOf(const char* name, int components, vtkIdType tuples)
{
  auto array = vtkSmartPointer<Array>::New();
  array->SetName(name);
  array->SetNumberOfComponents(components);
  array->SetNumberOfTuples(tuples);
  for (vtkIdType i = 0; i < tuples; ++i)
  {
    for (int c = 0; c < components; ++c)
    {
      array->SetComponent(i, c, (i * components + c) % 251 / (c == 0 ? 1.0 : 3.0));
    }
  }
  return array;
}

/// Return a sphere of triangles with float points. The surface has normals, texture coordinates,
/// colors, a map to the sphere, and numbers.
inline vtkSmartPointer<vtkPolyData> RichSphere()
{
  vtkNew<vtkSphereSource> source;
  source->SetRadius(1.7);
  source->Update();
  vtkSmartPointer<vtkPolyData> sphere = source->GetOutput();
  const vtkIdType count = sphere->GetNumberOfPoints();
  vtkNew<vtkDoubleArray> map;
  map->SetName("SpherePosition");
  map->SetNumberOfComponents(3);
  for (vtkIdType i = 0; i < count; ++i)
  {
    const double* p = sphere->GetPoint(i);
    const double length = std::hypot(p[0], p[1], p[2]);
    map->InsertNextTuple3(p[0] / length, p[1] / length, p[2] / length);
  }
  vtkPointData* points = sphere->GetPointData();
  points->SetTCoords(NumbersOf<vtkFloatArray>("Texture Coordinates", 2, count));
  points->SetScalars(NumbersOf<vtkUnsignedCharArray>("Paint", 3, count));
  points->AddArray(map);
  points->AddArray(NumbersOf<vtkFloatArray>("Curvature", 1, count));
  sphere->GetCellData()->SetScalars(
    NumbersOf<vtkUnsignedCharArray>("Paint", 3, sphere->GetNumberOfCells()));
  return sphere;
}

inline void ExpectSameArray(vtkDataArray* a, vtkDataArray* b)
{
  ASSERT_TRUE(a && b);
  ASSERT_EQ(a->GetNumberOfTuples(), b->GetNumberOfTuples());
  ASSERT_EQ(a->GetNumberOfComponents(), b->GetNumberOfComponents());
  for (vtkIdType i = 0; i < a->GetNumberOfTuples(); ++i)
  {
    for (int c = 0; c < a->GetNumberOfComponents(); ++c)
    {
      ASSERT_EQ(a->GetComponent(i, c), b->GetComponent(i, c)) << i << " " << c;
    }
  }
}

inline void ExpectSamePoints(vtkPolyData* a, vtkPolyData* b)
{
  ExpectSameArray(a->GetPoints()->GetData(), b->GetPoints()->GetData());
}

inline void ExpectSamePolygons(vtkPolyData* a, vtkPolyData* b)
{
  ASSERT_EQ(a->GetNumberOfPolys(), b->GetNumberOfPolys());
  vtkNew<vtkIdList> ids;
  vtkNew<vtkIdList> others;
  for (vtkIdType cell = 0; cell < a->GetNumberOfPolys(); ++cell)
  {
    a->GetPolys()->GetCellAtId(cell, ids);
    b->GetPolys()->GetCellAtId(cell, others);
    ASSERT_EQ(std::vector<vtkIdType>(ids->begin(), ids->end()),
      std::vector<vtkIdType>(others->begin(), others->end()));
  }
}

/// Write a surface and read the file. The locale has a decimal comma.
template <typename Reader>
Reading WrittenAndRead(
  vtkSurfaceFileWriter* writer, vtkPolyData* surface, const TemporaryFolder& folder)
{
  const CommaLocale locale;
  const std::string path = folder.file("a surface");
  writer->SetInputData(surface);
  writer->SetFileName(path.c_str());
  EXPECT_EQ(writer->Write(), 1);
  EXPECT_EQ(writer->GetErrorCode(), static_cast<unsigned long>(vtkErrorCode::NoError));
  EXPECT_EQ(Reader::CanReadFile(path.c_str()), 1);
  EXPECT_EQ(folder.numberOfFiles(), 1u);
  return Read<Reader>(path);
}

/// Expect the same map to the sphere, within the rounding of floats. File formats of cortical
/// surfaces store the map as floats.
inline void ExpectSameSphere(vtkPolyData* read, vtkPolyData* written)
{
  ExpectSpherePosition(read);
  vtkDataArray* as = read->GetPointData()->GetArray("SpherePosition");
  vtkDataArray* was = written->GetPointData()->GetArray("SpherePosition");
  for (vtkIdType i = 0; i < was->GetNumberOfTuples(); ++i)
  {
    for (int c = 0; c < 3; ++c)
    {
      ASSERT_NEAR(as->GetComponent(i, c), was->GetComponent(i, c), 1e-7);
    }
  }
}
}

#endif
