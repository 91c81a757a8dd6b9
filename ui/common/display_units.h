#pragma once

#include <QString>
#include <string>

#include "model/base/units.h"

/// Lengths, positions and areas in the user's unit.
namespace ui {

enum class LengthUnit { Millimetre, Mil, Inch };

[[nodiscard]] const char* unitName(LengthUnit unit);  ///< "mm", "mil", "in"
/// The unit of that name; millimetres for no name of a unit.
[[nodiscard]] LengthUnit unitNamed(const std::string& name);
[[nodiscard]] LengthUnit nextUnit(LengthUnit unit);
[[nodiscard]] double nmPer(LengthUnit unit);

/// To about 0.1 µm, with the unit: "0.25 mm", "9.84 mil".
[[nodiscard]] QString lengthText(double nm, LengthUnit unit);
/// With as many digits as the unit has, for columns and for what changes while one looks: "0.2500 mm", "9.84 mil".
[[nodiscard]] QString fixedLengthText(double nm, LengthUnit unit);
/// The same in both systems: "0.2500 mm (9.84 mil)".
[[nodiscard]] QString fixedLengthInBoth(double nm, LengthUnit unit);
/// In both systems, for what is read off rather than compared: "0.25 mm (9.84 mil)".
[[nodiscard]] QString lengthInBoth(double nm, LengthUnit unit);
/// "12.3456, -7.0000 mm": digits that do not jump while the cursor moves.
[[nodiscard]] QString positionText(double x, double y, LengthUnit unit);
/// "45°", to a ten thousandth.
[[nodiscard]] QString angleText(double degrees);
[[nodiscard]] QString areaText(double squareNm, LengthUnit unit);
/// From now on counts are written, and numbers in fields are typed, as lengths are whatever the user's language:
/// "1,234.5".
void setNumberFormat();

}  // namespace ui
