#pragma once

#include <string>
#include <string_view>

#include "model/base/result.h"
#include "model/base/units.h"

namespace model {

using base::Nm;

/// Thicknesses that a user may set; what is outside of them is a typing error.
inline constexpr Nm kLeastSet = 1'000;
inline constexpr Nm kMostSet = 10'000'000;

/// With a point where the number of the text has a decimal comma: "1,5mm" becomes "1.5mm". Only where it can be nothing
/// else: a single comma, no point, a digit before it and behind it; "1,000" may be a thousand and stays.
[[nodiscard]] std::string withDecimalPoint(std::string_view text);

/// A length as people write it: a number, with point or comma, with um, µm, mm, mil, in or inch. Errors: BadUsage when
/// it is no such text, or not above 0 and at most 1 m.
[[nodiscard]] base::Result<Nm> parseLength(std::string_view text);

/// A thickness as people write it: a number, with point or comma, with um, µm, mm, mil, in or inch, or for copper oz
/// (ounces per square foot). Errors: BadUsage when it is no such text, is outside of 1 µm to 10 mm, or is a weight
/// where there is no copper.
[[nodiscard]] base::Result<Nm> parseThickness(std::string_view text, bool isCopper);

/// "35 µm", "1.2 mm" below and from 1 mm; exact to the nanometre, and read back by parseThickness.
[[nodiscard]] std::string thicknessText(Nm thickness);

}  // namespace model
