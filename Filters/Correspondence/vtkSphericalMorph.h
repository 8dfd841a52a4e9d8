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
 * Input port 1 (optional): vtkPolyData or composite data, more surfaces. Those of both ports, one
 * after the other, are morphed: two or more. Each has
 * - point array "SpherePosition" (3 components, of any length but 0): where on the sphere the point
 *   lies. What lies at the same place corresponds (vtkSphericalAlignment). The map must cover the
 *   sphere exactly once; all maps must mirror their surfaces, or none.
 *
 * Output port 0: vtkPolyData, a closed triangle mesh: the points of all surfaces in the directions
 * of one mesh of the sphere, added up by their weights. With weight 1 of a surface it is that
 * surface in these directions. The same input gives the same bits on any number of threads.
 * - point array "SpherePosition" (double, 3 components): the directions, so that textures are laid
 *   and images baked as on the surfaces.
 * - every point array of numbers that all surfaces have by one name with equally many components:
 *   numbers are added up by the weights, so colors cross-fade; of labels (integers of 1 component)
 *   the one of the largest weight is taken. vtkSphericalResample says which arrays those are.
 *
 * Field data (double):
 * - "MorphWeights" (1 component, a value for each surface): the weights.
 *
 * With GenerateTimeSteps the filter is a source of time steps from 0 to 1, which are factors: an
 * animation plays the morph. What all factors have in common, the mesh of the sphere and the
 * surfaces in its directions, is kept between runs as long as the inputs stay.
 *
 * Implementation note: RIGID interpolates deformation gradients of triangles as
 * D. Xu, H. Zhang, Q. Wang, H. Bao, "Poisson shape interpolation", Graphical Models 68 (2006), and
 * follows rotations from triangle to triangle, so that a part may turn against the whole by more
 * than half a turn, though not by a whole one.
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
   * How far to go, in [0, 1]: 0 is the first surface, 1 the last; with more than two the morph
   * passes the others at equal steps. Default is 0.5.
   */
  vtkSetClampMacro(MorphFactor, double, 0.0, 1.0);
  vtkGetMacro(MorphFactor, double);
  ///@}

  ///@{
  /**
   * Weights instead of a factor, one for each surface in their order, at least 0 and not all 0;
   * they are divided by their sum. Default is none: MorphFactor counts.
   */
  void AddWeight(double weight);
  void RemoveAllWeights();
  int GetNumberOfWeights() { return static_cast<int>(this->Weights.size()); }
  ///@}

  ///@{
  /**
   * How points go. LINEAR (default): straight; what turns gets smaller on the way. RIGID: triangles
   * turn and stretch evenly and are put together again by one linear system; a limb that is turned
   * turns and keeps its size.
   */
  vtkSetClampMacro(Path, int, LINEAR, RIGID);
  vtkGetMacro(Path, int);
  void SetPathToLinear() { this->SetPath(LINEAR); }
  void SetPathToRigid() { this->SetPath(RIGID); }
  ///@}

  ///@{
  /**
   * The mesh of the sphere. ADAPTIVE (default): points lie evenly over the surfaces, as in
   * vtkAdaptiveSphere, dense where one of them asks for it. GEODESIC: evenly over the sphere.
   */
  vtkSetClampMacro(MeshType, int, GEODESIC, ADAPTIVE);
  vtkGetMacro(MeshType, int);
  void SetMeshTypeToGeodesic() { this->SetMeshType(GEODESIC); }
  void SetMeshTypeToAdaptive() { this->SetMeshType(ADAPTIVE); }
  ///@}

  ///@{
  /**
   * GEODESIC: f, for 10 f^2 + 2 points, in [1, 10000]. Default is 45: 20,252 points.
   */
  vtkSetClampMacro(Frequency, int, 1, 10000);
  vtkGetMacro(Frequency, int);
  ///@}

  ///@{
  /**
   * ADAPTIVE: number of points, met within 2 percent, in [500, 100000000]. Default is 20,000.
   */
  vtkSetClampMacro(NumberOfPoints, int, 500, 100000000);
  vtkGetMacro(NumberOfPoints, int);
  ///@}

  ///@{
  /**
   * Be a source of time steps: the time asked for, in [0, 1], is the factor instead of MorphFactor.
   * Default is off.
   */
  vtkSetMacro(GenerateTimeSteps, bool);
  vtkGetMacro(GenerateTimeSteps, bool);
  vtkBooleanMacro(GenerateTimeSteps, bool);
  ///@}

  ///@{
  /**
   * Number of time steps, at least 2. Default is 25.
   */
  vtkSetClampMacro(NumberOfTimeSteps, int, 2, 100000);
  vtkGetMacro(NumberOfTimeSteps, int);
  ///@}

  ///@{
  /**
   * The surface to morph to, or several as composite data, with the point array "SpherePosition".
   * Not needed if the input has several.
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
