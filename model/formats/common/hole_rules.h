#pragma once

#include <map>
#include <optional>
#include <vector>

#include "model/board/document.h"

namespace model::formats {

/// How thick the copper in a plated hole is taken to be where the job does not say: 25 µm, the usual class 2 to 3
/// value. The drilled size is then the one that is drawn.
inline constexpr Nm kPlating = 25'000;

/// Where the pins of a board's components are.
class PinLocations {
public:
    PinLocations() = default;
    explicit PinLocations(std::vector<Point> pins);

    [[nodiscard]] bool isAnyWithin(Point centre, Nm reach) const;

private:
    std::vector<Point> m_pins;  ///< by x
};

/// What a file says of one hole, besides its size.
struct DrillHit {
    Plating plating = Plating::NotSaid;
    std::optional<Point> centre;  ///< where it may take a pin; none for paths and areas
    bool hasNet = false;
    bool isVia = false;  ///< if it is plated: whatever `plating` says
};

struct Hole {
    std::uint8_t flags = kHole;  ///< ElementFlag
    Nm drilled = 0;              ///< diameter or width of the hole in the substrate
    Nm finished = 0;             ///< what the plating leaves of it; as drilled for an NPTH
    bool isPlatingAssumed = false;
    bool isBarrelAssumed = false;
    bool isContradicted = false;  ///< the tools say otherwise than the hit, which is believed
};

/// What tools say together of whether they plate: nothing, the same, or this and that.
struct ToolsPlating {
    bool isPlated = false;
    bool isNonPlated = false;

    void include(const DrillTool& tool);
    [[nodiscard]] bool isClear() const { return isPlated != isNonPlated; }
};

/// What makes the features of one layer of drills or routed slots holes.
class HoleRules {
public:
    /// All must live as long as the rules.
    HoleRules(const Layer& layer, const std::vector<DrillTool>& tools, const PinLocations& pins);

    /// Plated as the hit says, else as the tools of that size or of the whole layer say, else by the layer: drills are
    /// plated, but for those of a single copper layer, routed slots are not. Back-drills are never plated. A plated
    /// hole is a via by the hit, then by the same sources; where these are silent, a net without a pin makes it one.
    /// Its barrel follows from the tool's drilled and finished size where they differ. On one thread at a time.
    [[nodiscard]] Hole hole(const DrillHit& hit, Nm size) const;
    /// A routed path is one long hole; each track of a drill layer is a slot of its own.
    [[nodiscard]] bool joinsTracks() const { return m_layer.type == LayerType::Rout; }

private:
    /// The tools that fit a size.
    struct ToolsOfSize {
        ToolsPlating plating;
        bool hasVia = false;
        bool hasPlated = false;             ///< that is no via
        const DrillTool* plated = nullptr;  ///< the best for a plated hole, if any
    };
    [[nodiscard]] const ToolsOfSize& toolsOf(Nm size) const;
    [[nodiscard]] bool isPlated(const DrillHit& hit, const ToolsOfSize& tools, Hole& hole) const;
    [[nodiscard]] static bool isVia(const DrillHit& hit, const ToolsOfSize& tools, bool hasPin);

    const Layer& m_layer;
    const std::vector<DrillTool>& m_tools;
    const PinLocations& m_pins;
    ToolsPlating m_all;
    mutable std::map<Nm, ToolsOfSize> m_ofSize;  ///< boards have few sizes and many holes
};

}  // namespace model::formats
