/// Find the unit and the body in the label of a plate model.

#ifndef ConformalPlateModelLabel_h
#define ConformalPlateModelLabel_h

#include <string>
#include <string_view>

namespace conformal
{
/// Part of a label of the Planetary Data System (PDS) that describes a plate model.
struct PlateModelLabel
{
  std::string TargetName;     ///< name of the body, as in the label; empty if it is not stated
  double MetersPerUnit = 0.0; ///< 1000 (kilometers), 1 (meters), or 0 if the unit is not stated
  /// Whether the label states both kilometers and meters. MetersPerUnit is then 0.
  bool HasSeveralUnits = false;
};

/// Read a label of PDS3 (lines such as UNIT = KILOMETER and TARGET_NAME = "433 EROS") or PDS4 (XML
/// with the elements unit and Target_Identification). Units that are not lengths are ignored, and
/// so are comments. A text that is no label gives an empty result.
PlateModelLabel parsePlateModelLabel(std::string_view text);
}

#endif
