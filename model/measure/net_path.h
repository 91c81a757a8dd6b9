#pragma once

#include <string>
#include <utility>
#include <vector>

#include "model/base/progress.h"
#include "model/base/result.h"
#include "model/measure/items.h"

/// How long the copper of a net is from one location to another.
namespace model {

/// A straight or curved piece of the path.
struct PathLeg {
    enum class Kind : std::uint8_t {
        Track,  ///< along the middle line of a track
        Pad,    ///< inside of a pad or hole, to or from its centre, or a step from one middle line to the next
        Area,   ///< straight through an area: a guess, current spreads there
        Hole    ///< up or down a plated hole
    };
    Kind kind = Kind::Track;
    LayerId layer;         ///< of the board; holes: where it leaves
    BoardElement element;  ///< that carries it
    PointD from;           ///< nm of the board
    PointD to;
    double length = 0.0;     ///< nm
    double fromAlong = 0.0;  ///< tracks: length of the middle line up to `from`
    double toAlong = 0.0;
};

struct NetPath {
    double length = 0.0;                               ///< all of it, heights of holes included
    std::vector<std::pair<LayerId, double>> perLayer;  ///< in the plane, by layer, without holes
    std::size_t holeCount = 0;                         ///< plated holes in which the path changes its layer
    double holeHeight = 0.0;    ///< of those, from the middle of one layer's copper to that of the next
    double areaLength = 0.0;    ///< how much of it runs straight through areas
    double padLength = 0.0;     ///< how much of it leaves middle lines: straight through pads, or to the next track
    std::vector<PathLeg> legs;  ///< in order; those of no length left out
    std::vector<std::string> notes;  ///< what must be known to read it
};

/// The shortest path over the copper of a net between two locations or elements of it. It follows the middle lines of
/// tracks and goes from centre to centre of pads and holes; tracks that touch are joined where their middles are
/// nearest. Through areas it goes straight from one contact to the next, over their holes too. Both that and where it
/// leaves middle lines within pads, or from track to track, is an estimate and in the notes. The ends: an element
/// counts with its centre, or if it is a track or an area wherever it is left; a part or net with all of its elements;
/// a location with the copper of the net that covers it (on its layer, if it has one). Errors: BadUsage if an end is
/// not on the net, or no copper leads from one to the other; Cancelled.
[[nodiscard]] base::Result<NetPath> pathAlong(const BoardIndex& index, NetOfCopy net, const MeasureItem& from,
                                              const MeasureItem& to, base::Progress& progress);

/// The note that the heights of holes rest on assumed thicknesses.
inline constexpr const char* kHolesAreAssumed = "the heights of holes rest on assumed thicknesses";
/// It, where they do on this board; else nothing.
[[nodiscard]] std::string noteOnHoles(const Document& board);

/// A leg as it is drawn: corners from `from` to `to`, along bends and arcs of the track, these in steps of 6 degrees.
[[nodiscard]] std::vector<PointD> courseOf(const BoardIndex& index, const PathLeg& leg);

}  // namespace model
