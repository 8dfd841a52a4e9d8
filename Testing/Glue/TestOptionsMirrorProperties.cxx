// Options of the core and properties of the filters have the same defaults.
#include "Hull/GenusZeroHull.h"
#include "Learn/ConformalSOMOptions.h"
#include "Measure/SphericalAlignment.h"
#include "Measure/SurfaceMismatch.h"
#include "Measure/SurfaceShape.h"
#include "Mesh/GeodesicSphere.h"
#include "PLY/PLYParser.h"
#include "Page/SurfacePage.h"
#include "Register/ConsistentRemesh.h"
#include "Register/ShapeModes.h"
#include "Register/SphericalMorph.h"
#include "Register/SphericalRegistration.h"
#include "Register/SphericalResample.h"
#include "Register/SphericalTemplate.h"
#include "Repair/GenusZeroRepair.h"
#include "Sphere/AdaptiveSphere.h"
#include "SphereMap/GlobalConformalMap.h"
#include "StanfordScans/AlignedScans.h"
#include "Surface/CurvedSeamlessSurface.h"
#include "TextCloud/TextCloudParser.h"
#include "Texture/BodyCoordinates.h"
#include "Texture/MapImage.h"
#include "Texture/SphereViewChoice.h"
#include "Texture/SphericalTexture.h"
#include "Texture/SphericalTextureBlend.h"
#include "vtkAdaptiveSphere.h"
#include "vtkBodyMap.h"
#include "vtkBodyMapImage.h"
#include "vtkConformalPLYReader.h"
#include "vtkConformalSOM.h"
#include "vtkConsistentRemesh.h"
#include "vtkCurvedSeamlessSurface.h"
#include "vtkGenusZeroHull.h"
#include "vtkGenusZeroRepair.h"
#include "vtkGlobalConformalMap.h"
#include "vtkSphericalAlignment.h"
#include "vtkSphericalMorph.h"
#include "vtkSphericalRegistration.h"
#include "vtkSphericalResample.h"
#include "vtkSphericalTemplate.h"
#include "vtkSphericalTextureBlend.h"
#include "vtkSphericalTextureMap.h"
#include "vtkStanfordScansReader.h"
#include "vtkSurfaceMismatch.h"
#include "vtkSurfacePageWriter.h"
#include "vtkSurfaceShape.h"
#include "vtkTextCloudReader.h"

#include "vtkNew.h"

#include <gtest/gtest.h>

TEST(OptionsMirrorProperties, ConformalSOM)
{
  const conformal::ConformalSOMOptions options;
  vtkNew<vtkConformalSOM> filter;
  EXPECT_EQ(filter->GetMeshType(), static_cast<int>(options.MeshType));
  EXPECT_EQ(filter->GetNumberOfNeurons(), options.NumberOfNeurons);
  vtkNew<vtkConformalSOM> few;
  few->SetNumberOfNeurons(1);
  EXPECT_EQ(few->GetNumberOfNeurons(), conformal::MinimumNeurons);
  few->SetNumberOfNeurons(VTK_INT_MAX);
  EXPECT_LE(
    conformal::geodesicFrequencyFor(few->GetNumberOfNeurons()), conformal::MaximumFrequency);
  EXPECT_EQ(filter->GetTrainingMode(), static_cast<int>(options.TrainingMode));
  EXPECT_EQ(filter->GetRandomSeed(), static_cast<int>(options.RandomSeed));
  EXPECT_EQ(filter->GetReferencePoint(), static_cast<int>(options.ReferencePoint));
  EXPECT_EQ(filter->GetNumberOfEpochs(), options.Online.NumberOfEpochs);
  EXPECT_EQ(filter->GetSamplesPerEpoch(), options.Online.SamplesPerEpoch);
  EXPECT_EQ(filter->GetOnlineConstants()[0], options.Online.InitialNeighborhoodRadius);
  EXPECT_EQ(filter->GetOnlineConstants()[1], options.Online.NeighborhoodTimeConstant);
  EXPECT_EQ(filter->GetOnlineConstants()[2], options.Online.InitialLearningRate);
  EXPECT_EQ(filter->GetOnlineConstants()[3], options.Online.LearningRateTimeConstant);
  EXPECT_EQ(filter->GetFitIterations(), options.Fit.Iterations);
  EXPECT_EQ(filter->GetSmoothness(), options.Fit.Smoothness);
  EXPECT_EQ(filter->GetStartingShape(), static_cast<int>(options.StartingShape));
  EXPECT_EQ(filter->GetHullMethod(), static_cast<int>(options.HullMethod));
  using conformal::HullMethod;
  using conformal::MeshType;
  using conformal::ReferencePoint;
  using conformal::StartingShape;
  using conformal::TrainingMode;
  EXPECT_EQ(vtkConformalSOM::AUTOMATIC_MESH, static_cast<int>(MeshType::Automatic));
  EXPECT_EQ(vtkConformalSOM::GEODESIC, static_cast<int>(MeshType::Geodesic));
  EXPECT_EQ(vtkConformalSOM::ADAPTIVE, static_cast<int>(MeshType::Adaptive));
  EXPECT_EQ(vtkConformalSOM::BATCH, static_cast<int>(TrainingMode::Batch));
  EXPECT_EQ(vtkConformalSOM::ONLINE, static_cast<int>(TrainingMode::Online));
  EXPECT_EQ(vtkConformalSOM::AUTOMATIC_REFERENCE, static_cast<int>(ReferencePoint::Automatic));
  EXPECT_EQ(vtkConformalSOM::CONFORMAL, static_cast<int>(ReferencePoint::Conformal));
  EXPECT_EQ(vtkConformalSOM::WINNER, static_cast<int>(ReferencePoint::Winner));
  EXPECT_EQ(vtkConformalSOM::AFFINE, static_cast<int>(ReferencePoint::Affine));
  EXPECT_EQ(vtkConformalSOM::AUTOMATIC, static_cast<int>(StartingShape::Automatic));
  EXPECT_EQ(vtkConformalSOM::SPHERE, static_cast<int>(StartingShape::Sphere));
  EXPECT_EQ(vtkConformalSOM::HULL, static_cast<int>(StartingShape::Hull));
  EXPECT_EQ(vtkConformalSOM::MESH, static_cast<int>(StartingShape::Mesh));
  EXPECT_EQ(vtkConformalSOM::AUTOMATIC_METHOD, static_cast<int>(HullMethod::Automatic));
  EXPECT_EQ(vtkConformalSOM::DISTANCE, static_cast<int>(HullMethod::Distance));
  EXPECT_EQ(vtkConformalSOM::WINDING_NUMBERS, static_cast<int>(HullMethod::WindingNumbers));
}

TEST(OptionsMirrorProperties, AdaptiveSphere)
{
  const conformal::AdaptiveSphereOptions options;
  vtkNew<vtkAdaptiveSphere> filter;
  EXPECT_EQ(filter->GetNumberOfPoints(), options.NumberOfPoints);
  using Limits = conformal::AdaptiveSphereLimits;
  EXPECT_EQ(filter->GetNumberOfPointsMinValue(), Limits::MinimumPoints);
  EXPECT_EQ(filter->GetNumberOfPointsMaxValue(), Limits::MaximumPoints);
}

TEST(OptionsMirrorProperties, ConformalPLYReader)
{
  const conformal::PLYOptions options;
  vtkNew<vtkConformalPLYReader> reader;
  EXPECT_EQ(reader->GetMaximumEdgeLength(), options.MaximumEdgeLength);
}

TEST(OptionsMirrorProperties, ConsistentRemesh)
{
  const conformal::ConsistentRemeshOptions remesh;
  const conformal::ShapeModesOptions options;
  vtkNew<vtkConsistentRemesh> filter;
  EXPECT_EQ(filter->GetMeshType(), static_cast<int>(remesh.MeshType));
  EXPECT_EQ(filter->GetFrequency(), remesh.Frequency);
  EXPECT_EQ(filter->GetNumberOfPoints(), remesh.NumberOfPoints);
  EXPECT_EQ(filter->GetAlignment(), static_cast<int>(options.Alignment));
  EXPECT_EQ(filter->GetNumberOfModes(), options.NumberOfModes);
  EXPECT_LE(filter->GetFrequencyMaxValue(), conformal::MaximumFrequency);
  using Limits = conformal::AdaptiveSphereLimits;
  EXPECT_EQ(filter->GetNumberOfPointsMinValue(), Limits::MinimumPoints);
  EXPECT_EQ(filter->GetNumberOfPointsMaxValue(), Limits::MaximumPoints);
  using conformal::RemeshMeshType;
  using conformal::ShapeAlignment;
  EXPECT_EQ(vtkConsistentRemesh::GEODESIC, static_cast<int>(RemeshMeshType::Geodesic));
  EXPECT_EQ(vtkConsistentRemesh::ADAPTIVE, static_cast<int>(RemeshMeshType::Adaptive));
  EXPECT_EQ(vtkConsistentRemesh::NONE, static_cast<int>(ShapeAlignment::None));
  EXPECT_EQ(vtkConsistentRemesh::RIGID, static_cast<int>(ShapeAlignment::Rigid));
  EXPECT_EQ(vtkConsistentRemesh::SIMILARITY, static_cast<int>(ShapeAlignment::Similarity));
}

TEST(OptionsMirrorProperties, StanfordScansReader)
{
  const conformal::AlignedScansOptions options;
  vtkNew<vtkStanfordScansReader> reader;
  EXPECT_EQ(reader->GetInvertRotation(), options.InvertRotation);
  EXPECT_EQ(reader->GetAllowExternalFiles(), options.AllowExternalFiles);
  EXPECT_EQ(reader->GetRequireAllScans(), options.RequireAllScans);
}

TEST(OptionsMirrorProperties, TextCloudReader)
{
  const conformal::TextCloudOptions options;
  vtkNew<vtkTextCloudReader> reader;
  EXPECT_EQ(reader->GetDecimalComma(), options.DecimalComma);
  EXPECT_EQ(reader->GetSkipMalformedLines(), options.SkipMalformedLines);
}

TEST(OptionsMirrorProperties, CurvedSeamlessSurface)
{
  const conformal::CurvedSeamlessSurfaceOptions options;
  vtkNew<vtkCurvedSeamlessSurface> filter;
  EXPECT_EQ(filter->GetSeamMode(), static_cast<int>(options.SeamMode));
  EXPECT_EQ(filter->GetDomeHeight(), static_cast<int>(options.DomeHeight));
  EXPECT_EQ(filter->GetVertexShift(), -1.0); // that of the mesh
  EXPECT_EQ(filter->GetNumberOfFitRounds(), options.Fit.NumberOfFitRounds);
  EXPECT_EQ(filter->GetFitSmoothness(), options.Fit.FitSmoothness);
  using conformal::DomeHeight;
  using conformal::SeamMode;
  EXPECT_EQ(vtkCurvedSeamlessSurface::PER_TRIANGLE, static_cast<int>(SeamMode::PerTriangle));
  EXPECT_EQ(vtkCurvedSeamlessSurface::EDGE_MATCHED, static_cast<int>(SeamMode::EdgeMatched));
  EXPECT_EQ(vtkCurvedSeamlessSurface::NONE, static_cast<int>(DomeHeight::None));
  EXPECT_EQ(vtkCurvedSeamlessSurface::PUBLISHED, static_cast<int>(DomeHeight::Published));
  EXPECT_EQ(vtkCurvedSeamlessSurface::SCALED, static_cast<int>(DomeHeight::Scaled));
  EXPECT_EQ(vtkCurvedSeamlessSurface::CURVATURE, static_cast<int>(DomeHeight::Curvature));
  EXPECT_EQ(vtkCurvedSeamlessSurface::FITTED, static_cast<int>(DomeHeight::Fitted));
}

TEST(OptionsMirrorProperties, GenusZeroHull)
{
  const conformal::GenusZeroHullOptions options;
  vtkNew<vtkGenusZeroHull> filter;
  EXPECT_EQ(filter->GetMethod(), static_cast<int>(options.Method));
  EXPECT_EQ(vtkGenusZeroHull::DISTANCE, static_cast<int>(conformal::HullMethod::Distance));
  EXPECT_EQ(
    vtkGenusZeroHull::WINDING_NUMBERS, static_cast<int>(conformal::HullMethod::WindingNumbers));
  EXPECT_EQ(vtkGenusZeroHull::AUTOMATIC, static_cast<int>(conformal::HullMethod::Automatic));
  EXPECT_EQ(filter->GetSpacing(), options.Spacing);
  EXPECT_EQ(filter->GetOffset(), options.Offset);
  EXPECT_EQ(filter->GetPersistence(), options.Persistence);
  EXPECT_EQ(filter->GetSmoothingPasses(), options.SmoothingPasses);
  using Limits = conformal::GenusZeroHullLimits;
  EXPECT_DOUBLE_EQ(filter->GetSpacingMinValue(), Limits::MinimumSpacing);
  EXPECT_DOUBLE_EQ(filter->GetSpacingMaxValue(), Limits::MaximumSpacing);
  EXPECT_DOUBLE_EQ(filter->GetOffsetMinValue(), Limits::MinimumOffset);
  EXPECT_DOUBLE_EQ(filter->GetOffsetMaxValue(), Limits::MaximumOffset);
  EXPECT_DOUBLE_EQ(filter->GetPersistenceMinValue(), Limits::MinimumPersistence);
  EXPECT_DOUBLE_EQ(filter->GetPersistenceMaxValue(), Limits::MaximumPersistence);
  EXPECT_EQ(filter->GetSmoothingPassesMaxValue(), Limits::MaximumSmoothingPasses);
}

TEST(OptionsMirrorProperties, GenusZeroRepair)
{
  const conformal::GenusZeroRepairOptions options;
  vtkNew<vtkGenusZeroRepair> filter;
  EXPECT_EQ(filter->GetMaximumHoleArea(), options.MaximumHoleArea);
  using Type = conformal::RepairLoopType;
  EXPECT_EQ(vtkGenusZeroRepair::FILLED_HOLE, static_cast<int>(Type::FilledHole));
  EXPECT_EQ(vtkGenusZeroRepair::OPEN_HOLE, static_cast<int>(Type::OpenHole));
  EXPECT_EQ(vtkGenusZeroRepair::CUT_HANDLE, static_cast<int>(Type::CutHandle));
  EXPECT_EQ(vtkGenusZeroRepair::FILLED_TUNNEL, static_cast<int>(Type::FilledTunnel));
}

TEST(OptionsMirrorProperties, BodyMap)
{
  const conformal::BodyCoordinatesOptions options;
  vtkNew<vtkBodyMap> filter;
  EXPECT_EQ(conformal::Vector3(filter->GetCenter()), options.Center);
  EXPECT_EQ(conformal::Vector3(filter->GetRotationAxis()), options.RotationAxis);
  EXPECT_EQ(filter->GetUseMarkerPoint(), options.UseMarkerPoint);
  EXPECT_EQ(conformal::Vector3(filter->GetMarkerPoint()), options.MarkerPoint);
}

TEST(OptionsMirrorProperties, BodyMapImage)
{
  const conformal::MapImage image;
  vtkNew<vtkBodyMapImage> filter;
  EXPECT_EQ(filter->GetProjection(), static_cast<int>(image.Projection));
  EXPECT_EQ(filter->GetCentralLongitude(), image.CentralLongitude);
  using conformal::MapProjection;
  using Filter = vtkBodyMapImage;
  EXPECT_EQ(Filter::EQUIRECTANGULAR, static_cast<int>(MapProjection::Equirectangular));
  EXPECT_EQ(Filter::LAMBERT_AZIMUTHAL, static_cast<int>(MapProjection::LambertAzimuthal));
  EXPECT_EQ(Filter::MOLLWEIDE, static_cast<int>(MapProjection::Mollweide));
  EXPECT_EQ(Filter::PEIRCE_QUINCUNCIAL, static_cast<int>(MapProjection::PeirceQuincuncial));
}

TEST(OptionsMirrorProperties, GlobalConformalMap)
{
  const conformal::GlobalConformalMapOptions options;
  vtkNew<vtkGlobalConformalMap> filter;
  EXPECT_EQ(filter->GetMethod(), static_cast<int>(options.Method));
  EXPECT_EQ(filter->GetAreaBalance(), options.AreaBalance);
  EXPECT_EQ(filter->GetMaximumNumberOfIterations(), options.MaximumNumberOfIterations);
  EXPECT_EQ(filter->GetTolerance(), options.Tolerance);
  using conformal::GlobalConformalMethod;
  EXPECT_EQ(vtkGlobalConformalMap::ROBUST, static_cast<int>(GlobalConformalMethod::Robust));
  EXPECT_EQ(vtkGlobalConformalMap::GUYAU, static_cast<int>(GlobalConformalMethod::GuYau));
}

TEST(OptionsMirrorProperties, SphericalAlignment)
{
  using conformal::AlignmentKind;
  EXPECT_EQ(vtkSphericalAlignment::ROTATION, static_cast<int>(AlignmentKind::Rotation));
  EXPECT_EQ(vtkSphericalAlignment::MOEBIUS, static_cast<int>(AlignmentKind::Moebius));
}

TEST(OptionsMirrorProperties, SphericalMorph)
{
  const conformal::SphericalMorphOptions options;
  const conformal::ConsistentRemeshOptions remesh;
  vtkNew<vtkSphericalMorph> filter;
  EXPECT_EQ(filter->GetPath(), static_cast<int>(options.Path));
  EXPECT_EQ(filter->GetMeshType(), static_cast<int>(remesh.MeshType));
  EXPECT_EQ(filter->GetFrequency(), remesh.Frequency);
  EXPECT_EQ(filter->GetNumberOfPoints(), remesh.NumberOfPoints);
  EXPECT_LE(filter->GetFrequencyMaxValue(), conformal::MaximumFrequency);
  using Limits = conformal::AdaptiveSphereLimits;
  EXPECT_EQ(filter->GetNumberOfPointsMinValue(), Limits::MinimumPoints);
  EXPECT_EQ(filter->GetNumberOfPointsMaxValue(), Limits::MaximumPoints);
  using conformal::MorphPath;
  using conformal::RemeshMeshType;
  EXPECT_EQ(vtkSphericalMorph::LINEAR, static_cast<int>(MorphPath::Linear));
  EXPECT_EQ(vtkSphericalMorph::RIGID, static_cast<int>(MorphPath::Rigid));
  EXPECT_EQ(vtkSphericalMorph::GEODESIC, static_cast<int>(RemeshMeshType::Geodesic));
  EXPECT_EQ(vtkSphericalMorph::ADAPTIVE, static_cast<int>(RemeshMeshType::Adaptive));
}

TEST(OptionsMirrorProperties, SphericalRegistration)
{
  const conformal::SphericalRegistrationOptions options;
  vtkNew<vtkSphericalRegistration> filter;
  EXPECT_EQ(filter->GetSpaceOfTransforms(), static_cast<int>(options.Space));
  EXPECT_EQ(filter->GetShapeWeight(), options.ShapeWeight);
  EXPECT_EQ(filter->GetStretchWeight(), options.StretchWeight);
  EXPECT_EQ(filter->GetFrequency(), options.Frequency);
  using Filter = vtkSphericalRegistration;
  using conformal::SpaceOfTransforms;
  EXPECT_EQ(Filter::ROTATION, static_cast<int>(SpaceOfTransforms::Rotation));
  EXPECT_EQ(Filter::MOEBIUS, static_cast<int>(SpaceOfTransforms::Moebius));
  EXPECT_EQ(Filter::DIFFEOMORPHIC, static_cast<int>(SpaceOfTransforms::Diffeomorphic));
}

TEST(OptionsMirrorProperties, SphericalResample)
{
  const conformal::SphericalResampleOptions options;
  vtkNew<vtkSphericalResample> filter;
  EXPECT_EQ(filter->GetMethod(), static_cast<int>(options.Method));
  using conformal::ResampleMethod;
  EXPECT_EQ(vtkSphericalResample::BARYCENTRIC, static_cast<int>(ResampleMethod::Barycentric));
  EXPECT_EQ(vtkSphericalResample::AREA_ADAPTIVE, static_cast<int>(ResampleMethod::AreaAdaptive));
}

TEST(OptionsMirrorProperties, SphericalTemplate)
{
  const conformal::SphericalTemplateOptions options;
  vtkNew<vtkSphericalTemplate> filter;
  EXPECT_EQ(filter->GetMaximumNumberOfRounds(), options.MaximumNumberOfRounds);
  EXPECT_EQ(filter->GetTolerance(), options.Tolerance);
  EXPECT_EQ(filter->GetAlignment(), static_cast<int>(options.Alignment));
  EXPECT_EQ(filter->GetMeanFrequency(), options.MeanFrequency);
  EXPECT_EQ(filter->GetShapeWeight(), options.Registration.ShapeWeight);
  EXPECT_EQ(filter->GetStretchWeight(), options.Registration.StretchWeight);
  EXPECT_EQ(filter->GetFrequency(), options.Registration.Frequency);
  using conformal::ShapeAlignment;
  EXPECT_EQ(vtkSphericalTemplate::NONE, static_cast<int>(ShapeAlignment::None));
  EXPECT_EQ(vtkSphericalTemplate::RIGID, static_cast<int>(ShapeAlignment::Rigid));
  EXPECT_EQ(vtkSphericalTemplate::SIMILARITY, static_cast<int>(ShapeAlignment::Similarity));
}

TEST(OptionsMirrorProperties, SphericalTexture)
{
  const conformal::SphericalTextureOptions options;
  vtkNew<vtkSphericalTextureMap> filter;
  EXPECT_EQ(conformal::Vector3(filter->GetViewDirection()), options.ViewDirection);
  EXPECT_EQ(conformal::Vector3(filter->GetViewUp()), options.ViewUp);
  EXPECT_EQ(filter->GetUseViewPoint(), options.UseViewPoint);
  EXPECT_EQ(conformal::Vector3(filter->GetViewPoint()), options.ViewPoint);
  EXPECT_EQ(filter->GetProjection(), static_cast<int>(options.Projection));
  EXPECT_EQ(filter->GetFieldOfView(), options.FieldOfView);
  EXPECT_EQ(filter->GetRotation(), options.Rotation);
  EXPECT_EQ(conformal::Vector2(filter->GetScale()), options.Scale);
  EXPECT_EQ(filter->GetWrap(), static_cast<int>(options.Wrap));
  EXPECT_EQ(filter->GetSplitSeam(), options.SplitSeam);
  EXPECT_EQ(filter->GetMargin(), options.Margin);
  EXPECT_EQ(filter->GetMarginMaxValue(), conformal::MaximumMargin);
  using Filter = vtkSphericalTextureMap;
  using conformal::SphereProjection;
  EXPECT_EQ(Filter::STEREOGRAPHIC, static_cast<int>(SphereProjection::Stereographic));
  EXPECT_EQ(Filter::LONGITUDE_LATITUDE, static_cast<int>(SphereProjection::LongitudeLatitude));
  EXPECT_EQ(Filter::OCTAHEDRAL, static_cast<int>(SphereProjection::Octahedral));
  EXPECT_EQ(Filter::CUBE_MAP, static_cast<int>(SphereProjection::CubeMap));
  EXPECT_EQ(Filter::CLAMP, static_cast<int>(conformal::TextureWrap::Clamp));
  EXPECT_EQ(Filter::REPEAT, static_cast<int>(conformal::TextureWrap::Repeat));
  EXPECT_EQ(Filter::MIRROR, static_cast<int>(conformal::TextureWrap::Mirror));
  EXPECT_EQ(filter->GetFieldOfViewMinValue(), conformal::MinimumFieldOfView);
  EXPECT_EQ(filter->GetFieldOfViewMaxValue(), conformal::MaximumFieldOfView);
}

TEST(OptionsMirrorProperties, SurfaceMismatch)
{
  const conformal::SurfaceMismatchOptions options;
  vtkNew<vtkSurfaceMismatch> filter;
  EXPECT_EQ(filter->GetLengthUnit(), static_cast<int>(options.LengthUnit));
  EXPECT_EQ(filter->GetNumberOfSamples(), options.NumberOfSamples);
  EXPECT_EQ(filter->GetRandomSeed(), options.RandomSeed);
  using conformal::MismatchUnit;
  EXPECT_EQ(vtkSurfaceMismatch::MAX_RADIUS, static_cast<int>(MismatchUnit::MaxRadius));
  EXPECT_EQ(vtkSurfaceMismatch::HALF_DIAGONAL, static_cast<int>(MismatchUnit::HalfDiagonal));
  EXPECT_EQ(vtkSurfaceMismatch::NONE, static_cast<int>(MismatchUnit::None));
}

TEST(OptionsMirrorProperties, SurfacePageWriter)
{
  const conformal::SurfacePageOptions options;
  const conformal::SphereViewOptions view;
  vtkNew<vtkSurfacePageWriter> writer;
  EXPECT_EQ(writer->GetColorArrayName(), options.ColorArrayName);
  EXPECT_EQ(writer->GetRepeatTexture(), options.RepeatsTexture);
  EXPECT_EQ(conformal::Vector3(writer->GetViewDirection()), view.ViewDirection);
  EXPECT_EQ(conformal::Vector3(writer->GetViewUp()), view.ViewUp);
}

TEST(OptionsMirrorProperties, SurfaceShape)
{
  const conformal::SurfaceShapeOptions options;
  vtkNew<vtkSurfaceShape> filter;
  EXPECT_EQ(filter->GetCurvatureScale(), options.CurvatureScale);
  EXPECT_EQ(filter->GetDepthScale(), options.DepthScale);
}

TEST(OptionsMirrorProperties, SphericalTextureBlend)
{
  const conformal::TwoPictures options;
  vtkNew<vtkSphericalTextureBlend> filter;
  EXPECT_EQ(filter->GetBlendAngle(), options.BlendAngle);
  EXPECT_EQ(filter->GetFieldOfViewMaxValue(), conformal::MaximumFieldOfView);
}
