#include "vtkSMOwnColorsInitializationHelper.h"

#include "vtkCommand.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPVArrayInformation.h"
#include "vtkPVDataInformation.h"
#include "vtkSMProperty.h"
#include "vtkSMPropertyHelper.h"
#include "vtkSMProxy.h"
#include "vtkSMSourceProxy.h"

#include <cstring>

vtkStandardNewMacro(vtkSMOwnColorsInitializationHelper);

namespace
{
constexpr const char* Coloring = "ColorArrayName";
constexpr const char* Mapping = "MapScalars";

// Test whether a representation is colored by an array of colors.
bool showsColors(vtkSMProxy* representation)
{
  const vtkSMPropertyHelper input(representation, "Input", true);
  const vtkSMPropertyHelper coloring(representation, Coloring, true);
  auto* source = vtkSMSourceProxy::SafeDownCast(input.GetAsProxy());
  const char* name = coloring.GetInputArrayNameToProcess();
  if (!source || !name || !*name)
  {
    return false;
  }
  vtkPVArrayInformation* array = source->GetDataInformation(input.GetOutputPort())
                                   ->GetArrayInformation(name, coloring.GetInputArrayAssociation());
  const int components = array ? array->GetNumberOfComponents() : 0;
  return array && array->GetDataType() == VTK_UNSIGNED_CHAR && (components == 3 || components == 4);
}

// Observer that the representation owns, so that it ends with the representation.
class ColoringObserver : public vtkCommand
{
public:
  static ColoringObserver* New() { return new ColoringObserver; }

  void Execute(vtkObject* caller, unsigned long, void* data) override
  {
    const auto* property = static_cast<const char*>(data);
    auto* representation = vtkSMProxy::SafeDownCast(caller);
    if (!representation || !property || std::strcmp(property, Coloring) != 0)
    {
      return;
    }
    const bool shows = showsColors(representation);
    if (shows != this->ShowsColors)
    {
      this->ShowsColors = shows;
      vtkSMPropertyHelper(representation, Mapping).Set(shows ? 0 : 1);
    }
  }

private:
  bool ShowsColors = false;
};
}

//------------------------------------------------------------------------------
void vtkSMOwnColorsInitializationHelper::PostInitializeProxy(
  vtkSMProxy* proxy, vtkPVXMLElement*, vtkMTimeType)
{
  if (proxy && proxy->GetProperty(Coloring) && proxy->GetProperty(Mapping))
  {
    const vtkNew<ColoringObserver> observer;
    proxy->AddObserver(vtkCommand::PropertyModifiedEvent, observer);
  }
}

//------------------------------------------------------------------------------
void vtkSMOwnColorsInitializationHelper::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
}
