/**
 * @class   vtkSurfaceLayers
 * @brief   sample a volume in layers parallel to a surface, and unroll the layers to maps
 *
 * Sample an image of three dimensions in layers above and below a surface, such as the cell layers
 * of an embryo or an organoid. The layers become point arrays of the surface, and a stack of maps
 * (tissue cartography). Write the maps by vtkTIFFStackWriter for the programs ImageJ and Fiji.
 *
 * Input port 0: vtkPolyData, a closed surface with the point array "SpherePosition" (3 components).
 * The direction (0, 0, 1) is the north pole of maps. Polygons and strips are treated as triangles.
 *
 * Input port 1: vtkImageData, the volume, in the coordinates of the surface. Spacing, origin and
 * direction of the image are used. Values are interpolated between voxels by cubic convolution
 * (R. G. Keys, 1981), within the range of the image's values, and are 0 outside of the image.
 *
 * Output port 0: vtkPolyData, the surface with
 * - point array "Layers" (float, NumberOfLayers components): the values of each layer, the
 *   innermost first. The names of the components are the depths.
 * - point arrays "LayerMaximum" and "LayerMean" (double): largest value and mean over the layers in
 *   SummaryRange.
 * - point array "DepthOfMaximum" (double): depth of the largest value in SummaryRange, interpolated
 *   between layers; positive outward.
 * - point arrays "InwardLimit" and "OutwardLimit" (double): largest depths of the layers at each
 *   point. A layer beyond a limit has the value at the limit.
 * - field data "LayerDepths" (double, one value for each layer): depths of the layers.
 * - field data "LayerFaults" (1 value): number of triangles of layers that are inverted or cross
 *   another triangle of the layer. Unless the value is 0, there is a warning.
 * - point array "SpherePosition": as in the input if Axis is MAP_AXIS, otherwise rotated to
 *   the axis.
 *
 * Output port 1: vtkImageData, a stack of maps: NumberOfLayers slices of ImageSize pixels, in the
 * projections of vtkBodyMapImage. The scale is true on average: the coordinates of pixels are
 * those of a map of a sphere that has the area of the surface, in the unit of the surface. The z
 * coordinate of a slice is its depth.
 * - active scalars "Intensity" (float): value of the volume, sampled at the point of the layer that
 *   the pixel shows; 0 beyond the outline of the map.
 *
 * Output port 2: vtkImageData, one map of ImageSize pixels:
 * - active scalars "LayerMaximum", and the point array "LayerMean" (float).
 * - point array "DepthOfMaximum" (double), in the unit of the surface.
 * - point array "OutsideSurface" (unsigned char): 1 beyond the outline of the map, and where the
 *   map to the sphere has a hole; otherwise 0.
 * - point array "AreaScale" (double): the area of the surface that the pixel shows, over the mean;
 * 0 where there is no surface.
 * - field data "AreaScaleRange" (2 values, double): pixels below the first scale show 5 percent of
 *   the surface's area, and pixels above the second 5 percent.
 * - field data "CapsuleAspect" (double), only with Projection CAPSULE, also of output port 1: ratio
 *   of length to diameter of the capsule.
 *
 * The largest depth of a layer at a point is 0.9 radii of the largest ball that touches the surface
 * there and contains no other part of it (J. Ma, S. W. Bae, S. Choi, "3D medial axis point
 * approximation using nearest neighbors and the normal field", The Visual Computer 28 (2012)). In
 * folds and thin parts, layers thus end before they meet. See vtkBodyMapImage for the projections.
 *
 * @sa
 * vtkVolumeSurfacePoints vtkConformalSOM vtkBodyMap vtkTIFFStackWriter
 */

#ifndef vtkSurfaceLayers_h
#define vtkSurfaceLayers_h

#include "vtkFiltersShapeModule.h" // for export macro
#include "vtkPolyDataAlgorithm.h"

#include <string> // for ArrayName

class vtkAlgorithmOutput;
class vtkImageData;

class VTKFILTERSSHAPE_EXPORT vtkSurfaceLayers : public vtkPolyDataAlgorithm
{
public:
  static vtkSurfaceLayers* New();
  vtkTypeMacro(vtkSurfaceLayers, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  enum Axes
  {
    MAP_AXIS = 0,
    LONG_AXIS = 1,
    ENDS = 2
  };

  enum Projections
  {
    EQUIRECTANGULAR = 0,
    LAMBERT_AZIMUTHAL = 1,
    MOLLWEIDE = 2,
    PEIRCE_QUINCUNCIAL = 3,
    MERCATOR = 4,
    CAPSULE = 5
  };

  ///@{
  /**
   * Set the volume to sample: an image of three dimensions in the coordinates of the surface.
   */
  void SetVolumeConnection(vtkAlgorithmOutput* algOutput);
  void SetVolumeData(vtkImageData* volume);
  ///@}

  ///@{
  /**
   * Name of the point array of the volume. Empty (default) selects the active scalars.
   */
  vtkSetMacro(ArrayName, std::string);
  vtkGetMacro(ArrayName, std::string);
  ///@}

  ///@{
  /**
   * Component of the array, which is the channel of a stack with several channels. At least 0.
   * Default is 0, the first.
   */
  vtkSetClampMacro(Component, int, 0, VTK_INT_MAX);
  vtkGetMacro(Component, int);
  ///@}

  ///@{
  /**
   * Depths of the first and the last layer, in the unit of the coordinates. Negative depths are
   * inside of the surface. The first must be at most the last. With (0, 0), the default, the layers
   * reach from 4 voxels inside to 4 voxels outside.
   */
  vtkSetVector2Macro(DepthRange, double);
  vtkGetVector2Macro(DepthRange, double);
  ///@}

  ///@{
  /**
   * Number of layers, at equal distances in DepthRange. In [1, 1000]. Default is 17: two layers for
   * each voxel of the default range.
   */
  vtkSetClampMacro(NumberOfLayers, int, 1, 1000);
  vtkGetMacro(NumberOfLayers, int);
  ///@}

  ///@{
  /**
   * Range of depths over which maximum and mean are computed, in the unit of the coordinates. With
   * (0, 0), the default, all layers are used. At least one layer must be in the range.
   */
  vtkSetVector2Macro(SummaryRange, double);
  vtkGetVector2Macro(SummaryRange, double);
  ///@}

  ///@{
  /**
   * Axis of the maps, from the south pole to the north pole. MAP_AXIS (default): as the array
   * "SpherePosition" is, such as after vtkBodyMap. LONG_AXIS: the longest axis of inertia of the
   * body, such as the head-tail axis of an embryo. The ends of this axis are moved to the poles, as
   * by vtkBodyMap; the array "SpherePosition" of the output is changed accordingly. ENDS: the
   * two points that are farthest apart along the surface are moved to the poles. Use ENDS for bent
   * bodies, such as a gut, whose ends are not on a straight axis.
   */
  vtkSetClampMacro(Axis, int, MAP_AXIS, ENDS);
  vtkGetMacro(Axis, int);
  void SetAxisToMapAxis() { this->SetAxis(MAP_AXIS); }
  void SetAxisToLongAxis() { this->SetAxis(LONG_AXIS); }
  void SetAxisToEnds() { this->SetAxis(ENDS); }
  ///@}

  ///@{
  /**
   * Projection of the sphere to the maps, with the ratio of width to height. EQUIRECTANGULAR
   * (default): longitude and latitude, 2 : 1. LAMBERT_AZIMUTHAL: preserves areas of the sphere; the
   * northern hemisphere is left, and the southern is right, 2 : 1. MOLLWEIDE: preserves areas of
   * the sphere; an ellipse, 2 : 1. PEIRCE_QUINCUNCIAL: preserves angles, except at four points, 1 :
   * 1. MERCATOR: preserves angles, and ends at latitudes of 85.05 degrees, 1 : 1. CAPSULE: for long
   * bodies with Axis LONG_AXIS or ENDS; see CapsuleAspect. The map has square pixels, and is in the
   * middle of the picture.
   */
  vtkSetClampMacro(Projection, int, EQUIRECTANGULAR, CAPSULE);
  vtkGetMacro(Projection, int);
  void SetProjectionToEquirectangular() { this->SetProjection(EQUIRECTANGULAR); }
  void SetProjectionToLambertAzimuthal() { this->SetProjection(LAMBERT_AZIMUTHAL); }
  void SetProjectionToMollweide() { this->SetProjection(MOLLWEIDE); }
  void SetProjectionToPeirceQuincuncial() { this->SetProjection(PEIRCE_QUINCUNCIAL); }
  void SetProjectionToMercator() { this->SetProjection(MERCATOR); }
  void SetProjectionToCapsule() { this->SetProjection(CAPSULE); }
  ///@}

  ///@{
  /**
   * Longitude of the meridian in the middle of the maps, in degrees. In [-360, 360]. Default is 0.
   */
  vtkSetClampMacro(CentralLongitude, double, -360.0, 360.0);
  vtkGetMacro(CentralLongitude, double);
  ///@}

  ///@{
  /**
   * Ratio of length to diameter of the capsule, a cylinder with round ends, for Projection CAPSULE.
   * The sphere is mapped conformally to the capsule. The map shows the cylinder as a rectangle, and
   * the ends as disks above and below. On a body of this shape, pixels show equal areas. With 0
   * (default), the aspect is that with which areas differ least from those of the body; the field
   * data "CapsuleAspect" of the map is its value. Set the aspect to draw several bodies alike. In
   * [1, 25]; values below 1 select the aspect automatically.
   */
  vtkSetClampMacro(CapsuleAspect, double, 0.0, 25.0);
  vtkGetMacro(CapsuleAspect, double);
  ///@}

  ///@{
  /**
   * Width and height of the maps in pixels. At least (1, 1). The number of pixels of all layers
   * must fit into an int. Default is (1000, 500).
   */
  vtkSetVector2Macro(ImageSize, int);
  vtkGetVector2Macro(ImageSize, int);
  ///@}

protected:
  vtkSurfaceLayers();
  ~vtkSurfaceLayers() override = default;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int FillOutputPortInformation(int port, vtkInformation* info) override;
  int RequestInformation(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;
  int RequestUpdateExtent(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

private:
  vtkSurfaceLayers(const vtkSurfaceLayers&) = delete;
  void operator=(const vtkSurfaceLayers&) = delete;

  std::string ArrayName;
  int Component = 0;
  double DepthRange[2] = { 0.0, 0.0 };
  int NumberOfLayers = 17;
  double SummaryRange[2] = { 0.0, 0.0 };
  int Axis = MAP_AXIS;
  int Projection = EQUIRECTANGULAR;
  double CentralLongitude = 0.0;
  double CapsuleAspect = 0.0;
  int ImageSize[2] = { 1000, 500 };
};

#endif
