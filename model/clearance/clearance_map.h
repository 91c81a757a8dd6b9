#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "model/base/progress.h"
#include "model/base/result.h"
#include "model/clearance/layer_geometry.h"

/// How far every location of a layer is from copper.
namespace model {

/// Square cells laid over a part of the board, row by row from the lower left corner.
struct MapFrame {
    PointD corner;            ///< the lower left one of the first cell, nm
    double cell = 0.0;        ///< nm
    std::uint32_t width = 0;  ///< cells
    std::uint32_t height = 0;

    [[nodiscard]] std::size_t size() const { return std::size_t{width} * height; }
    [[nodiscard]] PointD centreOf(double column, double row) const {
        return {corner.x + (column + 0.5) * cell, corner.y + (row + 0.5) * cell};
    }
    bool operator==(const MapFrame&) const = default;
};

/// What a spacing lies between: the nearest net and the nearest other one, both of one copy of a step
/// (StepTree::copies). Invalid: copper without a net.
struct MapNets {
    std::uint32_t copy = 0;
    NetId nearest;
    NetId other;
};

/// The value at the centre of every cell in nm: 0 on copper, infinite beyond the reach it was made with.
struct ClearanceMap {
    MapFrame frame;
    std::vector<float> nm;      ///< exact to 0.5 nm, as 24 bits keep up to kMostMapReach
    std::vector<MapNets> nets;  ///< by cell, where `nm` lies between; empty unless MapDetail::Nets
};

enum class MapDetail { Distances, Nets };

inline constexpr double kMostMapReach = 10e6;
inline constexpr double kMostMapCell = 10e6;
inline constexpr std::size_t kMostMapCells = std::size_t{1} << 25;  ///< more than any picture shows

/// Errors: BadUsage for frames without cells, of more than kMostMapCells, of larger cells than kMostMapCell or beyond
/// base::kMaxCoordinate.
[[nodiscard]] base::Status checkFrame(const MapFrame& frame);

/// The copper of one layer, and what is asked about the locations around it. Made once per layer and request, then
/// called for any part of the board, from any thread. What counts as copper is copperGeometry's: plated holes are part
/// of it, copper that an NPTH takes away counts as there, copies of other steps are not.
class DistanceField {
public:
    enum class Kind {
        ToTargets,    ///< how far is the nearest target?
        BetweenNets,  ///< how large is the spacing here?
    };

    /// The exact distance to the nearest of some elements. Errors: BadUsage if none of them is copper of the layer.
    [[nodiscard]] static base::Result<DistanceField> toTargets(const Document& document, LayerId layer,
                                                               std::span<const ElementId> targets);
    /// The spacing at a location beside copper: how far the nearest net is, and the nearest other one, together.
    /// Between two edges that run side by side this is the same all across, their clearance; on the shortest path
    /// between any two nets it is the length of that path, and nowhere is it less than the smallest clearances there.
    /// Copper without a net belongs to the net that it touches, alone or by more such copper; the rest of it counts as
    /// one more net. Errors: BadUsage if there are no two nets on the layer, Cancelled.
    [[nodiscard]] static base::Result<DistanceField> betweenNets(const Document& document, LayerId layer,
                                                                 base::Progress& progress);

    [[nodiscard]] Kind kind() const { return m_kind; }
    [[nodiscard]] LayerId layer() const { return m_layer; }
    /// Around all that is measured to.
    [[nodiscard]] Box extent() const { return m_plane.extent(); }

    /// All values up to `reach` (nm, at most kMostMapReach). The cost follows the cells that are near enough, and edges
    /// in sight: blocks of cells keep only the edges that can be nearest to one of them. Over all cores, the same with
    /// any number of threads. Errors: those of checkFrame, Cancelled.
    [[nodiscard]] base::Result<ClearanceMap> map(const MapFrame& frame, double reach, base::Progress& progress,
                                                 MapDetail detail = MapDetail::Distances) const;
    /// The value at one location; infinite off the coordinates of boards.
    [[nodiscard]] double at(PointD location, double reach) const;

private:
    DistanceField(Kind kind, LayerId layer, LayerGeometry plane)
        : m_kind(kind), m_layer(layer), m_plane(std::move(plane)) {}

    Kind m_kind;
    LayerId m_layer;
    LayerGeometry m_plane;
    std::vector<std::uint32_t> m_groups;  ///< by figure: its net, or the one more; all 0 for targets
    std::uint32_t m_nets = 0;             ///< so many groups are nets
};

}  // namespace model
