#include "vtkSMOwnColorsLegendHelper.h"

#include "vtkCommand.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkSMPropertyHelper.h"
#include "vtkSMProxy.h"

#include <cstring>

vtkStandardNewMacro(vtkSMOwnColorsLegendHelper);

namespace
{
// Test whether there are representations with the color map of a legend, and none of them maps
// scalars.
bool isUnused(vtkSMProxy* legend)
{
  vtkSMProxy* colorMap = vtkSMPropertyHelper(legend, "LookupTable", true).GetAsProxy();
  bool hasRepresentations = false;
  for (unsigned int i = 0; colorMap && i < colorMap->GetNumberOfConsumers(); ++i)
  {
    vtkSMProxy* consumer = colorMap->GetConsumerProxy(i);
    consumer = consumer ? consumer->GetTrueParentProxy() : nullptr;
    if (!consumer || consumer == legend->GetTrueParentProxy())
    {
      continue;
    }
    if (consumer->GetProperty("MapScalars"))
    {
      hasRepresentations = true;
      if (vtkSMPropertyHelper(consumer, "MapScalars").GetAsInt() != 0)
      {
        return false;
      }
    }
  }
  return hasRepresentations;
}

void hideIfUnused(vtkSMProxy* legend)
{
  for (const char* property : { "Visibility", "Enabled" })
  {
    if (vtkSMPropertyHelper(legend, property, true).GetAsInt() != 0 && isUnused(legend))
    {
      vtkSMPropertyHelper(legend, property).Set(0);
    }
  }
}

// Observer that the legend owns, so that it ends with the legend.
class VisibilityObserver : public vtkCommand
{
public:
  static VisibilityObserver* New() { return new VisibilityObserver; }

  void Execute(vtkObject* caller, unsigned long, void* data) override
  {
    const auto* property = static_cast<const char*>(data);
    auto* legend = vtkSMProxy::SafeDownCast(caller);
    if (legend && property &&
      (std::strcmp(property, "Visibility") == 0 || std::strcmp(property, "Enabled") == 0))
    {
      hideIfUnused(legend);
    }
  }
};
}

//------------------------------------------------------------------------------
void vtkSMOwnColorsLegendHelper::PostInitializeProxy(
  vtkSMProxy* proxy, vtkPVXMLElement*, vtkMTimeType)
{
  if (proxy && proxy->GetProperty("Visibility") && proxy->GetProperty("Enabled"))
  {
    hideIfUnused(proxy);
    const vtkNew<VisibilityObserver> observer;
    proxy->AddObserver(vtkCommand::PropertyModifiedEvent, observer);
  }
}

//------------------------------------------------------------------------------
void vtkSMOwnColorsLegendHelper::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
}
