#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "model/board/document.h"
#include "model/text/net_names.h"

/// Which nets belong together: what the job says of them where it says anything, and what people mean by their names.
namespace model {

enum class NetGrouping : std::uint8_t {
    Class,             ///< attributes of the job alone
    DifferentialPair,  ///< attributes, else two names that differ in one sign of polarity
    Bus,               ///< names that differ in one number
    Supply,            ///< names of grounds and rails, and nets with a large part of all pins
    Sheet              ///< the sheets of the schematic that names begin with (model::sheetOf), within each other
};

inline constexpr std::uint32_t kNoGroup = 0xffffffffu;

struct NetGroups {
    /// In the order people count (isNamedBefore), groups within another right behind it; none is empty of nets or
    /// groups.
    std::vector<std::string> names;
    std::vector<std::uint32_t> depths;           ///< by row of `names`: how many others it lies within
    std::vector<std::uint32_t> groupOf;          ///< by net: row of `names` or kNoGroup
    Backslash backslash = Backslash::EndsSheet;  ///< what sheetOf was told of the names
};

/// Of all names of a board: bars if one ends a name, or if some names look like bars, or Altium wrote the job, and none
/// looks like sheets (backslashIn).
[[nodiscard]] Backslash backslashOf(const Document& document);

/// Names of nets are of two sheets at least.
[[nodiscard]] bool hasSheets(const Document& document);

/// Depends on the names, attributes and pins alone; a net is in one group at most, and in those that it lies within.
[[nodiscard]] NetGroups groupNets(const Document& document, NetGrouping grouping);

/// The name of the other half of a differential pair, should there be a net of that name: "USB_D-" for "USB_D+",
/// "CLK_N0" for "CLK_P0", "DM" for "DP". A name may allow several; the likeliest (nearest to its end) comes first.
[[nodiscard]] std::vector<std::string> polarTwins(std::string_view name);

/// A name as a member of a bus: what is before and behind its number.
struct BusMember {
    std::string_view before;
    std::uint32_t number = 0;
    std::string_view behind;
    bool isIndexed = false;  ///< "A[3]", "A<3>"; the brackets belong to `before` and `behind`
};
/// False for names without a number, and for those that a program made up ("N31710", "NetC48_2", "$1N1808").
[[nodiscard]] bool parseBusMember(std::string_view name, BusMember& out);

enum class Supply : std::uint8_t { None, Ground, Power };
/// What a name says; `pins` settles names that may also be signals ("CLKPD_1P8V").
[[nodiscard]] Supply supplyOf(std::string_view name, std::uint32_t pins);

}  // namespace model
