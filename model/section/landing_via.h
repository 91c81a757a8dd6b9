#pragma once

#include <vector>

#include "model/section/section_piece.h"

/// Laser vias, which end on their target pad. No job says how they taper: it is assumed.
namespace model {

/// A laser via is so much of its drilled diameter wide where it lands, as carbon dioxide lasers leave it (70 to 90 %).
inline constexpr double kViaTaper = 0.8;

/// A round laser via, as a line passes it: one cone of copper that is open inside. It is as wide as drilled through the
/// copper that it enters, and narrows from there to its target pad, whose near face is its end. Its floor is plated as
/// thick as its wall.
struct LandingVia {
    double middle = 0.0;  ///< of the location nearest to its axis, along the line
    double beside = 0.0;  ///< how far the line passes its axis
    double radius = 0.0;  ///< as drilled, where it is entered
    double wall = 0.0;    ///< thickness of the plating; all of the radius: filled
    Nm entry = 0;         ///< outer face of the copper it enters
    Nm shoulder = 0;      ///< inner face of that copper
    Nm target = 0;        ///< near face of the target pad; below `entry` where it is drilled from the top
    double taper = kViaTaper;

    [[nodiscard]] double radiusAt(double z) const;
    /// Half of what the line cuts of the cone at this height; 0: nothing.
    [[nodiscard]] double outerHalf(double z) const;
    /// The same of what is open inside; the floor is not.
    [[nodiscard]] double innerHalf(double z) const;
};

/// Its copper, as pieces like `like`. Exact for lines through the axis; beside it curves become eight straight pieces.
[[nodiscard]] std::vector<SectionPiece> platingOf(const LandingVia& via, const SectionPiece& like);
/// What a bore as wide as drilled has taken out between `entry` and `target` but the cone leaves, as pieces like
/// `like`, which is of a substrate: only where that lies.
[[nodiscard]] std::vector<SectionPiece> besideVia(const LandingVia& via, const SectionPiece& like);

}  // namespace model
