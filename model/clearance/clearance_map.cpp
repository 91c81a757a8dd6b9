#include "model/clearance/clearance_map.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <limits>
#include <numbers>

#include "model/base/disjoint_sets.h"
#include "model/base/parallel.h"
#include "model/figures/covered_runs.h"
#include "model/figures/distance.h"

namespace model {

namespace {

constexpr float kFar = std::numeric_limits<float>::infinity();
constexpr double kEndless = std::numeric_limits<double>::infinity();
/// Cells along a side of what one task works on: so few that edges in sight are few, so many that searching for them
/// costs little.
constexpr std::uint32_t kTile = 32;

/// An edge that may be the nearest one.
struct NearEdge {
    const Edge* edge = nullptr;
    std::uint32_t group = 0;
    double distance = 0.0;  ///< from the middle of the block under work
};

double distanceTo(const Edge& edge, PointD p) {
    const PointD on = nearestOn(edge, p);
    const double dx = p.x - on.x;
    const double dy = p.y - on.y;
    return std::sqrt(dx * dx + dy * dy) - edge.pen;
}

/// The nearest edge and the nearest one of another group.
class TwoNearest {
public:
    void offer(std::uint32_t group, double distance) {
        if (distance < m_first) {
            if (group != m_group) {
                m_second = m_first;
                m_otherGroup = m_group;
            }
            m_first = distance;
            m_group = group;
        } else if (group != m_group && distance < m_second) {
            m_second = distance;
            m_otherGroup = group;
        }
    }
    [[nodiscard]] double first() const { return m_first; }
    [[nodiscard]] double second() const { return m_second; }
    [[nodiscard]] std::uint32_t firstGroup() const { return m_group; }
    [[nodiscard]] std::uint32_t secondGroup() const { return m_otherGroup; }

private:
    double m_first = kEndless;
    double m_second = kEndless;
    std::uint32_t m_group = 0;
    std::uint32_t m_otherGroup = 0;
};

/// Cells first … first + size - 1 of both directions, as far as the map reaches.
struct Block {
    std::uint32_t column = 0;
    std::uint32_t row = 0;
    std::uint32_t size = 0;
};

/// Fills a map, block by block. A block is halved until it is a cell; each passes on the edges that can be nearest to
/// one of its cells. What makes that sure is that no distance changes by more than the distance one moves.
class MapFiller {
public:
    /// Groups from `nets` on have no net.
    MapFiller(const LayerGeometry& plane, std::span<const std::uint32_t> groups, std::uint32_t nets, bool isBetween,
              double reach, ClearanceMap& map)
        : m_plane(plane), m_groups(groups), m_nets(nets), m_isBetween(isBetween), m_reach(reach), m_map(map) {}

    /// Writes 0 to the cells of a row that lie inside of areas. Before the tiles.
    void coverRow(std::uint32_t row) const {
        const MapFrame& frame = m_map.frame;
        const PointD left = frame.centreOf(0, row);
        const double right = frame.centreOf(frame.width - 1.0, row).x;
        std::vector<CoveredRun> runs;
        m_plane.visitNear(boxAround(left, {right, left.y}), 0.0, [&](std::uint32_t figure) {
            addCoveredRuns(m_plane.figures(), figure, left.y, right, runs);
        });
        const auto cells = std::span(m_map.nm).subspan(std::size_t{row} * frame.width, frame.width);
        for (const CoveredRun& run : runs) {
            const auto columnAt = [&](double x) {
                return static_cast<std::size_t>(
                    std::clamp(std::ceil((x - left.x) / frame.cell), 0.0, 1.0 * frame.width));
            };
            const std::size_t first = columnAt(run.from);
            std::fill(cells.begin() + static_cast<std::ptrdiff_t>(first),
                      cells.begin() + static_cast<std::ptrdiff_t>(std::max(first, columnAt(run.to))), 0.0F);
        }
    }

    void fillTile(const Block& tile) {
        if (isCovered(tile)) {
            return;
        }
        m_near.clear();
        gather(tile);
        fill(tile, 0, m_near.size());
    }

private:
    [[nodiscard]] static Box boxAround(PointD a, PointD b) {
        return {{static_cast<Nm>(std::floor(a.x)), static_cast<Nm>(std::floor(a.y))},
                {static_cast<Nm>(std::ceil(b.x)), static_cast<Nm>(std::ceil(b.y))}};
    }

    [[nodiscard]] std::uint32_t endColumn(const Block& block) const {
        return std::min(block.column + block.size, m_map.frame.width);
    }
    [[nodiscard]] std::uint32_t endRow(const Block& block) const {
        return std::min(block.row + block.size, m_map.frame.height);
    }
    [[nodiscard]] float& cellAt(std::uint32_t column, std::uint32_t row) const {
        return m_map.nm[std::size_t{row} * m_map.frame.width + column];
    }
    [[nodiscard]] PointD middleOf(const Block& block) const {
        return m_map.frame.centreOf(block.column + (block.size - 1) / 2.0, block.row + (block.size - 1) / 2.0);
    }
    /// From the middle of a block to its farthest centre of a cell.
    [[nodiscard]] double radiusOf(const Block& block) const {
        return (block.size - 1) / 2.0 * m_map.frame.cell * std::numbers::sqrt2;
    }

    [[nodiscard]] bool isCovered(const Block& block) const {
        for (std::uint32_t row = block.row; row < endRow(block); ++row) {
            for (std::uint32_t column = block.column; column < endColumn(block); ++column) {
                if (cellAt(column, row) != 0.0F) {
                    return false;
                }
            }
        }
        return true;
    }

    void write(const Block& block, float value) const {
        for (std::uint32_t row = block.row; row < endRow(block); ++row) {
            for (std::uint32_t column = block.column; column < endColumn(block); ++column) {
                float& cell = cellAt(column, row);
                cell = cell == 0.0F ? 0.0F : value;  // inside of an area it stays 0
            }
        }
    }

    void writeNets(const Block& cell, const TwoNearest& nearest) const {
        if (!m_map.nets.empty()) {
            const auto net = [&](std::uint32_t group) { return group < m_nets ? NetId{std::size_t{group}} : NetId{}; };
            m_map.nets[std::size_t{cell.row} * m_map.frame.width + cell.column] = {0, net(nearest.firstGroup()),
                                                                                   net(nearest.secondGroup())};
        }
    }

    /// How far edges may be from the middle of a block and still matter to a cell of it.
    [[nodiscard]] double needOf(const TwoNearest& nearest, double radius) const {
        const double known = m_isBetween ? nearest.second() : nearest.first();
        return std::min(std::max(known, 0.0) + radius, m_reach) + radius;
    }

    /// Puts the edges that matter to a tile into m_near, searching farther and farther until it is sure that there are
    /// no others.
    void gather(const Block& tile) {
        const PointD middle = middleOf(tile);
        const double radius = radiusOf(tile);
        for (double searched = 2 * radius + m_map.frame.cell;;) {
            m_near.clear();
            TwoNearest nearest;
            const Box spot = boxAround(middle, middle);
            const Box box = spot.grownBy(static_cast<Nm>(searched) + 1);
            m_plane.visitNear(spot, searched, [&](std::uint32_t figure) {
                visitEdges(m_plane.figures(), figure, box, [&](const Edge& edge) {
                    m_near.push_back({&edge, m_groups[figure], distanceTo(edge, middle)});
                    nearest.offer(m_groups[figure], std::max(m_near.back().distance, 0.0));
                });
            });
            const double need = needOf(nearest, radius);
            if (searched >= need) {
                return;
            }
            searched = std::min(need, 2 * searched);
        }
    }

    /// Edges first … end - 1 of m_near are all that matter to the block.
    void fill(const Block& block, std::size_t first, std::size_t end) {
        const PointD middle = middleOf(block);
        const double radius = radiusOf(block);
        TwoNearest nearest;
        double deepest = kEndless;
        for (std::size_t i = first; i < end; ++i) {
            NearEdge& near = m_near[i];
            near.distance = distanceTo(*near.edge, middle);
            deepest = std::min(deepest, near.distance);
            nearest.offer(near.group, std::max(near.distance, 0.0));
        }
        if (block.size == 1) {
            writeNets(block, nearest);
            return write(block, valueOf(nearest));
        }
        if (deepest <= -radius) {
            return write(block, 0.0F);  // all under one track
        }
        if (isBeyond(nearest, radius)) {
            return;
        }
        divide(block, first, end, needOf(nearest, radius));
    }

    [[nodiscard]] float valueOf(const TwoNearest& nearest) const {
        const bool isOnCopper = nearest.first() <= 0.0;
        const double value = isOnCopper ? 0.0 : m_isBetween ? nearest.first() + nearest.second() : nearest.first();
        return value <= m_reach ? static_cast<float>(value) : kFar;
    }

    /// Is no cell of the block near enough, nor on copper?
    [[nodiscard]] bool isBeyond(const TwoNearest& nearest, double radius) const {
        const double least = m_isBetween ? nearest.first() + nearest.second() - 2 * radius : nearest.first() - radius;
        return nearest.first() > radius && least > m_reach;
    }

    void divide(const Block& block, std::size_t first, std::size_t end, double need) {
        const std::size_t start = m_near.size();
        for (std::size_t i = first; i < end; ++i) {
            if (m_near[i].distance <= need) {
                m_near.push_back(NearEdge(m_near[i]));
            }
        }
        const std::uint32_t half = block.size / 2;
        for (const auto& [right, up] :
             {std::pair(0U, 0U), std::pair(half, 0U), std::pair(0U, half), std::pair(half, half)}) {
            const Block quarter{block.column + right, block.row + up, half};
            if (quarter.column < m_map.frame.width && quarter.row < m_map.frame.height && !isCovered(quarter)) {
                fill(quarter, start, m_near.size());
            }
        }
        m_near.resize(start);
    }

    const LayerGeometry& m_plane;
    std::span<const std::uint32_t> m_groups;
    std::uint32_t m_nets;
    bool m_isBetween;
    double m_reach;
    ClearanceMap& m_map;
    std::vector<NearEdge> m_near;  ///< those of a block behind those of the block around it
};

constexpr std::size_t kFiguresPerTask = 64;

/// A figure without a net and what it touches.
struct Touch {
    std::uint32_t unassigned = 0;
    std::uint32_t other = 0;
};

std::vector<Touch> touchesOf(const LayerGeometry& plane, std::span<const std::uint32_t> unassigned) {
    std::vector<Touch> touches;
    for (const std::uint32_t row : unassigned) {
        plane.visitNear(plane.figures().box(row), kTouchNm, [&](std::uint32_t other) {
            if (other != row && spacingBetween(plane.figures(), row, plane.figures(), other, kTouchNm)) {
                touches.push_back({row, other});
            }
        });
    }
    return touches;
}

std::vector<Touch> allTouches(const LayerGeometry& plane, std::span<const std::uint32_t> unassigned,
                              base::Progress& progress) {
    std::vector<std::vector<Touch>> parts((unassigned.size() + kFiguresPerTask - 1) / kFiguresPerTask);
    base::parallelFor(parts.size(), [&](std::size_t task) {
        if (!progress.isCancelled()) {
            const std::size_t first = task * kFiguresPerTask;
            parts[task] =
                touchesOf(plane, unassigned.subspan(first, std::min(kFiguresPerTask, unassigned.size() - first)));
        }
    });
    std::vector<Touch> touches;
    for (const std::vector<Touch>& part : parts) {
        touches.insert(touches.end(), part.begin(), part.end());
    }
    return touches;
}

/// The net of every figure of a layer geometry as a row of Document::nets. Figures without a net (text, shapes,
/// teardrops) take the net that they touch, directly or by more such figures, of several the lowest; those that touch
/// none take one row more than there are nets. Over all cores, the same with any number of threads; partial once
/// `progress` is cancelled.
std::vector<std::uint32_t> netsByTouch(const Document& document, const LayerGeometry& plane, base::Progress& progress) {
    const auto none = static_cast<std::uint32_t>(document.nets.size());
    std::vector<std::uint32_t> nets(plane.size());
    std::vector<std::uint32_t> unassigned;
    for (std::size_t row = 0; row < plane.size(); ++row) {
        const NetId net = document.elements.net[plane.elementOf(row).row()];
        nets[row] = net.isValid() ? static_cast<std::uint32_t>(net.row()) : none;
        if (!net.isValid()) {
            unassigned.push_back(static_cast<std::uint32_t>(row));
        }
    }
    const std::vector<Touch> touches = allTouches(plane, unassigned, progress);
    DisjointSets islands(plane.size());  // of loose figures; the others stay alone
    for (const Touch& touch : touches) {
        if (nets[touch.other] == none) {
            islands.join(touch.unassigned, touch.other);
        }
    }
    std::vector<std::uint32_t> ofIsland(plane.size(), none);
    for (const Touch& touch : touches) {
        std::uint32_t& net = ofIsland[islands.find(touch.unassigned)];
        net = std::min(net, nets[touch.other]);
    }
    for (const std::uint32_t row : unassigned) {
        nets[row] = ofIsland[islands.find(row)];
    }
    return nets;
}

base::Error refused(std::string text) {
    return {base::ErrorCode::BadUsage, std::move(text)};
}

}  // namespace

base::Status checkFrame(const MapFrame& frame) {
    if (frame.size() == 0 || !(frame.cell > 0.0)) {
        return refused("a map needs at least one cell");
    }
    if (frame.size() > kMostMapCells) {
        return refused("a map of " + std::to_string(frame.width) + " x " + std::to_string(frame.height) +
                       " cells is too large: " + std::to_string(kMostMapCells) + " at most");
    }
    const PointD end = frame.centreOf(frame.width, frame.height);
    const double farthest = std::max({-frame.corner.x, -frame.corner.y, end.x, end.y});
    if (!(frame.cell <= kMostMapCell && farthest <= base::kMaxCoordinate)) {
        return refused("a map must lie where boards can be, in cells of 10 mm at most");
    }
    return base::Done{};
}

base::Result<DistanceField> DistanceField::toTargets(const Document& document, LayerId layer,
                                                     std::span<const ElementId> targets) {
    std::vector<bool> isTarget(document.elements.size());
    for (const ElementId target : targets) {
        isTarget[target.row()] = true;
    }
    DistanceField field(Kind::ToTargets, layer,
                        copperGeometry(document, layer, [&](ElementId element) { return isTarget[element.row()]; }));
    if (field.m_plane.size() == 0) {
        return refused("the selection has no copper on " + document.layer(layer).name);
    }
    field.m_groups.resize(field.m_plane.size());
    return field;
}

base::Result<DistanceField> DistanceField::betweenNets(const Document& document, LayerId layer,
                                                       base::Progress& progress) {
    DistanceField field(Kind::BetweenNets, layer, copperGeometry(document, layer));
    field.m_groups = netsByTouch(document, field.m_plane, progress);
    field.m_nets = static_cast<std::uint32_t>(document.nets.size());
    if (progress.isCancelled()) {
        return base::Error{base::ErrorCode::Cancelled, "cancelled"};
    }
    const auto isOther = [&](std::uint32_t group) { return group != field.m_groups.front(); };
    if (field.m_groups.empty() || std::ranges::none_of(field.m_groups, isOther)) {
        return refused(document.layer(layer).name + " has no copper of two nets");
    }
    return field;
}

base::Result<ClearanceMap> DistanceField::map(const MapFrame& frame, double reach, base::Progress& progress,
                                              MapDetail detail) const {
    RETURN_IF_ERROR(checkFrame(frame));
    progress.beginPhase("Measuring distances");
    ClearanceMap map{frame, std::vector<float>(frame.size(), kFar),
                     std::vector<MapNets>(detail == MapDetail::Nets ? frame.size() : 0)};
    const MapFiller filler(m_plane, m_groups, m_nets, m_kind == Kind::BetweenNets,
                           std::clamp(reach, 0.0, kMostMapReach), map);
    base::parallelFor(frame.height, [&](std::size_t row) {
        if (!progress.isCancelled()) {
            filler.coverRow(static_cast<std::uint32_t>(row));
        }
    });
    const std::uint32_t across = (frame.width + kTile - 1) / kTile;
    const std::uint32_t tiles = across * ((frame.height + kTile - 1) / kTile);
    std::atomic<std::uint32_t> done = 0;
    base::parallelFor(tiles, [&](std::size_t i) {
        if (!progress.isCancelled()) {
            const auto tile = static_cast<std::uint32_t>(i);
            MapFiller(filler).fillTile({tile % across * kTile, tile / across * kTile, kTile});
            progress.setFraction(static_cast<float>(++done) / static_cast<float>(tiles));
        }
    });
    if (progress.isCancelled()) {
        return base::Error{base::ErrorCode::Cancelled, "cancelled"};
    }
    return map;
}

double DistanceField::at(PointD location, double reach) const {
    base::Progress progress;
    const base::Result<ClearanceMap> cell = map({{location.x - 0.5, location.y - 0.5}, 1.0, 1, 1}, reach, progress);
    return cell ? static_cast<double>(cell->nm.front()) : kEndless;
}

}  // namespace model
