/**
 * @class   vtkSphericalSOM
 * @brief   learn a map of the rows of a table on the sphere (self-organizing map, SOM)
 *
 * Learn a self-organizing map of a table with any number of columns, such as measurements of
 * objects. Each row of the table is assigned to a point of a sphere, called neuron. Similar rows
 * are assigned to the same neuron or to neighbors. The map has no border, unlike maps on planar
 * grids.
 *
 * Input port 0: vtkTable, a row for each object. Columns of numbers with 1 component are learned,
 * see AddColumn(). Rows with a number that is not finite are left out with a warning.
 *
 * Output port 0: vtkPolyData, the neurons and triangles of a geodesic sphere (a subdivided
 * icosahedron) of radius 1, with 10 f^2 + 2 points. The integer f is chosen so that the number of
 * points is nearest to NumberOfNeurons.
 * - point array "SpherePosition" (double, 3 components): the points, as in mapped surfaces.
 * - a point array (double, 1 component) for each column that is learned, with the name of the
 *   column: weight vectors of the neurons, in the unit of the column.
 * - point array "HitCount" (int, 1 component): number of rows that are assigned to the neuron.
 * - point array "UMatrix" (double, 1 component): mean distance between the weight vectors of the
 *   neuron and its neighbors. Ridges of this array separate clusters of rows.
 * - a point array with the name and type of LabelColumn: label of the neuron, the most frequent
 *   label of its rows. A neuron without rows has the label of the row that is closest to its weight
 *   vector.
 * - field data "QuantizationError" (1 value): mean distance between the rows and the weight vectors
 *   of their neurons.
 * - field data "TopographicError" (1 value): fraction of the rows whose closest and second closest
 *   neurons are no neighbors on the sphere. The value is 0 if the map is continuous.
 *
 * Output port 1: vtkTable, the input with the columns
 * - "Winner" (idtype): id of the neuron of the row, the one with the closest weight vector.
 * - "SecondWinner" (idtype): id of the second closest neuron.
 * - "QuantizationError" (double): distance between the row and the weight vector of its neuron.
 *
 * In rows that are left out, these three columns contain -1. Columns of the input with these names
 * are replaced. Columns with these names, or with names of point arrays of port 0, can be neither
 * learned nor LabelColumn.
 *
 * If Standardize is on, distances are measured between standardized values: differences are divided
 * by the standard deviation of the column. "UMatrix" and "QuantizationError" have no unit then.
 *
 * The map is learned in batches on a sequence of networks, from coarse to fine, by the equations of
 * vtkConformalSOM: Eq. 3 of C.-Y. Liou, Y.-T. Kuo, J.-C. Huang, Neurocomputing 71 (2008), summed
 * over all rows. In each pass, a row is projected to the triangles around its winner. The corners
 * of the triangle move towards the row, with their neighbors. See Filters/Numerics/Learn/Batch for
 * details. The topographic error is that of K. Kiviluoto, "Topology preservation in self-organizing
 * maps", ICNN (1996). The U-matrix is that of A. Ultsch and H. P. Siemon, INNC (1990).
 *
 * With several processes, each process learns a map of its own table.
 *
 * @sa
 * vtkConformalSOM vtkGeodesicSphereSource
 */

#ifndef vtkSphericalSOM_h
#define vtkSphericalSOM_h

#include "vtkFiltersShapeModule.h" // for export macro
#include "vtkPolyDataAlgorithm.h"

#include <string> // for names
#include <vector> // for names

class vtkTable;

class VTKFILTERSSHAPE_EXPORT vtkSphericalSOM : public vtkPolyDataAlgorithm
{
public:
  static vtkSphericalSOM* New();
  vtkTypeMacro(vtkSphericalSOM, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * Add the name of a column of numbers to learn, with 1 component. Default is none: all named
   * columns of numbers with 1 component are learned, except for LabelColumn.
   */
  void AddColumn(const std::string& name);
  void RemoveAllColumns();
  int GetNumberOfColumns() { return static_cast<int>(this->Columns.size()); }
  ///@}

  ///@{
  /**
   * Name of a column of strings or numbers, the labels of the rows. Neurons get the most frequent
   * label of their rows. Labels have no effect on the map. Default is none.
   */
  vtkSetMacro(LabelColumn, std::string);
  vtkGetMacro(LabelColumn, std::string);
  ///@}

  ///@{
  /**
   * Whether the values of each column are divided by their standard deviation before distances are
   * measured. All columns then have the same effect. Turn it off if the columns have the same unit.
   * Default is on.
   */
  vtkSetMacro(Standardize, bool);
  vtkGetMacro(Standardize, bool);
  vtkBooleanMacro(Standardize, bool);
  ///@}

  ///@{
  /**
   * Number of neurons. 0 (default): 5 times the square root of the number of rows, a usual choice.
   * Otherwise, the number must be in [12, 1000002]. The map has the nearest number of the form 10
   * f^2 + 2 with an integer f.
   */
  vtkSetClampMacro(NumberOfNeurons, int, 0, 1000002);
  vtkGetMacro(NumberOfNeurons, int);
  ///@}

  ///@{
  /**
   * Seed of the random numbers, which determine how the sphere is placed among the rows at first,
   * and which rows are used in a pass if there are many. At least 0. Default is 1. With equal
   * input, properties and seed, the output is equal bit by bit, for any number of threads.
   */
  vtkSetClampMacro(RandomSeed, int, 0, VTK_INT_MAX);
  vtkGetMacro(RandomSeed, int);
  ///@}

  /**
   * Return the table with the neurons of the rows, output port 1.
   */
  vtkTable* GetTable();

protected:
  vtkSphericalSOM();
  ~vtkSphericalSOM() override = default;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int FillOutputPortInformation(int port, vtkInformation* info) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

private:
  vtkSphericalSOM(const vtkSphericalSOM&) = delete;
  void operator=(const vtkSphericalSOM&) = delete;

  std::vector<std::string> Columns;
  std::string LabelColumn;
  bool Standardize = true;
  int NumberOfNeurons = 0;
  int RandomSeed = 1;
};

#endif
