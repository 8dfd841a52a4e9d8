/**
 * @class   vtkMapOutlines
 * @brief   measure outlines that are drawn in a map, such as borders of cells, on the surface
 *
 * Measure lines and polygons that are drawn in a map on the body: true lengths, areas and angles.
 * The outlines are, for example, selections of ImageJ or Fiji in a map of vtkSurfaceLayers or
 * vtkBodyMapImage. Lengths, areas and angles in a map are distorted; the measures of this filter
 * are those of the surface.
 *
 * Input port 0: vtkPolyData, the surface of which the map was made, with the point array
 * "SpherePosition" (3 components). For a map of vtkSurfaceLayers, use its output port 0. Polygons
 * and strips are treated as triangles.
 *
 * Input port 1: vtkPolyData, the outlines: lines and polygons. The coordinates x and y of their
 * points are pixels of the map, see ImageSize and YAxis; z is not used. A line whose last point is
 * its first is a polygon. Vertices and strips are skipped. Sides are straight in the map.
 *
 * Output port 0: vtkPolyData, the outlines as lines on the surface. Sides of outlines have as many
 * points as they need to follow the surface.
 * - point array "Corner" (int): id of the point of input port 1; -1 between corners.
 * - point array "Angle" (double): angle between the two sides of a corner on the surface, in
 *   degrees: inside of polygons, in [0, 360], and of lines in [0, 180]; 0 between corners and at
 * the ends of lines.
 * - cell array "Outline" (int): id of the cell of input port 1.
 *
 * Output port 1: vtkTable, one row for each line and polygon, with columns
 * - "Outline" (int): id of the cell of input port 1,
 * - "OnMap" (int): 1 if the outline is on the map; otherwise 0, and its measures on the surface are
 *   0,
 * - "Closed" (int): 1 for polygons, 0 for lines,
 * - "Length" (double): length on the surface,
 * - "Area" (double): area of the surface that the map shows inside of a polygon; 0 for lines,
 * - "PictureLength" and "PictureArea" (double): length and area in the map, in pixels.
 *
 * An outline is not on the map if it leaves the map, crosses a hole of the map to the sphere, or
 * has fewer than two different corners. It is left out of port 0, and there is a warning. In maps
 * that show all longitudes (EQUIRECTANGULAR, MERCATOR, and the cylinder of CAPSULE), outlines may
 * continue beyond the left or right side: a polygon around a cell at the seam can be drawn in two
 * copies of the map side by side.
 *
 * Lines are traced over the triangles of the surface. Areas are sums over parts of triangles, which
 * are cut by the polygon. Areas do not depend on the orientation of a polygon. Parts around which a
 * polygon winds twice count twice.
 *
 * @sa
 * vtkMapLabels vtkSurfaceLayers vtkBodyMapImage
 */

#ifndef vtkMapOutlines_h
#define vtkMapOutlines_h

#include "vtkFiltersShapeModule.h" // for export macro
#include "vtkPolyDataAlgorithm.h"

class vtkAlgorithmOutput;
class vtkPolyData;
class vtkTable;

class VTKFILTERSSHAPE_EXPORT vtkMapOutlines : public vtkPolyDataAlgorithm
{
public:
  static vtkMapOutlines* New();
  vtkTypeMacro(vtkMapOutlines, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  enum Projections
  {
    EQUIRECTANGULAR = 0,
    LAMBERT_AZIMUTHAL = 1,
    MOLLWEIDE = 2,
    PEIRCE_QUINCUNCIAL = 3,
    MERCATOR = 4,
    CAPSULE = 5
  };

  enum YAxes
  {
    DOWN = 0,
    UP = 1
  };

  ///@{
  /**
   * Set the outlines: lines and polygons whose coordinates x and y are pixels of the map.
   */
  void SetOutlinesConnection(vtkAlgorithmOutput* algOutput);
  void SetOutlinesData(vtkPolyData* outlines);
  ///@}

  ///@{
  /**
   * Projection by which the map was made, see vtkBodyMapImage. It must be that of the map. Default
   * is EQUIRECTANGULAR.
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
   * Longitude of the meridian in the middle of the map, in degrees. It must be that of the map. In
   * [-360, 360]. Default is 0.
   */
  vtkSetClampMacro(CentralLongitude, double, -360.0, 360.0);
  vtkGetMacro(CentralLongitude, double);
  ///@}

  ///@{
  /**
   * Ratio of length to diameter of the capsule, for Projection CAPSULE. It must be that of the map,
   * whose field data "CapsuleAspect" has its value. With 0 (default), the aspect is found from the
   * surface. In [1, 25]; values below 1 select the aspect automatically.
   */
  vtkSetClampMacro(CapsuleAspect, double, 0.0, 25.0);
  vtkGetMacro(CapsuleAspect, double);
  ///@}

  ///@{
  /**
   * Width and height of the map in pixels. The corners of the map have the coordinates (0, 0) and
   * ImageSize, so that the middle of the first pixel is (0.5, 0.5). With (1, 1) and YAxis UP,
   * coordinates are texture coordinates. At least (1, 1). Default is (1000, 500).
   */
  vtkSetVector2Macro(ImageSize, int);
  vtkGetVector2Macro(ImageSize, int);
  ///@}

  ///@{
  /**
   * Direction of the y axis of the outlines. DOWN (default): y is 0 at the upper edge of the map,
   * as in ImageJ, for a map that vtkTIFFStackWriter has written with YAxis UP, or for a PNG file.
   * UP: y is 0 at the lower edge of the map, as in vtkImageData.
   */
  vtkSetClampMacro(YAxis, int, DOWN, UP);
  vtkGetMacro(YAxis, int);
  void SetYAxisToDown() { this->SetYAxis(DOWN); }
  void SetYAxisToUp() { this->SetYAxis(UP); }
  ///@}

  /**
   * Return the table of the measures, output port 1.
   */
  vtkTable* GetMeasures();

protected:
  vtkMapOutlines();
  ~vtkMapOutlines() override = default;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int FillOutputPortInformation(int port, vtkInformation* info) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

private:
  vtkMapOutlines(const vtkMapOutlines&) = delete;
  void operator=(const vtkMapOutlines&) = delete;

  int Projection = EQUIRECTANGULAR;
  double CentralLongitude = 0.0;
  double CapsuleAspect = 0.0;
  int ImageSize[2] = { 1000, 500 };
  int YAxis = DOWN;
};

#endif
