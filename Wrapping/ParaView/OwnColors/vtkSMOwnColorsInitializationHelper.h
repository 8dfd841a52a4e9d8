/**
 * @class   vtkSMOwnColorsInitializationHelper
 * @brief   display red, green and blue of points and cells without a color map
 *
 * Keep the property MapScalars of a representation in agreement with its coloring. If the array of
 * ColorArrayName has colors (unsigned char, 3 or 4 components), MapScalars is set to 0. The colors
 * are then displayed as they are, instead of the colors that a color map has for their magnitude.
 * If the coloring changes from such an array to another one, MapScalars is set to 1.
 *
 * MapScalars only changes when the kind of the coloring changes. A value that the user sets
 * afterwards is kept.
 */

#ifndef vtkSMOwnColorsInitializationHelper_h
#define vtkSMOwnColorsInitializationHelper_h

#include "vtkConformalParaViewOwnColorsModule.h" // for export macro
#include "vtkSMProxyInitializationHelper.h"

class VTKCONFORMALPARAVIEWOWNCOLORS_EXPORT vtkSMOwnColorsInitializationHelper
  : public vtkSMProxyInitializationHelper
{
public:
  static vtkSMOwnColorsInitializationHelper* New();
  vtkTypeMacro(vtkSMOwnColorsInitializationHelper, vtkSMProxyInitializationHelper);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /**
   * Observe the coloring of a representation that has just been made.
   */
  void PostInitializeProxy(
    vtkSMProxy* proxy, vtkPVXMLElement* xml, vtkMTimeType initializationTimeStamp) override;

protected:
  vtkSMOwnColorsInitializationHelper() = default;
  ~vtkSMOwnColorsInitializationHelper() override = default;

private:
  vtkSMOwnColorsInitializationHelper(const vtkSMOwnColorsInitializationHelper&) = delete;
  void operator=(const vtkSMOwnColorsInitializationHelper&) = delete;
};

#endif
