#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

#include "model/base/units.h"

namespace model::odb {

/// The unit of a file or of one symbol.
enum class Unit : std::uint8_t { Inch, Millimetre };

/// Nanometres per coordinate unit; whole numbers, so that lengths can be read exactly.
constexpr std::int64_t coordinateNm(Unit unit) {
    return unit == Unit::Inch ? 25'400'000 : 1'000'000;
}
/// Nanometres per symbol unit: symbols and tools are in thousandths, mil or µm (odb-notes, Units).
constexpr std::int64_t symbolNm(Unit unit) {
    return coordinateNm(unit) / 1000;
}

/// "MM" or "INCH" in any case; nothing for other texts, empty ones included.
[[nodiscard]] std::optional<Unit> parseUnit(std::string_view text);
/// Takes a line `UNITS=MM` or `U MM`; a unit that is neither changes nothing.
[[nodiscard]] bool readUnit(std::string_view line, std::int64_t& nmPerUnit);

}  // namespace model::odb
