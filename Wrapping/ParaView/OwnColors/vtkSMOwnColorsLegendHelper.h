/**
 * @class   vtkSMOwnColorsLegendHelper
 * @brief   hide the legend of a color map that no representation uses
 *
 * Keep the legend of a color map hidden if all representations with this color map display colors
 * as they are, without the map (MapScalars is 0). ParaView shows the legend of each array that it
 * colors by, also of arrays of colors.
 *
 * @sa
 * vtkSMOwnColorsInitializationHelper
 */

#ifndef vtkSMOwnColorsLegendHelper_h
#define vtkSMOwnColorsLegendHelper_h

#include "vtkConformalParaViewOwnColorsModule.h" // for export macro
#include "vtkSMProxyInitializationHelper.h"

class VTKCONFORMALPARAVIEWOWNCOLORS_EXPORT vtkSMOwnColorsLegendHelper
  : public vtkSMProxyInitializationHelper
{
public:
  static vtkSMOwnColorsLegendHelper* New();
  vtkTypeMacro(vtkSMOwnColorsLegendHelper, vtkSMProxyInitializationHelper);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /**
   * Observe the visibility of a legend that has just been made.
   */
  void PostInitializeProxy(
    vtkSMProxy* proxy, vtkPVXMLElement* xml, vtkMTimeType initializationTimeStamp) override;

protected:
  vtkSMOwnColorsLegendHelper() = default;
  ~vtkSMOwnColorsLegendHelper() override = default;

private:
  vtkSMOwnColorsLegendHelper(const vtkSMOwnColorsLegendHelper&) = delete;
  void operator=(const vtkSMOwnColorsLegendHelper&) = delete;
};

#endif
