#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "model/base/point.h"

namespace model {

/// MeasuredEnd::item of what lies on the board's edge or a cut-out.
inline constexpr const char* kBoardEdgeItem = "board's edge";

/// Where a measurement begins or ends.
struct MeasuredEnd {
    double x = 0.0;  ///< nm of the board
    double y = 0.0;
    std::string layer;  ///< empty: none
    std::string net;    ///< empty: none
    std::string snap;   ///< what was caught: "centre", "edge", "free" …
    std::string
        item{};  ///< what was measured to, without its net: "track", "pad U1.7"; empty: a location, or not known
    bool operator==(const MeasuredEnd&) const = default;
};

/// What `from` and `to` are the ends of.
enum class MeasurementKind : std::uint8_t {
    Points,     ///< a distance from point to point
    Clearance,  ///< the clearance of two elements
    Spacing,    ///< the spacing at a location, from copper to copper; that of the two elements may be smaller
    Angle,      ///< the arms of an angle, which meet in `corner`
    Radius,     ///< a radius: `from` is the centre, `to` lies on the circle or arc
    Length,     ///< a path along the copper of a net
    Ring        ///< the annular ring: from the edge of a hole to that of the copper around it, or the other way
};
[[nodiscard]] const char* toString(MeasurementKind kind);  ///< "point to point", "edge to edge", "angle", …
/// Nothing for no name of a kind.
[[nodiscard]] std::optional<MeasurementKind> kindNamed(const std::string& name);

/// What of a path along a net lies on one layer until it changes to another.
struct MeasuredRun {
    std::string layer;
    double length = 0.0;             ///< nm
    std::vector<base::PointD> line;  ///< its course: corners in nm of the board, two at least
    bool operator==(const MeasuredRun&) const = default;
};

/// A path along the copper of a net.
struct MeasuredPath {
    std::vector<MeasuredRun> runs;  ///< one after the other; from one to the next through a plated hole
    std::size_t holeCount = 0;      ///< in which the layer changes
    double holeHeight = 0.0;        ///< nm, of all of them
    bool operator==(const MeasuredPath&) const = default;

    [[nodiscard]] double length() const;  ///< nm, holes included
    /// In the order in which they are met.
    [[nodiscard]] std::vector<std::pair<std::string, double>> perLayer() const;
};

/// Something that the user measured. In a session file:
///
///     {"name": "A", "step": "pcb", "kind": "edge to edge",
///      "from": {"at_nm": [0, 0], "layer": "TOP", "net": "GND", "snap": "edge", "item": "pad U1.7"}, "to": {…},
///      "dz_nm": 0, "overlap_nm": 0, "notes": ["both are of net GND"], "shown": true}
///
/// one measured in a plan also has "planar": true, an angle "corner": {…}, a length along a net
///
///     "path": {"runs": [{"layer": "TOP", "length_nm": 1000, "line_nm": [[0, 0], [1000, 0]]}], "holes": 1,
///              "hole_height_nm": 1500}
struct Measurement {
    std::string name;
    std::string step;  ///< the one it was measured in
    MeasurementKind kind = MeasurementKind::Points;
    MeasuredEnd from{};
    MeasuredEnd to{};
    double dz = 0.0;                      ///< nm between the faces of the two layers that face each other; not below 0
    double overlap = 0.0;                 ///< nm, of elements that overlap: by that much at least
    std::optional<MeasuredEnd> corner{};  ///< of an angle, and of nothing else
    std::optional<MeasuredPath> path{};   ///< of a length, and of nothing else
    std::vector<std::string> notes{};     ///< what must be known to read it
    bool isShown = true;
    bool isPlanar = false;  ///< measured in a plan: the value is the distance as seen from above
    bool operator==(const Measurement&) const = default;

    [[nodiscard]] double dx() const { return to.x - from.x; }
    [[nodiscard]] double dy() const { return to.y - from.y; }
    [[nodiscard]] double distance() const;  ///< from end to end in space, nm
    [[nodiscard]] double value() const;     ///< of a distance: in the plane if it is planar, else in space; nm
    [[nodiscard]] double angleDeg() const;  ///< of an angle, as seen from above: 0 to 180
};

/// A table for other programs, a row each, in mm and mil. Cells that a kind does not have are empty.
[[nodiscard]] std::string measurementsCsv(const std::vector<Measurement>& measurements);

}  // namespace model
