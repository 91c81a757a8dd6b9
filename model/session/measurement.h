#pragma once

#include <string>
#include <vector>

namespace model::session {

/// Where a measurement begins or ends.
struct MeasuredEnd {
    double x = 0.0;  ///< nm of the board
    double y = 0.0;
    std::string layer;  ///< empty: none
    std::string net;    ///< empty: none
    std::string snap;   ///< what was caught: "centre", "edge", "free" …
    bool operator==(const MeasuredEnd&) const = default;
};

/// A distance that the user measured and keeps. In a session file:
///
///     {"name": "A", "step": "pcb", "from": {"at_nm": [0, 0], "layer": "TOP", "net": "GND", "snap": "edge"}, "to": {…},
///      "dz_nm": 0, "overlap_nm": 0, "from_edge_to_edge": true, "shown": true}
struct Measurement {
    std::string name;
    std::string step;  ///< the one it was measured in
    MeasuredEnd from;
    MeasuredEnd to;
    double dz = 0.0;       ///< nm between the faces of the two layers that look at each other; not below 0
    double overlap = 0.0;  ///< nm, of elements that overlap: by that much at least
    bool isGap = false;    ///< from edge to edge of two elements, not from point to point
    bool isShown = true;
    bool operator==(const Measurement&) const = default;

    [[nodiscard]] double dx() const { return to.x - from.x; }
    [[nodiscard]] double dy() const { return to.y - from.y; }
    [[nodiscard]] double distance() const;  ///< in space
};

/// A table for other programs, a row each, in mm and mil.
[[nodiscard]] std::string measurementsCsv(const std::vector<Measurement>& measurements);

}  // namespace model::session
