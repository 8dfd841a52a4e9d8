#include "Glue/CloudNormals.h"

#include "Base/Reduce.h"
#include "Glue/Points.h"
#include "vtkGeodesicSphereSource.h"

#include "vtkNew.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"

#include <gtest/gtest.h>

#include <limits>

// A corner without a position must not bend the normals of its neighbors.
TEST(CloudNormals, IgnoreTrianglesWithAPointThatIsNotFinite)
{
  vtkNew<vtkGeodesicSphereSource> source;
  source->SetFrequency(4);
  source->Update();
  vtkNew<vtkPolyData> surface;
  surface->DeepCopy(source->GetOutput());
  vtkNew<vtkPoints> points;
  points->DeepCopy(surface->GetPoints());
  points->SetPoint(20, std::numeric_limits<double>::quiet_NaN(), 0.0, 0.0);
  surface->SetPoints(points);
  glue::CloudNormals normals;
  glue::FindNormals(surface, glue::FrameOf({ surface }), {}, true, normals);
  ASSERT_TRUE(normals.Known);
  for (vtkIdType i = 0; i < surface->GetNumberOfPoints(); ++i)
  {
    const conformal::Vector3 x(points->GetPoint(i));
    if (x.allFinite())
    {
      EXPECT_GT(normals.View[i].normalized().dot(x.normalized()), 0.97) << i;
    }
  }
}
