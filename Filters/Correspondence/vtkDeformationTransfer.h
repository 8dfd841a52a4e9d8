/**
 * @class   vtkDeformationTransfer
 * @brief   deform a surface as another surface is deformed: transfer poses and facial expressions
 *
 * Deform one surface, the target, as another surface, the source, is deformed. The source is given
 * at rest, and in any number of poses: deformed shapes with the same points and polygons. The maps
 * to the sphere of both surfaces at rest must correspond, as after vtkSphericalRegistration: points
 * with the same position on the sphere correspond. Triangles of the target rotate and stretch like
 * the corresponding triangles of the source. Limbs of the target thus keep their own lengths and
 * widths, which is not the case if the displacements of the source are added to the target.
 *
 * Input port 0: vtkPolyData, the target at rest: the surface to deform. Source and target at rest
 * are closed, and should be in similar poses. Both have
 * - point array "SpherePosition" (3 components, of any length but 0): position of the point on the
 *   sphere. Points with equal positions correspond. The map must cover the sphere once without
 *   folds. Either both maps reflect their surfaces, or none does.
 *
 * Input port 1: vtkPolyData, the source at rest.
 *
 * Input port 2 (repeatable): vtkPolyData, the poses of the source. Either one input with time
 * steps, or separate inputs or blocks of composite data, one for each pose. Poses have the points
 * and cells of the source at rest, in the same order. They need no arrays. The output at the time
 * of a block that is a null pointer or empty is empty, with a warning.
 *
 * Output port 0: vtkPolyData with time steps, the deformed target: cells and arrays of the target,
 * without normals, with points in double precision. The pose is that of the requested time. Times
 * of separate inputs and of blocks are 0, 1, 2, and so on. Between two times, the output is that of
 * the earlier one. Poses vary continuously if those of the source do. Therefore,
 * vtkTemporalInterpolator can be applied to the output.
 * - field data "TransferResidual" (double, 1 value): root mean square over the area of the
 *   difference between the deformation gradients of target and source. A deformation gradient is a
 *   3 by 3 matrix, and that of a surface at rest is the identity. 0 if the target deforms exactly
 *   as the source. Poses of limbs give about 0.05 to 0.2. Larger values can indicate that the maps
 *   do not correspond, or that contacts contradict the pose.
 *
 * If AlignRotation is on, and the target at rest faces another way than the source, it deforms
 * along its own axes. Lengths by which the target moves as a whole are those of the source,
 * multiplied by the square root of the ratio of the areas at rest.
 *
 * The target is prepared once, and each pose is then computed fast. The output is equal bit by bit
 * for any number of threads.
 *
 * Implementation note: the method is that of R. W. Sumner, J. Popovic, "Deformation transfer for
 * triangle meshes", ACM Transactions on Graphics 23 (2004), Eq. 5. Instead of pairs of triangles
 * from a deformation of one surface to the other, triangles correspond by their maps to the sphere.
 * A target triangle gets the mean deformation gradient of the source triangles that cover it,
 * weighted by area. The sum over the triangles is also weighted by area, and is minimized by a
 * Poisson equation, as in M. Botsch, R. Sumner, M. Pauly, M. Gross, "Deformation transfer for
 * detail-preserving surface editing", Vision, Modeling and Visualization (2006). Contacts and
 * AlignRotation are not part of these methods.
 *
 * @sa
 * vtkSphericalRegistration vtkSphericalMorph vtkSphericalTimeSeries
 */

#ifndef vtkDeformationTransfer_h
#define vtkDeformationTransfer_h

#include "vtkFiltersCorrespondenceModule.h" // for export macro
#include "vtkPolyDataAlgorithm.h"

#include <memory> // for std::shared_ptr
#include <string> // for ContactArrayName
#include <vector> // for times

class vtkAlgorithmOutput;
class vtkDataObject;

class VTKFILTERSCORRESPONDENCE_EXPORT vtkDeformationTransfer : public vtkPolyDataAlgorithm
{
public:
  static vtkDeformationTransfer* New();
  vtkTypeMacro(vtkDeformationTransfer, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * Whether deformations are rotated as the target at rest is rotated relative to the source at
   * rest. Default is on. Turn it off if both surfaces face the same way in one coordinate system,
   * for example if both stand on the ground z = 0. The ground of the source is then exactly the
   * ground of the target.
   */
  vtkSetMacro(AlignRotation, bool);
  vtkGetMacro(AlignRotation, bool);
  vtkBooleanMacro(AlignRotation, bool);
  ///@}

  ///@{
  /**
   * Name of a point array of the target with 1 component that marks contacts, such as the soles of
   * the feet. Points with values other than 0 are contacts. A contact moves exactly as the
   * corresponding point of the source, scaled to the size of the target. Feet that stay on the
   * ground in the poses of the source thus stay there. Mark areas instead of single points. Default
   * is empty: no contacts.
   */
  vtkSetMacro(ContactArrayName, std::string);
  vtkGetMacro(ContactArrayName, std::string);
  ///@}

  ///@{
  /**
   * Set the source at rest, with the point array "SpherePosition".
   */
  void SetSourceConnection(vtkAlgorithmOutput* output);
  void SetSourceData(vtkPolyData* source);
  ///@}

  ///@{
  /**
   * Set the poses of the source: one input with time steps, composite data with a block for each
   * pose, or a single pose. Poses have the points and cells of the source at rest. More poses are
   * added by the methods whose names begin with Add.
   */
  void SetPoseConnection(vtkAlgorithmOutput* output);
  void SetPoseData(vtkDataObject* pose);
  void AddPoseConnection(vtkAlgorithmOutput* output);
  void AddPoseData(vtkDataObject* pose);
  void RemoveAllPoses();
  ///@}

protected:
  vtkDeformationTransfer();
  ~vtkDeformationTransfer() override;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestInformation(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;
  int RequestUpdateExtent(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

private:
  vtkDeformationTransfer(const vtkDeformationTransfer&) = delete;
  void operator=(const vtkDeformationTransfer&) = delete;

  bool AlignRotation = true;
  std::string ContactArrayName;

  struct Prepared;
  std::shared_ptr<const Prepared> Kept; ///< surfaces at rest of the last run
};

#endif
