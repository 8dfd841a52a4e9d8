#include "Trial.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDoubleArray.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkPolyDataAlgorithm.h"

#include <cmath>
#include <csignal>
#include <stdexcept>

namespace
{
// Does to its output what it is told.
class Villain : public vtkPolyDataAlgorithm
{
public:
  static Villain* New();
  vtkTypeMacro(Villain, vtkPolyDataAlgorithm);

  std::function<void(vtkPolyData*)> Deed;

protected:
  int RequestData(
    vtkInformation*, vtkInformationVector** inputs, vtkInformationVector* outputs) override
  {
    vtkPolyData* output = vtkPolyData::GetData(outputs);
    output->DeepCopy(vtkPolyData::GetData(inputs[0]));
    this->Deed(output);
    return 1;
  }
};
vtkStandardNewMacro(Villain);
}

namespace hostile
{
//------------------------------------------------------------------------------
std::vector<Trial> VillainTrials()
{
  std::vector<Trial> all;
  const auto add =
    [&](const char* name, Verdict verdict, const std::function<void(vtkPolyData*)>& deed)
  {
    cases::Case villain = { name,
      [=]() -> cases::Algorithm
      {
        auto made = vtkSmartPointer<Villain>::New();
        made->Deed = deed;
        return made;
      } };
    const cases::Mode mode = { "", { cases::Surface(cases::BadPoints) }, {}, true };
    const cases::Input input = { WordFor(verdict), []() { return cases::Ellipsoid(); } };
    all.push_back({ name, name, input.Name, [=]() { return RunOn(villain, mode, input); } });
    all.back().CPUSeconds = 1;
  };
  add("does nothing", Verdict::Fine, [](vtkPolyData*) {});
  add("refuses", Verdict::Refused,
    [](vtkPolyData* p)
    {
      p->Initialize();
      vtkErrorWithObjectMacro(p, "no");
    });
  add("reads at 8", Verdict::Crash, [](vtkPolyData*) { std::raise(SIGSEGV); });
  add("throws", Verdict::Crash, [](vtkPolyData*) { throw std::runtime_error("thrown"); });
  add("exits", Verdict::Crash, [](vtkPolyData*) { std::_Exit(0); });
  add("never ends", Verdict::Hang,
    [](vtkPolyData* p)
    {
      for (vtkIdType i = 0; p->GetNumberOfPoints() > 0; ++i)
      {
        p->GetPoints()->SetPoint(i % 9, 1.0, 2.0, 3.0);
      }
    });
  add("gives NaN", Verdict::NotFinite,
    [](vtkPolyData* p) { p->GetPoints()->SetPoint(5, std::nan(""), 0.0, 0.0); });
  add("gives NaN in an array", Verdict::NotFinite,
    [](vtkPolyData* p)
    {
      vtkDataArray* array = p->GetPointData()->GetArray("SpherePosition");
      array->SetComponent(161, 2, INFINITY);
    });
  add("gives a short array", Verdict::Wrong,
    [](vtkPolyData* p) { p->GetPointData()->GetArray("SpherePosition")->SetNumberOfTuples(161); });
  add("gives ids that are not there", Verdict::Wrong,
    [](vtkPolyData* p)
    {
      const vtkIdType ids[] = { 0, 1, 162 };
      p->GetPolys()->InsertNextCell(3, ids);
      p->GetCellData()->Initialize();
    });
  add("gives an open surface", Verdict::Wrong,
    [](vtkPolyData* p)
    {
      const vtkIdType ids[] = { 0, 1, 2 };
      vtkNew<vtkCellArray> one;
      one->InsertNextCell(3, ids);
      p->SetPolys(one);
      p->GetCellData()->Initialize();
    });
  add("gives nothing, silently", Verdict::Wrong, [](vtkPolyData* p) { p->Initialize(); });
  add("fails, and gives something", Verdict::Wrong,
    [](vtkPolyData* p) { vtkErrorWithObjectMacro(p, "no"); });
  return all;
}
}
