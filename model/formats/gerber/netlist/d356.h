#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "model/board/diagnostics.h"
#include "model/board/document.h"

namespace model::gerber {

/// A test point of an IPC-D-356 or D-356A netlist, in the netlist's own coordinates.
struct D356Point {
    std::int32_t net = -1;  ///< D356::nets; none for N/C and for holes without a net
    std::string refdes;     ///< as written: cut to 6 characters by the format; "VIA" is none
    std::string pin;        ///< cut to 4
    Point position;
    Nm hole = 0;  ///< diameter; 0: no hole
    Nm width = 0;
    Nm height = 0;   ///< 0: round
    int access = 0;  ///< 0: both sides, else the copper layer counted from the top
    Exposure exposure = Exposure::NotSaid;
    bool isPlated = true;
    bool isVia = false;
    bool isEnd = true;
    std::uint32_t line = 0;
};

struct D356 {
    std::vector<std::string>
        nets;  ///< as written, or in full where the file says so (NNAME records, which Allegro writes as comments)
    std::vector<D356Point> points;
    std::optional<double> boardNm;  ///< thickness of the board, which Allegro writes into a comment
    std::uint32_t boardLine = 0;    ///< of that comment
};

/// Is this the beginning of such a netlist?
[[nodiscard]] bool looksLikeD356(std::string_view head);
[[nodiscard]] D356 parseD356(std::string_view text, std::string_view path, Diagnostics& diagnostics);

}  // namespace model::gerber
