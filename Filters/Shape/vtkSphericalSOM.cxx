#include "vtkSphericalSOM.h"

#include "Glue/Arrays.h"
#include "Glue/Points.h"
#include "Glue/Run.h"
#include "Glue/TableRows.h"
#include "Learn/Batch/SphericalSOM.h"

#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkTable.h"

#include <set>
#include <stdexcept>

vtkStandardNewMacro(vtkSphericalSOM);

namespace
{
void RequireFreeNames(const std::vector<std::string>& names, const std::string& label)
{
  const std::set<std::string> reserved = { glue::SpherePositionName(), "HitCount", "UMatrix",
    "Winner", "SecondWinner", "QuantizationError" };
  for (const std::string& name : names)
  {
    if (reserved.count(name) > 0 || reserved.count(label) > 0 || name == label)
    {
      throw std::invalid_argument("the column \"" + (reserved.count(label) > 0 ? label : name) +
        "\" has the name of another array of the output; rename it, or do not add it");
    }
  }
}

// Make the sphere with its arrays.
vtkNew<vtkPolyData> SphereOf(
  const conformal::SphericalSOMResult& map, const glue::TableRows& rows, vtkAbstractArray* labels)
{
  vtkNew<vtkPolyData> sphere;
  glue::SetSurface(sphere, map.Network.Positions, map.Network.Triangles, {});
  vtkPointData* data = sphere->GetPointData();
  glue::AddVectors(data, glue::SpherePositionName(), map.Network.Positions);
  for (std::size_t c = 0; c < rows.Names.size(); ++c)
  {
    const Eigen::VectorXd values = map.Weights.row(static_cast<conformal::Index>(c));
    glue::AddNumbers(data, rows.Names[c].c_str(), { values.begin(), values.end() });
  }
  glue::AddIntegers(data, "HitCount", map.Hits);
  glue::AddNumbers(data, "UMatrix", map.UMatrix);
  if (labels)
  {
    data->AddArray(glue::MajorityLabels(labels, rows.Ids, map.Winners, map.Rows));
  }
  glue::AddNumber(sphere->GetFieldData(), "QuantizationError", map.QuantizationError);
  glue::AddNumber(sphere->GetFieldData(), "TopographicError", map.TopographicError);
  return sphere;
}
}

//------------------------------------------------------------------------------
vtkSphericalSOM::vtkSphericalSOM()
{
  this->SetNumberOfOutputPorts(2);
}

//------------------------------------------------------------------------------
void vtkSphericalSOM::AddColumn(const std::string& name)
{
  this->Columns.push_back(name);
  this->Modified();
}

//------------------------------------------------------------------------------
void vtkSphericalSOM::RemoveAllColumns()
{
  if (!this->Columns.empty())
  {
    this->Columns.clear();
    this->Modified();
  }
}

//------------------------------------------------------------------------------
vtkTable* vtkSphericalSOM::GetTable()
{
  return vtkTable::SafeDownCast(this->GetOutputDataObject(1));
}

//------------------------------------------------------------------------------
int vtkSphericalSOM::FillInputPortInformation(int, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkTable");
  return 1;
}

//------------------------------------------------------------------------------
int vtkSphericalSOM::FillOutputPortInformation(int port, vtkInformation* info)
{
  info->Set(vtkDataObject::DATA_TYPE_NAME(), port == 0 ? "vtkPolyData" : "vtkTable");
  return 1;
}

//------------------------------------------------------------------------------
int vtkSphericalSOM::RequestData(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  const auto table = glue::Held(vtkTable::GetData(inputVector[0]));
  vtkPolyData* output = vtkPolyData::GetData(outputVector, 0);
  vtkTable* outputTable = vtkTable::GetData(outputVector, 1);
  const std::vector<std::string> names = this->Columns;
  const std::string labelName = this->LabelColumn;
  conformal::SphericalSOMOptions options;
  options.NumberOfNeurons = this->NumberOfNeurons;
  options.Standardize = this->Standardize;
  options.RandomSeed = static_cast<unsigned int>(this->RandomSeed);
  return glue::RunCore(this,
    [&]()
    {
      if (table->GetNumberOfRows() == 0)
      {
        glue::WarnOfEmptyInput(this, "the table has no rows; there is no map");
        return;
      }
      const glue::TableRows rows = glue::ReadRows(table, names, labelName);
      vtkAbstractArray* labels = glue::LabelColumn(table, labelName);
      RequireFreeNames(rows.Names, labelName);
      if (rows.NumberOfNonFinite > 0)
      {
        vtkWarningMacro(<< rows.NumberOfNonFinite << " of " << table->GetNumberOfRows()
                        << " rows have a number that is not finite, and are left out");
      }
      if (rows.Ids.empty())
      {
        return;
      }
      const conformal::SphericalSOMResult map =
        conformal::learnSphericalSOM(rows.Values, options, glue::RunOf(this));
      const vtkNew<vtkPolyData> sphere = SphereOf(map, rows, labels);
      glue::AppendColumn(table, "Winner", rows, map.Winners);
      glue::AppendColumn(table, "SecondWinner", rows, map.SecondWinners);
      glue::AppendColumn(table, "QuantizationError", rows, map.Distances);
      output->ShallowCopy(sphere);
      outputTable->ShallowCopy(table);
    });
}

//------------------------------------------------------------------------------
void vtkSphericalSOM::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "NumberOfColumns: " << this->Columns.size() << "\n";
  os << indent << "LabelColumn: " << (this->LabelColumn.empty() ? "(none)" : this->LabelColumn)
     << "\n";
  os << indent << "Standardize: " << (this->Standardize ? "On" : "Off") << "\n";
  os << indent << "NumberOfNeurons: " << this->NumberOfNeurons << "\n";
  os << indent << "RandomSeed: " << this->RandomSeed << "\n";
}
