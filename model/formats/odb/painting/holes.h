#pragma once

#include <span>
#include <vector>

#include "model/formats/odb/components/components.h"
#include "model/formats/odb/features/features.h"
#include "model/formats/odb/stackup/matrix.h"

namespace model::odb {

/// How thick the copper in a plated hole is taken to be where the tools do not tell: 25 µm, the usual class 2 to 3
/// value. The drilled size is then the symbol's.
inline constexpr Nm kPlating = 25'000;

/// Where the pins of a step's components are.
class PinLocations {
public:
    PinLocations() = default;
    explicit PinLocations(std::vector<Point> pins);

    [[nodiscard]] bool isAnyWithin(Point centre, Nm reach) const;

private:
    std::vector<Point> m_pins;  ///< by x
};

/// What a feature of a drill or rout layer makes.
struct Hole {
    std::uint8_t flags = kHole;  ///< ElementFlag
    Nm drilled = 0;              ///< diameter or width of the hole in the laminate
    Nm open = 0;                 ///< what the plating leaves of it; as drilled for a bare hole
    bool isPlatingAssumed = false;
    bool isWallAssumed = false;
    bool isContradicted = false;  ///< the tools say otherwise than the feature, which is believed
};

/// What makes the features of one drill or rout layer holes (odb-notes, Drills).
class HoleRules {
public:
    /// All must live as long as the rules.
    HoleRules(const MatrixLayer& layer, const std::vector<DrillTool>& tools, const PinLocations& pins)
        : m_layer(layer), m_tools(tools), m_pins(pins) {}

    /// Plated by the feature's .drill attribute, else by the tools of that size or of the whole layer, else by the
    /// layer: drills are plated, routs are not. Back-drills are never plated. A plated hole is a via by the same
    /// sources; where these are silent, a net without a pin makes it one. Its wall follows from the tool's drilled and
    /// finished size where they differ.
    [[nodiscard]] Hole hole(const Feature& feature, Nm size, bool hasNet) const;
    /// A rout path is one long hole; each stroke of a drill layer is a slot of its own.
    [[nodiscard]] bool joinsStrokes() const { return m_layer.type == LayerType::Rout; }

private:
    [[nodiscard]] bool isPlated(const Feature& feature, Nm size, Hole& hole) const;
    [[nodiscard]] bool isVia(const Feature& feature, Nm size, bool hasPin, bool hasNet) const;
    void setWall(Nm size, Hole& hole) const;

    const MatrixLayer& m_layer;
    const std::vector<DrillTool>& m_tools;
    const PinLocations& m_pins;
};

}  // namespace model::odb
