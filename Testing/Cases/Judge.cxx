#include "Judge.h"

#include "vtkAlgorithm.h"
#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkDataObject.h"
#include "vtkDataSet.h"
#include "vtkFieldData.h"
#include "vtkIdList.h"
#include "vtkLogger.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkOutputWindow.h"
#include "vtkPointData.h"
#include "vtkPointSet.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkTable.h"
#include "vtkUnstructuredGrid.h"

#include <cmath>
#include <map>
#include <utility>
#include <vector>

namespace
{
class Listener : public vtkOutputWindow
{
public:
  static Listener* New();
  vtkTypeMacro(Listener, vtkOutputWindow);
  void DisplayText(const char*) override {}
  void DisplayErrorText(const char* text) override { this->Note(this->Errors, text); }
  void DisplayWarningText(const char* text) override { this->Note(this->Warnings, text); }
  void DisplayGenericWarningText(const char* text) override { this->Note(this->Warnings, text); }

  std::vector<std::string> Errors, Warnings;

private:
  void Note(std::vector<std::string>& texts, const char* text)
  {
    texts.push_back(texts.empty() ? text : "");
  }
};
vtkStandardNewMacro(Listener);

Listener* Current()
{
  return Listener::SafeDownCast(vtkOutputWindow::GetInstance());
}

// Of "ERROR: In file, line 3\nvtkClass (0x55): text\n\n" the text.
std::string WithoutPlace(const std::string& message)
{
  const std::size_t line = message.find('\n');
  const std::size_t text = message.find("): ", line == std::string::npos ? 0 : line);
  std::string bare = message.substr(text == std::string::npos ? 0 : text + 3);
  for (char& c : bare)
  {
    c = c == '\n' ? ' ' : c;
  }
  return bare.substr(0, bare.find_last_not_of(' ') + 1);
}
}

namespace cases
{
//------------------------------------------------------------------------------
Messages::Messages()
{
  vtkLogger::SetStderrVerbosity(vtkLogger::VERBOSITY_OFF);
  vtkNew<Listener> listener;
  vtkOutputWindow::SetInstance(listener);
}

//------------------------------------------------------------------------------
Messages::~Messages()
{
  vtkOutputWindow::SetInstance(nullptr);
}

//------------------------------------------------------------------------------
int Messages::errors() const
{
  return static_cast<int>(Current()->Errors.size());
}

//------------------------------------------------------------------------------
int Messages::warnings() const
{
  return static_cast<int>(Current()->Warnings.size());
}

//------------------------------------------------------------------------------
std::string Messages::first() const
{
  const Listener* all = Current();
  return !all->Errors.empty() ? WithoutPlace(all->Errors.front())
    : !all->Warnings.empty()  ? "warning: " + WithoutPlace(all->Warnings.front())
                              : std::string();
}

namespace
{
// Far from where sums of a few overflow.
bool IsTame(vtkAbstractArray* array)
{
  constexpr double Limit = 1e300;
  auto* numbers = vtkDataArray::SafeDownCast(array);
  for (vtkIdType i = 0; numbers && i < numbers->GetNumberOfTuples(); ++i)
  {
    for (int c = 0; c < numbers->GetNumberOfComponents(); ++c)
    {
      if (!(std::abs(numbers->GetComponent(i, c)) <= Limit))
      {
        return false;
      }
    }
  }
  return true;
}
}

//------------------------------------------------------------------------------
void Given::add(vtkDataObject* input)
{
  for (int type = 0; input && type < vtkDataObject::NUMBER_OF_ATTRIBUTE_TYPES; ++type)
  {
    vtkFieldData* fields = input->GetAttributesAsFieldData(type);
    for (int i = 0; fields && i < fields->GetNumberOfArrays(); ++i)
    {
      vtkAbstractArray* array = fields->GetAbstractArray(i);
      this->Arrays.insert(array);
      if (array->GetName() && !IsTame(array))
      {
        this->Names.insert(array->GetName());
      }
    }
  }
  auto* set = vtkPointSet::SafeDownCast(input);
  if (set && set->GetPoints())
  {
    this->Arrays.insert(set->GetPoints()->GetData());
  }
  this->Names.erase("SpherePosition"); // the filters' own
}

//------------------------------------------------------------------------------
bool Given::has(vtkAbstractArray* array) const
{
  return this->Arrays.count(array) > 0 ||
    (array->GetName() && this->Names.count(array->GetName()) > 0);
}

namespace
{
Outcome JudgeValues(vtkAbstractArray* array, const Given& given)
{
  auto* numbers = vtkDataArray::SafeDownCast(array);
  const bool isGiven = array && given.has(array);
  for (vtkIdType i = 0; numbers && !isGiven && i < numbers->GetNumberOfTuples(); ++i)
  {
    for (int c = 0; c < numbers->GetNumberOfComponents(); ++c)
    {
      if (!std::isfinite(numbers->GetComponent(i, c)))
      {
        return { Verdict::NotFinite,
          std::string(array->GetName() ? array->GetName() : "points") + " of " +
            std::to_string(i) };
      }
    }
  }
  return {};
}

Outcome JudgeFields(vtkFieldData* fields, vtkIdType tuples, const Given& given)
{
  for (int i = 0; fields && i < fields->GetNumberOfArrays(); ++i)
  {
    vtkAbstractArray* array = fields->GetAbstractArray(i);
    if (tuples >= 0 && array->GetNumberOfTuples() != tuples)
    {
      return { Verdict::Wrong,
        std::string("array ") + (array->GetName() ? array->GetName() : "") + " has " +
          std::to_string(array->GetNumberOfTuples()) + " tuples for " + std::to_string(tuples) };
    }
    const Outcome outcome = JudgeValues(array, given);
    if (isBad(outcome.Verdict))
    {
      return outcome;
    }
  }
  return {};
}

bool HasIdsInRange(vtkCellArray* cells, vtkIdType points)
{
  vtkNew<vtkIdList> ids;
  for (vtkIdType cell = 0; cells && cell < cells->GetNumberOfCells(); ++cell)
  {
    cells->GetCellAtId(cell, ids);
    for (const vtkIdType id : *ids)
    {
      if (id < 0 || id >= points)
      {
        return false;
      }
    }
  }
  return true;
}

bool HasIdsInRange(vtkDataObject* data)
{
  if (auto* surface = vtkPolyData::SafeDownCast(data))
  {
    const vtkIdType points = surface->GetNumberOfPoints();
    return HasIdsInRange(surface->GetVerts(), points) &&
      HasIdsInRange(surface->GetLines(), points) && HasIdsInRange(surface->GetPolys(), points) &&
      HasIdsInRange(surface->GetStrips(), points);
  }
  auto* grid = vtkUnstructuredGrid::SafeDownCast(data);
  return !grid || HasIdsInRange(grid->GetCells(), grid->GetNumberOfPoints());
}

bool IsEmpty(vtkDataObject* data)
{
  return !data ||
    data->GetNumberOfElements(vtkDataObject::POINT) +
      data->GetNumberOfElements(vtkDataObject::ROW) ==
    0;
}
}

//------------------------------------------------------------------------------
Outcome JudgeData(vtkDataObject* data, const Given& given)
{
  if (IsEmpty(data))
  {
    return {};
  }
  Outcome outcome;
  const auto look = [&](const Outcome& next) { outcome = isBad(outcome.Verdict) ? outcome : next; };
  if (!HasIdsInRange(data))
  {
    look({ Verdict::Wrong, "an id is out of range" });
  }
  if (auto* set = vtkDataSet::SafeDownCast(data))
  {
    look(JudgeFields(set->GetPointData(), set->GetNumberOfPoints(), given));
    look(JudgeFields(set->GetCellData(), set->GetNumberOfCells(), given));
  }
  if (auto* set = vtkPointSet::SafeDownCast(data))
  {
    look(JudgeValues(set->GetPoints() ? set->GetPoints()->GetData() : nullptr, given));
  }
  if (auto* blocks = vtkMultiBlockDataSet::SafeDownCast(data))
  {
    for (unsigned int i = 0; i < blocks->GetNumberOfBlocks(); ++i)
    {
      look(JudgeData(blocks->GetBlock(i), given));
    }
  }
  if (auto* table = vtkTable::SafeDownCast(data))
  {
    look(JudgeFields(
      table->GetAttributesAsFieldData(vtkDataObject::ROW), table->GetNumberOfRows(), given));
  }
  look(JudgeFields(data->GetFieldData(), -1, given));
  return outcome;
}

//------------------------------------------------------------------------------
bool IsClosedSphere(vtkPolyData* surface)
{
  std::map<std::pair<vtkIdType, vtkIdType>, int> edges;
  std::set<vtkIdType> vertices;
  vtkIdType faces = 0;
  const auto add = [&](const std::vector<vtkIdType>& ids)
  {
    faces += ids.size() > 2;
    for (std::size_t k = 0; k < ids.size() && ids.size() > 2; ++k)
    {
      vertices.insert(ids[k]);
      ++edges[{ ids[k], ids[(k + 1) % ids.size()] }];
    }
  };
  vtkIdType size = 0;
  const vtkIdType* ids = nullptr;
  for (vtkIdType cell = 0; cell < surface->GetNumberOfPolys(); ++cell)
  {
    surface->GetPolys()->GetCellAtId(cell, size, ids);
    add({ ids, ids + size });
  }
  for (vtkIdType cell = 0; cell < surface->GetNumberOfStrips(); ++cell)
  {
    surface->GetStrips()->GetCellAtId(cell, size, ids);
    for (vtkIdType k = 0; k + 2 < size; ++k)
    {
      add({ ids[k], ids[k + 1 + k % 2], ids[k + 2 - k % 2] });
    }
  }
  for (const auto& [edge, count] : edges)
  {
    const auto other = edges.find({ edge.second, edge.first });
    if (count != 1 || other == edges.end() || other->second != 1)
    {
      return false;
    }
  }
  return static_cast<vtkIdType>(vertices.size()) - static_cast<vtkIdType>(edges.size() / 2) +
    faces ==
    2;
}

//------------------------------------------------------------------------------
Outcome JudgeFilter(vtkAlgorithm* filter, const Messages& messages, bool isClosed)
{
  Given given;
  bool isGiven = false;
  for (int port = 0; port < filter->GetNumberOfInputPorts(); ++port)
  {
    for (int i = 0; i < filter->GetNumberOfInputConnections(port); ++i)
    {
      vtkDataObject* input = filter->GetInputDataObject(port, i);
      given.add(input);
      isGiven = isGiven || !IsEmpty(input);
    }
  }
  bool isEmpty = true;
  Outcome outcome = { Verdict::Fine, messages.first() };
  for (int port = 0; port < filter->GetNumberOfOutputPorts(); ++port)
  {
    vtkDataObject* output = filter->GetOutputDataObject(port);
    isEmpty = isEmpty && IsEmpty(output);
    const Outcome judged = JudgeData(output, given);
    outcome = isBad(outcome.Verdict) || !isBad(judged.Verdict) ? outcome : judged;
  }
  if (isBad(outcome.Verdict))
  {
    return outcome;
  }
  if (messages.errors() > 0)
  {
    return { isEmpty ? Verdict::Refused : Verdict::Wrong,
      (isEmpty ? "" : "an error and a result: ") + messages.first() };
  }
  if (isEmpty)
  {
    const bool isTold = messages.warnings() > 0 || filter->GetAbortExecute() != 0 || !isGiven;
    return { isTold ? Verdict::Refused : Verdict::Wrong,
      isTold ? messages.first() : "empty without a word" };
  }
  auto* surface = vtkPolyData::SafeDownCast(filter->GetOutputDataObject(0));
  auto* source = filter->GetNumberOfInputPorts() > 0
    ? vtkPolyData::SafeDownCast(filter->GetInputDataObject(0, 0))
    : nullptr;
  const bool isOpen = source && source->GetNumberOfCells() > 0 && !IsClosedSphere(source);
  if (isClosed && !isOpen && !(surface && IsClosedSphere(surface)))
  {
    return { Verdict::Wrong, "not a closed surface of genus zero" };
  }
  return outcome;
}
}
