#include "Glue/Scanners.h"

#include "Base/Reduce.h"
#include "Cloud/TrainingSamples.h"
#include "Glue/Points.h"

#include "vtkDataArray.h"
#include "vtkFieldData.h"
#include "vtkPointData.h"
#include "vtkPointSet.h"

#include <cstdint>
#include <stdexcept>
#include <string>

namespace glue
{
//------------------------------------------------------------------------------
void SetScanners(vtkPointSet* input, const conformal::CoordinateFrame& frame,
  conformal::TrainingSamples& samples, conformal::Points& copy)
{
  const vtkIdType size = input->GetNumberOfPoints();
  vtkDataArray* array = input->GetPointData()->GetArray(ScannerPositionName());
  const bool isOfPoints = array;
  array = isOfPoints ? array : input->GetFieldData()->GetArray(ScannerPositionName());
  const bool isBad = array &&
    (array->GetNumberOfComponents() != 3 ||
      array->GetNumberOfTuples() != (isOfPoints ? input->GetNumberOfPoints() : 1));
  std::int64_t counts[] = { size > 0 && !array, size > 0 && array, size > 0 && isBad };
  samples.reduce().sum(counts, 3);
  if (counts[2] > 0)
  {
    throw std::invalid_argument("the array \"" + std::string(ScannerPositionName()) +
      "\" must have 3 components, and 1 tuple for each point, or 1 tuple if it is a field array");
  }
  if (counts[0] == 0 && counts[1] > 0)
  {
    samples.setScanners(
      size > 0 ? ViewVectors(array, ScannerPositionName(), copy, frame) : conformal::PointView());
  }
}
}
