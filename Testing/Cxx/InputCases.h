// Every filter and every writer with valid inputs on all ports, and ways to break an input.
#ifndef InputCases_h
#define InputCases_h

#include "vtkAdaptiveSphere.h"
#include "vtkBodyMap.h"
#include "vtkBodyMapImage.h"
#include "vtkConformalDistortion.h"
#include "vtkConformalOFFWriter.h"
#include "vtkConformalPLYWriter.h"
#include "vtkConformalSOM.h"
#include "vtkConsistentRemesh.h"
#include "vtkCurvedSeamlessSurface.h"
#include "vtkFreeSurferWriter.h"
#include "vtkGIFTIWriter.h"
#include "vtkGenusZeroCheck.h"
#include "vtkGenusZeroHull.h"
#include "vtkGenusZeroRepair.h"
#include "vtkGeodesicSphereSource.h"
#include "vtkGlobalConformalMap.h"
#include "vtkGuMeshWriter.h"
#include "vtkSPHARMSurfaceWriter.h"
#include "vtkSphericalAlignment.h"
#include "vtkSphericalMorph.h"
#include "vtkSphericalRegistration.h"
#include "vtkSphericalResample.h"
#include "vtkSphericalTemplate.h"
#include "vtkSphericalTextureBlend.h"
#include "vtkSphericalTextureImage.h"
#include "vtkSphericalTextureMap.h"
#include "vtkSurfaceHarmonics.h"
#include "vtkSurfaceMismatch.h"
#include "vtkSurfacePageWriter.h"
#include "vtkSurfaceShape.h"
#include "vtkTextCloudWriter.h"
#include "vtkTexturedSurfaceWriter.h"

#include "vtkBitArray.h"
#include "vtkCellData.h"
#include "vtkDataSet.h"
#include "vtkDataSetAttributes.h"
#include "vtkDoubleArray.h"
#include "vtkFloatArray.h"
#include "vtkImageData.h"
#include "vtkIntArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"
#include "vtkStringArray.h"
#include "vtkUnsignedCharArray.h"

#include <functional>
#include <string>
#include <vector>

namespace inputs
{
/// A sphere with its map, what a texture needs, normals, colors, and a number for each cell.
inline vtkSmartPointer<vtkDataSet> Surface()
{
  vtkNew<vtkGeodesicSphereSource> source;
  source->SetFrequency(4);
  vtkNew<vtkSphericalTextureMap> map;
  map->SetInputConnection(source->GetOutputPort());
  map->Update();
  const auto surface = vtkSmartPointer<vtkPolyData>::New();
  surface->DeepCopy(map->GetOutput());
  vtkNew<vtkUnsignedCharArray> colors;
  colors->SetName("Colors");
  colors->SetNumberOfComponents(3);
  colors->SetNumberOfTuples(surface->GetNumberOfPoints());
  colors->Fill(9.0);
  surface->GetPointData()->SetScalars(colors);
  vtkNew<vtkDoubleArray> numbers;
  numbers->SetName("Numbers");
  numbers->SetNumberOfTuples(surface->GetNumberOfCells());
  numbers->Fill(1.0);
  surface->GetCellData()->AddArray(numbers);
  return surface;
}

inline vtkSmartPointer<vtkDataSet> Picture()
{
  const auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(6, 4, 1);
  image->AllocateScalars(VTK_UNSIGNED_CHAR, 3);
  image->GetPointData()->GetScalars()->Fill(7.0);
  return image;
}

/// Longitudes and latitudes.
inline vtkSmartPointer<vtkDataSet> Places()
{
  const vtkSmartPointer<vtkDataSet> places = Surface();
  auto* points = vtkPolyData::SafeDownCast(places)->GetPoints();
  for (vtkIdType i = 0; i < points->GetNumberOfPoints(); ++i)
  {
    points->SetPoint(i, 2.0 * static_cast<double>(i), 80.0 - static_cast<double>(i), 0.0);
  }
  return places;
}

/// A set-up of an algorithm, and what its ports take.
struct Case
{
  std::string Name;
  std::function<vtkSmartPointer<vtkAlgorithm>()> Make;
  std::vector<std::function<vtkSmartPointer<vtkDataSet>()>> Ports;

  /// With valid inputs, but the one of a port replaced.
  vtkSmartPointer<vtkAlgorithm> With(int port, vtkDataObject* data) const
  {
    vtkSmartPointer<vtkAlgorithm> algorithm = this->Make();
    for (int i = 0; i < static_cast<int>(this->Ports.size()); ++i)
    {
      algorithm->SetInputDataObject(i, i == port ? data : this->Ports[i]());
    }
    return algorithm;
  }
};

template <typename Algorithm>
std::function<vtkSmartPointer<vtkAlgorithm>()> Maker(
  const std::function<void(Algorithm*)>& change = [](Algorithm*) {})
{
  return [change]() -> vtkSmartPointer<vtkAlgorithm>
  {
    const auto algorithm = vtkSmartPointer<Algorithm>::New();
    change(algorithm);
    return algorithm;
  };
}

/// Every class of Filters/Conformal that has inputs.
inline std::vector<Case> Filters()
{
  const auto& s = Surface;
  const auto& p = Picture;
  return {
    { "vtkAdaptiveSphere",
      Maker<vtkAdaptiveSphere>(
        [](vtkAdaptiveSphere* filter)
        {
          filter->SetNumberOfPoints(500);
          filter->SetDensityToImage();
        }),
      { s, p } },
    { "vtkBodyMap", Maker<vtkBodyMap>(), { s, Places } },
    { "vtkBodyMapImage",
      Maker<vtkBodyMapImage>([](vtkBodyMapImage* filter) { filter->SetImageSize(16, 8); }), { s } },
    { "vtkConformalDistortion", Maker<vtkConformalDistortion>(), { s } },
    { "vtkConformalSOM",
      Maker<vtkConformalSOM>([](vtkConformalSOM* filter) { filter->SetNumberOfNeurons(92); }),
      { s, s } },
    { "vtkConsistentRemesh",
      Maker<vtkConsistentRemesh>(
        [](vtkConsistentRemesh* filter) { filter->SetNumberOfPoints(500); }),
      { s } },
    { "vtkCurvedSeamlessSurface",
      Maker<vtkCurvedSeamlessSurface>(
        [](vtkCurvedSeamlessSurface* filter) { filter->SetDomeHeightToFitted(); }),
      { s, s, s } },
    { "vtkGenusZeroCheck", Maker<vtkGenusZeroCheck>(), { s } },
    { "vtkGenusZeroHull",
      Maker<vtkGenusZeroHull>([](vtkGenusZeroHull* filter) { filter->SetSpacing(0.2); }), { s } },
    { "vtkGenusZeroHull, winding numbers",
      Maker<vtkGenusZeroHull>(
        [](vtkGenusZeroHull* filter)
        {
          filter->SetMethodToWindingNumbers();
          filter->SetSpacing(0.2);
        }),
      { s } },
    { "vtkGenusZeroRepair", Maker<vtkGenusZeroRepair>(), { s } },
    { "vtkGlobalConformalMap", Maker<vtkGlobalConformalMap>(), { s } },
    { "vtkSphericalAlignment", Maker<vtkSphericalAlignment>(), { s, s } },
    { "vtkSphericalAlignment, landmarks",
      Maker<vtkSphericalAlignment>(
        [](vtkSphericalAlignment* filter)
        {
          for (const vtkIdType id : { 0, 40, 80, 120 })
          {
            filter->AddLandmark(id, id);
          }
        }),
      { s, s } },
    { "vtkSurfaceHarmonics",
      Maker<vtkSurfaceHarmonics>([](vtkSurfaceHarmonics* filter) { filter->SetDegree(5); }),
      { s } },
    { "vtkSphericalMorph",
      Maker<vtkSphericalMorph>([](vtkSphericalMorph* filter) { filter->SetNumberOfPoints(500); }),
      { s, s } },
    { "vtkSphericalRegistration",
      Maker<vtkSphericalRegistration>(
        [](vtkSphericalRegistration* filter) { filter->SetFrequency(8); }),
      { s, s } },
    { "vtkSphericalResample", Maker<vtkSphericalResample>(), { s, s } },
    { "vtkSphericalResample, barycentric",
      Maker<vtkSphericalResample>(
        [](vtkSphericalResample* filter) { filter->SetMethodToBarycentric(); }),
      { s, s } },
    { "vtkSphericalTemplate",
      Maker<vtkSphericalTemplate>(
        [](vtkSphericalTemplate* filter)
        {
          filter->SetMeanFrequency(8);
          filter->SetFrequency(8);
        }),
      { s } },
    { "vtkSphericalTextureBlend",
      Maker<vtkSphericalTextureBlend>(
        [](vtkSphericalTextureBlend* filter) { filter->SetImageSize(16, 8); }),
      { s, p, p } },
    { "vtkSphericalTextureImage",
      Maker<vtkSphericalTextureImage>(
        [](vtkSphericalTextureImage* filter) { filter->SetImageSize(16, 8); }),
      { s, s } },
    { "vtkSphericalTextureMap", Maker<vtkSphericalTextureMap>(), { s } },
    { "vtkSphericalTextureMap, SplitSeam",
      Maker<vtkSphericalTextureMap>([](vtkSphericalTextureMap* filter) { filter->SplitSeamOn(); }),
      { s } },
    { "vtkSurfaceMismatch", Maker<vtkSurfaceMismatch>(), { s, s } },
    { "vtkSurfaceShape", Maker<vtkSurfaceShape>(), { s } },
  };
}

/// Every writer of IO/Surface.
inline std::vector<Case> Writers()
{
  const auto& s = Surface;
  return {
    { "vtkConformalOFFWriter", Maker<vtkConformalOFFWriter>(), { s } },
    { "vtkConformalPLYWriter", Maker<vtkConformalPLYWriter>(), { s } },
    { "vtkFreeSurferWriter", Maker<vtkFreeSurferWriter>(), { s } },
    { "vtkGIFTIWriter", Maker<vtkGIFTIWriter>(), { s } },
    { "vtkGuMeshWriter", Maker<vtkGuMeshWriter>(), { s } },
    { "vtkSPHARMSurfaceWriter", Maker<vtkSPHARMSurfaceWriter>(), { s } },
    { "vtkSurfacePageWriter",
      Maker<vtkSurfacePageWriter>([](vtkSurfacePageWriter* writer)
        { writer->SetThreeJSFileName(CONFORMALSOM_THREE_STAND_IN); }),
      { s, Picture } },
    { "vtkTextCloudWriter", Maker<vtkTextCloudWriter>(), { s } },
    { "vtkTexturedSurfaceWriter", Maker<vtkTexturedSurfaceWriter>(), { s, Picture } },
  };
}

/// A way to break an input, and what the error must say of it.
struct Fault
{
  std::string Name, Message;
  std::function<void(vtkDataSet*)> Make;
};

inline vtkSmartPointer<vtkAbstractArray> Resized(
  vtkAbstractArray* array, const char* name, vtkIdType tuples)
{
  const auto resized = vtkSmartPointer<vtkAbstractArray>::Take(array->NewInstance());
  resized->SetName(name);
  resized->SetNumberOfComponents(array->GetNumberOfComponents());
  resized->SetNumberOfTuples(tuples);
  for (vtkIdType i = 0; i < tuples && array->GetNumberOfTuples() > 0; ++i)
  {
    resized->SetTuple(i, i % array->GetNumberOfTuples(), array);
  }
  return resized;
}

/// Arrays of 0, one too few and one too many tuples: those that filters read, those that they only
/// pass on, ghosts, arrays of no numbers; and ghost arrays of another type.
inline std::vector<Fault> ArrayFaults(vtkDataSet* data)
{
  std::vector<Fault> faults;
  const auto add = [&](bool ofCells, vtkAbstractArray* like, const char* name, bool isActive)
  {
    const vtkIdType size = ofCells ? data->GetNumberOfCells() : data->GetNumberOfPoints();
    const std::string thing = ofCells ? "cell" : "point";
    for (const vtkIdType tuples : { vtkIdType(0), size - 1, size + 1 })
    {
      const auto array = Resized(like, name, tuples);
      faults.push_back({ thing + " array " + name + " of " + std::to_string(tuples) + " tuples",
        "the " + thing + " array \"" + name + "\" has " + std::to_string(tuples) + " tuples for " +
          std::to_string(size) + " " + thing + "s",
        [=](vtkDataSet* broken)
        {
          vtkDataSetAttributes* attributes = ofCells
            ? static_cast<vtkDataSetAttributes*>(broken->GetCellData())
            : static_cast<vtkDataSetAttributes*>(broken->GetPointData());
          attributes->AddArray(array);
          if (isActive)
          {
            attributes->SetActiveScalars(name);
          }
        } });
    }
  };
  if (vtkDataArray* map = data->GetPointData()->GetArray("SpherePosition"))
  {
    add(false, map, "SpherePosition", false);
  }
  add(false, data->GetPointData()->GetScalars(), "Baked", true);
  const char* const ghosts = vtkDataSetAttributes::GhostArrayName();
  for (const bool ofCells : { false, true })
  {
    add(ofCells, vtkNew<vtkFloatArray>(), "Unrelated", false);
    add(ofCells, vtkNew<vtkStringArray>(), "Words", false);
    add(ofCells, vtkNew<vtkBitArray>(), "Bits", false);
    add(ofCells, vtkNew<vtkUnsignedCharArray>(), ghosts, false);
  }
  faults.push_back(
    { "ghosts of another type", "the point array \"vtkGhostType\" is a vtkIntArray of 1 component",
      [=](vtkDataSet* broken)
      {
        broken->GetPointData()->AddArray(
          Resized(vtkNew<vtkIntArray>(), ghosts, broken->GetNumberOfPoints()));
      } });
  return faults;
}
}

#endif
