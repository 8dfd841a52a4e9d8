/**
 * @class   vtkSphericalMorph
 * @brief   morph mapped surfaces: any shape between two or more, also as time steps
 *
 * Morph surfaces with the point array "SpherePosition": points at the same position of the sphere
 * correspond, as after vtkSphericalAlignment. Colors and other point arrays that all surfaces have
 * are blended. With GenerateTimeSteps the time slider plays the morph.
 *
 * Input port 0: vtkPolyData, the first surface, or composite data of several, with the point array
 * "SpherePosition". Polygons and strips are cut into triangles.
 *
 * Input port 1 (optional): vtkPolyData or composite data, more surfaces. The surfaces of both
 * ports, in this order, are morphed; at least two are needed. Each surface has
 * - point array "SpherePosition" (3 components, of any length but 0): position of the point on the
 *   sphere. Equal positions correspond (vtkSphericalAlignment). The map must cover the sphere
 *   exactly once. Either all maps mirror their surfaces, or none.
 *
 * Output port 0: vtkPolyData, a closed triangle mesh: the weighted sum of the points of all
 * surfaces in the directions of one mesh of the sphere. If one surface has weight 1, the output is
 * that surface in these directions. The same input gives the same bits on any number of threads.
 * - point array "SpherePosition" (double, 3 components): the directions, for textures and baked
 *   images as on the surfaces.
 * - every numeric point array that all surfaces have with the same name and number of components.
 *   Numbers are weighted sums, so colors cross-fade. Labels (integers of 1 component) are those of
 *   the largest weight. vtkSphericalResample describes which arrays are labels.
 *
 * Field data (double):
 * - "MorphWeights" (1 component, a value for each surface): the weights.
 *
 * With GenerateTimeSteps the filter is a source of time steps from 0 to 1, which are factors, so
 * that an animation plays the morph. The mesh of the sphere and the surfaces in its directions do
 * not depend on the factor. They are kept between runs until the inputs change.
 *
 * Implementation note: RIGID interpolates deformation gradients of triangles as in D. Xu, H. Zhang,
 * Q. Wang, H. Bao, "Poisson shape interpolation", Graphical Models 68 (2006). It propagates
 * rotations from triangle to triangle. A part may rotate against the whole by more than half a
 * turn, but by less than a whole turn.
 *
 * @sa
 * vtkSphericalAlignment vtkConsistentRemesh vtkSphericalResample vtkSphericalTextureMap
 */

#ifndef vtkSphericalMorph_h
#define vtkSphericalMorph_h

#include "vtkFiltersCorrespondenceModule.h" // for export macro
#include "vtkPolyDataAlgorithm.h"

#include <memory> // for what is kept
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
   * Morph factor: 0 gives the first surface, 1 the last. With more than two surfaces, the others
   * lie at equal steps in between. In [0, 1]. Default is 0.5.
   */
  vtkSetClampMacro(MorphFactor, double, 0.0, 1.0);
  vtkGetMacro(MorphFactor, double);
  ///@}

  ///@{
  /**
   * Add a weight, in place of the factor: one for each surface, in their order. Weights are at
   * least 0 and not all 0; they are divided by their sum. Default is none: MorphFactor is used.
   */
  void AddWeight(double weight);
  void RemoveAllWeights();
  int GetNumberOfWeights() { return static_cast<int>(this->Weights.size()); }
  ///@}

  ///@{
  /**
   * Path of the points. LINEAR (default): straight lines, on which rotating parts shrink. RIGID:
   * triangles rotate and stretch evenly, and one linear system joins them again; a rotating limb
   * keeps its size.
   */
  vtkSetClampMacro(Path, int, LINEAR, RIGID);
  vtkGetMacro(Path, int);
  void SetPathToLinear() { this->SetPath(LINEAR); }
  void SetPathToRigid() { this->SetPath(RIGID); }
  ///@}

  ///@{
  /**
   * Type of the mesh of the sphere. ADAPTIVE (default): points are uniform over the surfaces, as in
   * vtkAdaptiveSphere, and dense where any surface needs it. GEODESIC: points are uniform over the
   * sphere.
   */
  vtkSetClampMacro(MeshType, int, GEODESIC, ADAPTIVE);
  vtkGetMacro(MeshType, int);
  void SetMeshTypeToGeodesic() { this->SetMeshType(GEODESIC); }
  void SetMeshTypeToAdaptive() { this->SetMeshType(ADAPTIVE); }
  ///@}

  ///@{
  /**
   * GEODESIC: frequency f, for 10 f^2 + 2 points. In [1, 10000]. Default is 45: 20,252 points.
   */
  vtkSetClampMacro(Frequency, int, 1, 10000);
  vtkGetMacro(Frequency, int);
  ///@}

  ///@{
  /**
   * ADAPTIVE: number of points, reached within 2 percent. In [500, 100000000]. Default is 20,000.
   */
  vtkSetClampMacro(NumberOfPoints, int, 500, 100000000);
  vtkGetMacro(NumberOfPoints, int);
  ///@}

  ///@{
  /**
   * Whether to be a source of time steps: the requested time, in [0, 1], replaces MorphFactor.
   * Default is off.
   */
  vtkSetMacro(GenerateTimeSteps, bool);
  vtkGetMacro(GenerateTimeSteps, bool);
  vtkBooleanMacro(GenerateTimeSteps, bool);
  ///@}

  ///@{
  /**
   * Number of time steps. At least 2. Default is 25.
   */
  vtkSetClampMacro(NumberOfTimeSteps, int, 2, 100000);
  vtkGetMacro(NumberOfTimeSteps, int);
  ///@}

  ///@{
  /**
   * The surface to morph to, or several as composite data, with the point array "SpherePosition".
   * Optional if the input has several surfaces.
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
  std::shared_ptr<const Common> Kept; ///< of the inputs of the last run
};

#endif
