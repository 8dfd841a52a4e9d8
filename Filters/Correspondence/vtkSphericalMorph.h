/**
 * @class   vtkSphericalMorph
 * @brief   morph between two or more mapped surfaces, as one surface or as time steps
 *
 * Compute a shape between two or more surfaces that are mapped to the sphere. The point array
 * "SpherePosition" is the position of each point on the sphere. Points with the same position
 * correspond. If the maps of the surfaces are not aligned, apply vtkSphericalAlignment first.
 * Colors and other point arrays that all surfaces have are blended. With GenerateTimeSteps, the
 * output has time steps, so that the morph can be played as an animation.
 *
 * Input port 0: vtkPolyData, the first surface, or composite data of several surfaces, with the
 * point array "SpherePosition". Polygons and strips are cut into triangles.
 *
 * Input port 1 (optional): vtkPolyData or composite data, more surfaces. The filter morphs the
 * surfaces of input port 0, followed by those of input port 1. At least two surfaces are required.
 * Each surface has
 * - point array "SpherePosition" (3 components, of any length but 0): position of the point on the
 *   sphere. Points with equal positions correspond. The map must cover the sphere exactly once.
 *   Either all maps reverse the orientation of the triangles, or no map does.
 *
 * Output port 0: vtkPolyData, the morphed surface, a closed triangle mesh. Positions on the unit
 * sphere are called directions. The points of one mesh of the sphere are the directions in which
 * all surfaces are sampled. The sample of a surface in a direction is the point of the surface that
 * is mapped to this direction. With Path LINEAR, a point of the output is the weighted sum of all
 * samples in one direction, after the surfaces are rotated to a common orientation. If one surface
 * has weight 1, the output consists of the samples of this surface. The output is equal bit by bit
 * for any number of threads.
 * - point array "SpherePosition" (double, 3 components): the directions. A texture that is an image
 *   of the sphere can be applied to the output, as to the input surfaces.
 * - every numeric point array that all surfaces have with the same name and number of components.
 *   Numbers are weighted sums, so that colors change gradually. Labels (integer arrays with 1
 *   component) are not mixed: a point gets the label of the largest total weight.
 *
 * Field data (double):
 * - "MorphWeights" (1 component, one value for each surface): the weights, whose sum is 1.
 *
 * If GenerateTimeSteps is on, the filter offers time steps from 0 to 1, and uses the requested time
 * as MorphFactor. An animation thus plays the morph. The filter keeps the samples of the surfaces
 * in memory until an input or a property of the mesh changes. After a change of MorphFactor, the
 * surfaces are not sampled again.
 *
 * Implementation note: Path RIGID interpolates deformation gradients (linear maps between
 * corresponding triangles) as in D. Xu, H. Zhang, Q. Wang, H. Bao, "Poisson shape interpolation",
 * Graphical Models 68 (2006). RIGID chooses similar rotations for neighboring triangles. The morph
 * is therefore correct even if a part rotates by more than 180 degrees relative to the whole
 * surface. The rotation must be less than 360 degrees.
 *
 * @sa
 * vtkSphericalAlignment vtkConsistentRemesh vtkSphericalResample vtkSphericalTextureMap
 */

#ifndef vtkSphericalMorph_h
#define vtkSphericalMorph_h

#include "vtkFiltersCorrespondenceModule.h" // for export macro
#include "vtkPolyDataAlgorithm.h"

#include <memory> // for std::shared_ptr
#include <vector> // for Weights

class vtkAlgorithmOutput;
class vtkDataObject;

class VTKFILTERSCORRESPONDENCE_EXPORT vtkSphericalMorph : public vtkPolyDataAlgorithm
{
public:
  static vtkSphericalMorph* New();
  vtkTypeMacro(vtkSphericalMorph, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  enum Paths
  {
    LINEAR = 0,
    RIGID = 1
  };

  enum MeshTypes
  {
    GEODESIC = 0,
    ADAPTIVE = 1
  };

  ///@{
  /**
   * Morph factor: 0 gives the first surface, and 1 the last surface. Further surfaces are at equal
   * steps between 0 and 1. In [0, 1]. Default is 0.5.
   */
  vtkSetClampMacro(MorphFactor, double, 0.0, 1.0);
  vtkGetMacro(MorphFactor, double);
  ///@}

  ///@{
  /**
   * Add the weight of the next surface. If there are weights, MorphFactor is not used. Add one
   * weight for each surface, in the sequence of the surfaces. Weights are at least 0, and not all
   * are 0. The filter divides all weights by their sum. Default is none: MorphFactor is used.
   */
  void AddWeight(double weight);
  void RemoveAllWeights();
  int GetNumberOfWeights() { return static_cast<int>(this->Weights.size()); }
  ///@}

  ///@{
  /**
   * Path of the points. LINEAR (default): the surface rotates as a whole, if the surfaces face
   * different ways. Relative to this rotation, points move along straight lines, so that parts that
   * rotate otherwise become smaller in the middle of the morph. RIGID: rotation and stretch of each
   * triangle are interpolated. A linear system then joins the triangles. Rotating parts thus keep
   * their size, and the area of the surface is the weighted mean of the areas.
   */
  vtkSetClampMacro(Path, int, LINEAR, RIGID);
  vtkGetMacro(Path, int);
  void SetPathToLinear() { this->SetPath(LINEAR); }
  void SetPathToRigid() { this->SetPath(RIGID); }
  ///@}

  ///@{
  /**
   * Type of the mesh. ADAPTIVE (default): sides of triangles have about equal lengths on the
   * surfaces, in the root mean square over all surfaces. On one surface, triangles are thin only
   * where its map differs from the maps of the other surfaces. GEODESIC: points are uniform over
   * the sphere.
   */
  vtkSetClampMacro(MeshType, int, GEODESIC, ADAPTIVE);
  vtkGetMacro(MeshType, int);
  void SetMeshTypeToGeodesic() { this->SetMeshType(GEODESIC); }
  void SetMeshTypeToAdaptive() { this->SetMeshType(ADAPTIVE); }
  ///@}

  ///@{
  /**
   * If MeshType is GEODESIC: frequency f of the geodesic sphere, a subdivided icosahedron
   * (vtkGeodesicSphereSource). The sphere has 10 f^2 + 2 points. In [1, 10000]. Default is 45:
   * 20,252 points.
   */
  vtkSetClampMacro(Frequency, int, 1, 10000);
  vtkGetMacro(Frequency, int);
  ///@}

  ///@{
  /**
   * Number of points of the mesh if MeshType is ADAPTIVE. The actual number differs by at most 2
   * percent. In [500, 100000000]. Default is 20,000.
   */
  vtkSetClampMacro(NumberOfPoints, int, 500, 100000000);
  vtkGetMacro(NumberOfPoints, int);
  ///@}

  ///@{
  /**
   * Whether the output has time steps. If on, the requested time, in [0, 1], replaces MorphFactor.
   * Default is off.
   */
  vtkSetMacro(GenerateTimeSteps, bool);
  vtkGetMacro(GenerateTimeSteps, bool);
  vtkBooleanMacro(GenerateTimeSteps, bool);
  ///@}

  ///@{
  /**
   * Number of time steps if GenerateTimeSteps is on. At least 2. Default is 25.
   */
  vtkSetClampMacro(NumberOfTimeSteps, int, 2, 100000);
  vtkGetMacro(NumberOfTimeSteps, int);
  ///@}

  ///@{
  /**
   * Set the last surface of the morph, or several surfaces as composite data, with the point array
   * "SpherePosition". Optional if the input has several surfaces.
   */
  void SetTargetConnection(vtkAlgorithmOutput* output);
  void SetTargetData(vtkDataObject* target);
  ///@}

protected:
  vtkSphericalMorph();
  ~vtkSphericalMorph() override;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestInformation(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

private:
  vtkSphericalMorph(const vtkSphericalMorph&) = delete;
  void operator=(const vtkSphericalMorph&) = delete;

  double FactorOf(vtkInformation* outputInformation) const;

  double MorphFactor = 0.5;
  std::vector<double> Weights;
  int Path = LINEAR;
  int MeshType = ADAPTIVE;
  int Frequency = 45;
  int NumberOfPoints = 20000;
  bool GenerateTimeSteps = false;
  int NumberOfTimeSteps = 25;

  struct Common;
  std::shared_ptr<const Common> Kept; ///< sampled inputs of the last run
};

#endif
