#pragma once

#include <optional>
#include <string>
#include <vector>

#include "model/base/progress.h"
#include "model/base/result.h"
#include "model/geometry/edges.h"
#include "model/measure/items.h"

/// How far two items of a board are apart.
namespace model {

enum class Relation : std::uint8_t { Apart, Touching, Overlapping };
[[nodiscard]] const char* toString(Relation relation);  ///< "apart", "touching", "overlapping"

/// The shortest distance between two pieces, straight or through the stackup. Lengths in nm.
struct PieceDistance {
    Spacing spacing;        ///< in the plane; 0 with both ends in a common location if one lies over the other
    double dz = 0.0;        ///< between the faces that face each other; 0 where their heights meet
    double distance = 0.0;  ///< of spacing and dz together
    Piece from;             ///< of the first item
    Piece to;
    Relation relation = Relation::Apart;
    /// Overlapping: how far one would have to move in the plane so that they only touch (geometry/overlap.h); of items
    /// of several pieces that of the deepest pair.
    double overlap = 0.0;
    bool isOverlapExact = true;  ///< else they overlap by that much at least
};

/// The result. Elements are upright prisms, so the shortest distance in space is the spacing in the plane and the
/// difference of heights of one pair of pieces, exactly.
struct Separation {
    std::optional<PieceDistance> inPlane;  ///< as seen from above, whatever the layers
    std::optional<PieceDistance> onLayer;  ///< between pieces that lie on one layer; none: there is no common layer
    std::optional<PieceDistance> throughStackup;  ///< shortest in space; none: one of them has no heights
    /// Of a hole and copper that surrounds it, beside an overlap that says little: model::annularRing of the two, which
    /// a note says as well (kAnnularRing).
    std::optional<Spacing> annularRing;
    std::vector<std::string> notes;  ///< what must be known to read it, in plain words

    /// What people mean by "the distance": on one layer if there is one, else through the stackup, else from above.
    [[nodiscard]] const PieceDistance* main() const {
        return onLayer ? &*onLayer : throughStackup ? &*throughStackup : inPlane ? &*inPlane : nullptr;
    }
};

/// Of which distances to find how deep the items overlap. Of large planes that takes longer than all the rest; where it
/// is not asked for, `relation` says Apart.
enum class Depths : std::uint8_t { OfAll, OfMain };

/// How the note begins that says how wide an annular ring is.
inline constexpr const char* kAnnularRing = "annular ring ";

/// Measures two items. Holes count as filled as far as the drill reaches, copper that an NPTH takes away as there.
/// There is no number, but a note, if both are the same item, one is part of the other, or one covers nothing. The
/// cost follows what lies near the shortest distance, so nets of thousands of elements take milliseconds; equal input
/// gives equal output. Errors: Cancelled.
[[nodiscard]] base::Result<Separation> separationOf(const BoardIndex& index, const MeasureItem& a, const MeasureItem& b,
                                                    base::Progress& progress, Depths depths = Depths::OfAll);

/// The closest two pieces of both that lie on one layer, and whether they overlap is not asked: `relation` says Apart.
/// None if no layer is common to both, one covers nothing, or it was cancelled before two were found.
[[nodiscard]] std::optional<PieceDistance> closestOnLayer(const BoardIndex& index, const MeasureItem& a,
                                                          const MeasureItem& b, base::Progress& progress);

/// The stackup rows between two heights whose thickness the job does not state, for notes; empty if all are known. Of
/// layers beside each other, as solder mask and paste on the same copper, those lie between that lead from one height
/// to the other.
[[nodiscard]] std::vector<std::string> assumedBetween(const Document& board, Nm low, Nm high);
/// How the note begins that a height rests on assumed thicknesses.
inline constexpr const char* kHeightIsAssumed = "the height rests on assumed thicknesses: ";
/// What must be known to read the height between the faces of two layers that face each other; empty: nothing. Of two
/// layers of the board also where they meet, or one has no height.
[[nodiscard]] std::string noteOnHeight(const Document& board, ZRange a, ZRange b);
[[nodiscard]] std::string noteOnHeight(const Document& board, LayerId a, LayerId b);

}  // namespace model
