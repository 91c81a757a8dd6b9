#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

/// Names of nets as people write them. Jobs that KiCad wrote spell some characters as words in braces and mark parts
/// that are active low.
namespace model {

/// "Net-(U1-P1.00/XL1)" for "Net-(U1-P1.00{slash}XL1)"; the characters of "~{RESET}" have bars over them (U+0305 behind
/// each). What is no such spelling, or has no closing brace, stays as it is. UTF-8.
[[nodiscard]] std::string readableName(std::string_view name);

/// The same as people type it, without bars: "RESET".
[[nodiscard]] std::string typedName(std::string_view name);

/// May a name hold such a spelling? Few do; the others are as people write and type them.
[[nodiscard]] bool hasBraces(std::string_view name);

/// What a backslash in the names of a board means: "POWER\ADJ" is a net of a sheet; in "R\S\T\1" and "ENC_A\" the
/// character before each has a bar over it, as Altium writes it.
enum class Backslash : std::uint8_t { EndsSheet, Overbar };

/// What several backslashes in this name look like: bars if one ends it or single characters lie between all of them,
/// else sheets. None for names with fewer, which may be either; all names of a board are of one kind, see backslashOf.
[[nodiscard]] std::optional<Backslash> backslashIn(std::string_view name);

/// The sheets of a schematic that a net belongs to, with what is around them: "/Ethernet/" of "/Ethernet/RXD0", "/" of
/// "/RXD0", and as other programs write them "POWER\" of "POWER\ADJ". Empty for nets of all sheets; never all of a
/// name.
[[nodiscard]] std::string_view sheetOf(std::string_view name, Backslash backslash = Backslash::EndsSheet);

}  // namespace model
