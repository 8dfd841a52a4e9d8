/**
 * @class   vtkMapLabels
 * @brief   measure labels that are painted in a map, such as cells, on the surface
 *
 * Measure regions of a map on the body: their true areas, perimeters, centroids, elongations and
 * numbers of neighbors. The regions are labels, such as the cells of a tissue that another program
 * has segmented in a map of vtkSurfaceLayers or vtkBodyMapImage. Lengths and areas in a map are
 * distorted; the measures of this filter are those of the surface.
 *
 * Input port 0: vtkPolyData, the surface of which the map was made, with the point array
 * "SpherePosition" (3 components). For a map of vtkSurfaceLayers, use its output port 0. Polygons
 * and strips are treated as triangles.
 *
 * Input port 1: vtkImageData, the labels: whole numbers in the pixels of the map, which must fill
 * the image. The label 0 is the background. The array has one component; color pictures are
 * rejected. To read a TIFF file that vtkTIFFStackWriter has written with YAxis UP, use
 * vtkTIFFStackReader with UP.
 *
 * Output port 0: vtkPolyData, the surface with
 * - point array "Label" (int): label of the pixel that shows the point; 0 outside of the map.
 *
 * Output port 1: vtkTable, one row for each label, in ascending order, with columns
 * - "Label" and "NumberOfPixels" (int),
 * - "Area" (double): area of the label on the surface,
 * - "Perimeter" (double): length of its border on the surface,
 * - "CentroidX", "CentroidY" and "CentroidZ" (double): point of the surface closest to the mean of
 *   the positions,
 * - "Elongation" (double): ratio of the standard deviations of the positions along the long axis
 *   and the axis across, at least 1,
 * - "LongAxisX", "LongAxisY" and "LongAxisZ" (double): direction of the long axis, of length 1; its
 *   sign has no meaning,
 * - "NumberOfNeighbors" (int): number of other labels that touch the label, or are separated from
 *   it by a line of one background pixel.
 *
 * For the area, triangles of the surface are divided until each part is in one label or smaller
 * than an eighth of a pixel. Perimeters are by the Crofton formula with eight directions, which has
 * no bias from the steps of pixels (D. Legland, K. Kieu, M.-F. Devaux, "Computation of Minkowski
 * measures on 2D and 3D binary images", Image Analysis and Stereology 26 (2007)). The spacings and
 * angles of pixels are those on the surface. Near the poles of Mollweide and Mercator maps, errors
 * are up to 4 %; vtkMapOutlines is more accurate.
 *
 * @sa
 * vtkMapOutlines vtkSurfaceLayers vtkBodyMapImage vtkTIFFStackReader
 */

#ifndef vtkMapLabels_h
#define vtkMapLabels_h

#include "vtkFiltersShapeModule.h" // for export macro
#include "vtkPolyDataAlgorithm.h"

#include <string> // for ArrayName

class vtkAlgorithmOutput;
class vtkImageData;
class vtkTable;

class VTKFILTERSSHAPE_EXPORT vtkMapLabels : public vtkPolyDataAlgorithm
{
public:
  static vtkMapLabels* New();
  vtkTypeMacro(vtkMapLabels, vtkPolyDataAlgorithm);
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

  ///@{
  /**
   * Set the labels: an image of whole numbers that the map fills.
   */
  void SetLabelsConnection(vtkAlgorithmOutput* algOutput);
  void SetLabelsData(vtkImageData* labels);
  ///@}

  ///@{
  /**
   * Name of the point array of the labels. Empty (default) selects the active scalars.
   */
  vtkSetMacro(ArrayName, std::string);
  vtkGetMacro(ArrayName, std::string);
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

  /**
   * Return the table of the measures, output port 1.
   */
  vtkTable* GetMeasures();

protected:
  vtkMapLabels();
  ~vtkMapLabels() override = default;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int FillOutputPortInformation(int port, vtkInformation* info) override;
  int RequestUpdateExtent(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

private:
  vtkMapLabels(const vtkMapLabels&) = delete;
  void operator=(const vtkMapLabels&) = delete;

  std::string ArrayName;
  int Projection = EQUIRECTANGULAR;
  double CentralLongitude = 0.0;
  double CapsuleAspect = 0.0;
};

#endif
