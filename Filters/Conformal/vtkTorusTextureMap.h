/**
 * @class   vtkTorusTextureMap
 * @brief   compute texture coordinates of a surface with one handle, for an image that is repeated
 *
 * Compute texture coordinates from the map of a surface of genus 1 to a flat torus. An image laid
 * on the surface is repeated along both periods of the torus, without a visible seam.
 *
 * Input port 0: vtkPolyData, a surface with the point array "TorusPosition" (2 components) of
 * vtkGlobalConformalMap. Polygons and strips are treated as triangles. Triangles must be smaller
 * than half of the torus, and together cover the torus once.
 *
 * Output port 0: vtkPolyData, the triangles of the input with the data of their points and cells.
 * Where triangles on both sides of an edge need different texture coordinates, the points of the
 * edge are duplicated. The points of the input come first, in the same sequence.
 * - active texture coordinates "Texture Coordinates" (float, 2 components): each unit of a
 * coordinate is one copy of the image. Repeat the image: use a vtkTexture with RepeatOn(), its
 * default. Coordinates are in about [-1, 2] times Repeats.
 * - point array "OriginalPointIds" (vtkIdType): id of the point in the input.
 * - cell array "OriginalCellIds" (vtkIdType): id of the input's cell of which the triangle is a
 * part.
 *
 * The image appears without shear if the real part of the field data "TorusModulus" is 0. Squares
 * of the image appear as squares if, in addition, the second number of Repeats is that of the first
 * times the imaginary part of the modulus.
 *
 * The method of this filter is an own construction of the project. Section 5 of C.-Y. Liou, Y.-T.
 * Kuo, J.-C. Huang, "Conformal self-organizing map on curved seamless surface", Neurocomputing 71
 * (2008), names surfaces of higher genus as further work.
 *
 * @sa
 * vtkGlobalConformalMap vtkSphericalTextureMap
 */

#ifndef vtkTorusTextureMap_h
#define vtkTorusTextureMap_h

#include "vtkFiltersConformalModule.h" // for export macro
#include "vtkPolyDataAlgorithm.h"

class VTKFILTERSCONFORMAL_EXPORT vtkTorusTextureMap : public vtkPolyDataAlgorithm
{
public:
  static vtkTorusTextureMap* New();
  vtkTypeMacro(vtkTorusTextureMap, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * Numbers of copies of the image along the first and second period of the torus. At least 1.
   * Default is (1, 1).
   */
  vtkSetVector2Macro(Repeats, int);
  vtkGetVector2Macro(Repeats, int);
  ///@}

protected:
  vtkTorusTextureMap() = default;
  ~vtkTorusTextureMap() override = default;

  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

private:
  vtkTorusTextureMap(const vtkTorusTextureMap&) = delete;
  void operator=(const vtkTorusTextureMap&) = delete;

  int Repeats[2] = { 1, 1 };
};

#endif
