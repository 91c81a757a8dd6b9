#pragma once

#include <optional>
#include <string_view>

namespace model::gerber {

/// Two numbers of copper layers in the name of a drill file. Whether they are such, only the board can tell: names end
/// with numbers of versions and dates, too.
struct NamedSpan {
    int first = 0;
    int last = 0;            ///< larger than `first`
    bool isOfEagle = false;  ///< Eagle's numbers: 1 is the top, 16 the bottom, inner layers have those of their files

    friend bool operator==(const NamedSpan&, const NamedSpan&) = default;
};

/// "board-1-6.drl" and "board_1-6.rou" of Allegro, "board.drd.0115" of Eagle.
[[nodiscard]] std::optional<NamedSpan> spanInName(std::string_view name);

}  // namespace model::gerber
