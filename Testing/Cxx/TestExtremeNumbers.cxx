// Properties, vectors and pairs of inputs as large or as small as numbers can be: what comes out is
// finite, or an error and nothing.
#include "../Cases/Case.h"
#include "../Cases/Judge.h"
#include "FilterContract.h"
#include "MeshFixtures.h"
#include "vtkConformalSOM.h"
#include "vtkCurvedSeamlessSurface.h"
#include "vtkSphericalTextureMap.h"

#include "vtkDoubleArray.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkPoints.h"

#include <cmath>
#include <functional>
#include <limits>
#include <set>
#include <string>
#include <vector>

namespace
{
constexpr double Largest = std::numeric_limits<double>::max();

/// The filter's output is whole and finite, or empty after an error.
/// @return whether there was no error
bool ExpectFiniteOrError(vtkAlgorithm* filter)
{
  const cases::Messages messages;
  filter->Modified();
  filter->Update();
  const cases::Outcome outcome = cases::JudgeFilter(filter, messages, false);
  EXPECT_FALSE(cases::isBad(outcome.Verdict)) << outcome.Reason;
  return messages.errors() == 0;
}

void Multiply(vtkDataArray* vectors, double factor)
{
  for (vtkIdType i = 0; i < vectors->GetNumberOfTuples(); ++i)
  {
    double v[3];
    vectors->GetTuple(i, v);
    vectors->SetTuple3(i, factor * v[0], factor * v[1], factor * v[2]);
  }
}

vtkNew<vtkPolyData> Scaled(double scale, int frequency = 5)
{
  auto surface = fixtures::Ellipsoid(frequency);
  for (vtkIdType i = 0; i < surface->GetNumberOfPoints(); ++i)
  {
    double p[3];
    surface->GetPoint(i, p);
    surface->GetPoints()->SetPoint(i, scale * (p[0] - 10.0), scale * p[1], scale * p[2]);
  }
  return surface;
}

/// The doubles written into one array of a filter's output.
std::vector<double> Written(vtkFieldData* data, const char* name)
{
  std::vector<double> values;
  vtkDataArray* array = data->GetArray(name);
  for (vtkIdType i = 0; array && i < array->GetNumberOfTuples(); ++i)
  {
    for (int c = 0; c < array->GetNumberOfComponents(); ++c)
    {
      values.push_back(array->GetComponent(i, c));
    }
  }
  return values;
}

void ExpectNear(const std::vector<double>& a, const std::vector<double>& b, double tolerance)
{
  ASSERT_EQ(a.size(), b.size());
  ASSERT_FALSE(a.empty());
  for (std::size_t i = 0; i < a.size(); ++i)
  {
    ASSERT_NEAR(a[i], b[i], tolerance) << i;
  }
}

/// The values of an array of the first output or its first block, of points, cells or fields.
std::vector<double> ResultOf(vtkAlgorithm* filter, const std::string& name)
{
  vtkDataObject* output = filter->GetOutputDataObject(0);
  auto* blocks = vtkMultiBlockDataSet::SafeDownCast(output);
  vtkDataObject* data = blocks && blocks->GetNumberOfBlocks() > 0 ? blocks->GetBlock(0) : output;
  std::vector<double> values;
  for (const int kind : { vtkDataObject::POINT, vtkDataObject::CELL, vtkDataObject::FIELD })
  {
    vtkFieldData* fields = data->GetAttributesAsFieldData(kind);
    if (values.empty() && fields)
    {
      values = Written(fields, name.c_str());
    }
  }
  return values;
}

/// The first port on which a mode reads a map.
int PortOfMap(const cases::Mode& mode)
{
  int port = 0;
  while ((mode.Ports.at(port).Reads & cases::BadMap) == 0)
  {
    ++port;
  }
  return port;
}

using Visit = std::function<void(const cases::Case&, const cases::Mode&)>;

void ForEveryMode(const Visit& visit)
{
  for (const cases::Case& of : cases::All())
  {
    for (const cases::Mode& mode : of.Modes)
    {
      SCOPED_TRACE(of.name(mode));
      if (!of.isWriter())
      {
        visit(of, mode);
      }
    }
  }
}
}

TEST(ExtremeNumbers, AMapToTheSphereMayHaveVectorsOfAnyLength)
{
  std::set<std::string> tried;
  const auto check = [&](const cases::Case& of, const cases::Mode& mode)
  {
    if (mode.ResultOfMap.empty())
    {
      return;
    }
    tried.insert(of.Class);
    const auto resultWith = [&](double length, std::vector<double>* result)
    {
      const auto surface = cases::Ellipsoid();
      Multiply(surface->GetPointData()->GetArray("SpherePosition"), length);
      const auto filter = of.make(mode, PortOfMap(mode), surface);
      ASSERT_TRUE(ExpectFiniteOrError(filter));
      *result = ResultOf(filter, mode.ResultOfMap);
    };
    std::vector<double> expected, result;
    resultWith(1.0, &expected);
    for (const double length : { 1e-200, 1e-160, 0x1p-100, 0x1p100, 1e160, 1e200, Largest })
    {
      SCOPED_TRACE(length);
      resultWith(length, &result);
      ExpectNear(result, expected, 1e-9);
    }
    resultWith(1e-320, &result); // of few bits, but directions all the same
  };
  ForEveryMode(check);
  EXPECT_GE(tried.size(), 11u);
}

TEST(ExtremeNumbers, AViewMayBeGivenByVectorsOfAnyLength)
{
  vtkNew<vtkSphericalTextureMap> filter;
  filter->SetInputData(Scaled(1.0));
  filter->SetViewDirection(0.5, 0.25, 1.0);
  filter->SetViewUp(0.25, 1.0, 0.0);
  filter->Update();
  const std::vector<double> expected =
    Written(filter->GetOutput()->GetPointData(), "Texture Coordinates");
  for (const double length : { 0x1p-1070, 1e-320, 1e-200, 1e-160, 1e160, 1e200, Largest })
  {
    SCOPED_TRACE(length);
    filter->SetViewDirection(0.5 * length, 0.25 * length, length);
    filter->SetViewUp(0.25 * length, length, 0.0);
    ASSERT_TRUE(ExpectFiniteOrError(filter));
    ExpectNear(Written(filter->GetOutput()->GetPointData(), "Texture Coordinates"), expected, 1e-3);
  }
}

TEST(ExtremeNumbers, AViewPointMayBeAnywhere)
{
  vtkNew<vtkSphericalTextureMap> filter;
  filter->SetInputData(Scaled(1.0));
  filter->UseViewPointOn();
  for (const double unit : { 1.0, 1e-300, 1e300 })
  {
    filter->SetInputData(Scaled(unit));
    filter->SetViewPoint(1e6 * unit, 2e6 * unit, -1e6 * unit);
    ASSERT_TRUE(ExpectFiniteOrError(filter));
    const std::vector<double> expected =
      Written(filter->GetOutput()->GetPointData(), "Texture Coordinates");
    for (const double far : { 1e10, 1e100, 1e200, 0.25 * Largest })
    {
      SCOPED_TRACE(far);
      filter->SetViewPoint(std::min(far * unit, 0.25 * Largest),
        std::min(2.0 * far * unit, 0.5 * Largest), -std::min(far * unit, 0.25 * Largest));
      ASSERT_TRUE(ExpectFiniteOrError(filter));
      ExpectNear(
        Written(filter->GetOutput()->GetPointData(), "Texture Coordinates"), expected, 1e-3);
    }
    filter->SetViewPoint(Largest, -Largest, Largest);
    EXPECT_TRUE(ExpectFiniteOrError(filter));
    for (const double near : { 0.0, 5e-324, -1e-200, 1e-20 })
    {
      filter->SetViewPoint(near, 0.0, 0.0);
      EXPECT_TRUE(ExpectFiniteOrError(filter));
    }
  }
}

TEST(ExtremeNumbers, InputsMayDifferInUnit)
{
  const double scales[] = { 1e-320, 1e-300, 1e-170, 1e-20, 1.0, 1e20, 1e154, 1e200, 1e307 };
  ForEveryMode(
    [&](const cases::Case& of, const cases::Mode& mode)
    {
      for (const double first : mode.MixesUnits
          ? std::vector<double>(std::begin(scales), std::end(scales))
          : std::vector<double>())
      {
        for (const double second : scales)
        {
          SCOPED_TRACE(
            std::to_string(std::log10(first)) + ", " + std::to_string(std::log10(second)));
          const auto filter = of.make(mode, 0, cases::Ellipsoid(first, 3), second);
          const bool good = ExpectFiniteOrError(filter);
          EXPECT_TRUE(good || first != second || mode.WritesAreas || first < 1e-310);
        }
      }
    });
}

TEST(ExtremeNumbers, AMeshOfAnotherUnitIsNamed)
{
  vtkNew<vtkConformalSOM> learned;
  learned->SetNumberOfNeurons(92);
  learned->SetInputData(Scaled(1.0));
  vtkNew<vtkCurvedSeamlessSurface> fitted;
  fitted->SetDomeHeightToFitted();
  fitted->SetCloudData(Scaled(1.0));
  for (const double scale : { 1e-200, 1e-12, 1e12, 1e160, 1e300 })
  {
    SCOPED_TRACE(scale);
    fitted->SetInputData(Scaled(scale));
    const contract::Observed fit(fitted);
    fitted->Update();
    fit.ExpectError("the cloud must have about the size and position of the surface");
    if (scale > 1.0)
    {
      learned->SetStartData(Scaled(scale));
      const contract::Observed start(learned);
      learned->Update();
      start.ExpectError("move and scale it to them");
    }
  }
}

TEST(ExtremeNumbers, PropertiesMayBeAnyNumber)
{
  int runs = 0;
  ForEveryMode(
    [&](const cases::Case& of, const cases::Mode& mode)
    {
      for (const cases::Property& property : mode.Properties)
      {
        for (const auto& [text, set] : property.Values)
        {
          if (property.IsNumber && !mode.IsSlow)
          {
            SCOPED_TRACE(property.Name + " " + text);
            const auto filter = of.make(mode);
            set(filter);
            ExpectFiniteOrError(filter);
            ++runs;
          }
        }
      }
    });
  EXPECT_GT(runs, 1000);
}
