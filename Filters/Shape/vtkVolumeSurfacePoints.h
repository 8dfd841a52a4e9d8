/**
 * @class   vtkVolumeSurfacePoints
 * @brief   sample the outer surface of an object in an image of three dimensions by points
 *
 * Find points and normals on the outside of an object in a volume, such as a stack of microscope
 * pictures of an embryo or an organoid. vtkConformalSOM learns a closed surface from the points.
 * The volume is smoothed, and a level separates the object from its background. Points are where
 * the values cross the level.
 *
 * Input port 0: vtkImageData, a volume of any size. Spacing, origin and direction of the image are
 * used.
 *
 * Output port 0: vtkPolyData, points with one vertex cell each. The points are the crossings of the
 * level with the edges between neighboring voxels, on average two or three for each square of the
 * size of a voxel.
 * - point array "Normals" (double, 3 components), the active normals: unit vectors to the outside,
 *   the direction in which the smoothed values decrease.
 * - field data "Level" (1 value): the level that separates the object from the background.
 * - field data "CutFraction" (1 value): fraction of the points at the border of the image, where
 *   the object is cut. Above 0.05, there is a warning.
 *
 * The object can be solid, or a shell, such as the layer of cells of an embryo. A ball of
 * ClosingRadius rolls over the object from the border of the image. What the ball cannot reach is
 * inside: cavities, and openings narrower than the ball. No points are there. Space beyond the
 * image is outside, so that an object that the image cuts is closed at the border.
 *
 * The level is by N. Otsu, "A threshold selection method from gray-level histograms", IEEE
 * Transactions on Systems, Man, and Cybernetics 9 (1979), Eqs. 18 and 19. Crossings are those of W.
 * E. Lorensen and H. E. Cline, "Marching cubes", SIGGRAPH 1987.
 *
 * vtkTIFFStackReader reads stacks that the programs ImageJ and Fiji have written.
 * vtkNIFTIImageReader and vtkMetaImageReader read other formats.
 *
 * Implementation note: vtkFlyingEdges3D would give the same points with triangles, but also those
 * of cavities, of openings and of the inner side of a shell.
 *
 * @sa
 * vtkConformalSOM vtkSurfaceLayers vtkTIFFStackReader vtkFlyingEdges3D
 */

#ifndef vtkVolumeSurfacePoints_h
#define vtkVolumeSurfacePoints_h

#include "vtkFiltersShapeModule.h" // for export macro
#include "vtkPolyDataAlgorithm.h"

#include <string> // for ArrayName

class VTKFILTERSSHAPE_EXPORT vtkVolumeSurfacePoints : public vtkPolyDataAlgorithm
{
public:
  static vtkVolumeSurfacePoints* New();
  vtkTypeMacro(vtkVolumeSurfacePoints, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /**
   * Methods to choose the level.
   */
  enum LevelMethods
  {
    OTSU = 0,
    FIXED = 1
  };

  ///@{
  /**
   * Name of the point array of the image. Empty (default) selects the active scalars.
   */
  vtkSetMacro(ArrayName, std::string);
  vtkGetMacro(ArrayName, std::string);
  ///@}

  ///@{
  /**
   * Component of the array, which is the channel of a stack with several channels. Choose a channel
   * that is bright all over the object. At least 0. Default is 0, the first.
   */
  vtkSetClampMacro(Component, int, 0, VTK_INT_MAX);
  vtkGetMacro(Component, int);
  ///@}

  ///@{
  /**
   * Standard deviation of the Gaussian by which the image is smoothed, in voxels. More smoothing
   * closes gaps between bright cells and removes noise, and rounds off details. In [0, 100].
   * Default is 1.5.
   */
  vtkSetClampMacro(Smoothing, double, 0.0, 100.0);
  vtkGetMacro(Smoothing, double);
  ///@}

  ///@{
  /**
   * Method to choose the level between object and background. OTSU (default): the level for which
   * the values on each side of it differ least. FIXED: the value of the property Level, if the
   * object fills a small part of the image, or if its parts differ in brightness.
   */
  vtkSetClampMacro(LevelMethod, int, OTSU, FIXED);
  vtkGetMacro(LevelMethod, int);
  void SetLevelMethodToOtsu() { this->SetLevelMethod(OTSU); }
  void SetLevelMethodToFixed() { this->SetLevelMethod(FIXED); }
  ///@}

  ///@{
  /**
   * Level if LevelMethod is FIXED: smoothed values above it belong to the object. The field data
   * "Level" of an earlier run is a good start. Default is 0.
   */
  vtkSetMacro(Level, double);
  vtkGetMacro(Level, double);
  ///@}

  ///@{
  /**
   * Radius of the ball that finds the outside, in voxels. Openings up to twice as wide are closed,
   * such as dark gaps between the cells of a shell. Folds that are narrower are closed, too. With
   * 0, only cavities without an opening are closed. In [0, 100]. Default is 2.
   */
  vtkSetClampMacro(ClosingRadius, double, 0.0, 100.0);
  vtkGetMacro(ClosingRadius, double);
  ///@}

  ///@{
  /**
   * Whether only the largest object is kept. Parts that are closer to each other than twice
   * ClosingRadius are one object. Default is on.
   */
  vtkSetMacro(LargestObject, bool);
  vtkGetMacro(LargestObject, bool);
  vtkBooleanMacro(LargestObject, bool);
  ///@}

protected:
  vtkVolumeSurfacePoints() = default;
  ~vtkVolumeSurfacePoints() override = default;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestUpdateExtent(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

private:
  vtkVolumeSurfacePoints(const vtkVolumeSurfacePoints&) = delete;
  void operator=(const vtkVolumeSurfacePoints&) = delete;

  std::string ArrayName;
  int Component = 0;
  double Smoothing = 1.5;
  int LevelMethod = OTSU;
  double Level = 0.0;
  double ClosingRadius = 2.0;
  bool LargestObject = true;
};

#endif
