#include "render/modelling/substrate_margins.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <span>

#include "model/base/parallel.h"
#include "render/modelling/area_loops.h"
#include "render/modelling/board_model.h"
#include "render/modelling/edge_grid.h"
#include "render/modelling/lets.h"

namespace render {
namespace {

/// With more windows than this in the substrate it is not worked out which of them areas lie around.
constexpr std::size_t kMostLoops = 512;

/// Lines closer than this, mm, lie on each other.
constexpr float kSlack = 2e-3F;

using Role = LayerInSubstrate::Role;

std::uint32_t kindOf(const shader::Let& let) {
    return let.meta & shader::kLetKindMask;
}

glm::vec2 startOf(const shader::Let& let) {
    return {let.p0, let.p1};
}

Box2 boxAround(const Loop& loop) {
    Box2 box;
    for (const glm::vec2& p : loop) {
        box.include(p);
    }
    return box;
}

bool isWithin(const Box2& box, glm::vec2 p) {
    return glm::all(glm::lessThanEqual(box.min, p)) && glm::all(glm::lessThanEqual(p, box.max));
}

Edge edgeOf(const Loop& loop, std::size_t i) {
    return {loop[i], loop[(i + 1) % loop.size()]};
}

/// Calls `visit(row)` for the area instances of a layer.
template <class Visit>
void forInstances(const BoardModel& model, std::size_t layer, const Visit& visit) {
    const LayerRun batches = model.areaBatchesOfLayer[layer];
    for (std::uint32_t b = batches.first; b < batches.first + batches.count; ++b) {
        const AreaBatch& batch = model.areaBatches[b];
        for (std::uint32_t i = 0; i < batch.instanceCount; ++i) {
            visit(model.instances[batch.firstInstance + i]);
        }
    }
}

template <class Visit>
void forClusters(const BoardModel& model, std::size_t layer, const Visit& visit) {
    const LayerRun run = model.clustersOfLayer[layer];
    for (std::uint32_t c = run.first; c < run.first + run.count; ++c) {
        visit(model.clusters[c]);
    }
}

template <class Visit>
void forLets(const BoardModel& model, const shader::Cluster& cluster, const Visit& visit) {
    for (std::uint32_t i = cluster.firstLet; i < cluster.firstLet + cluster.count; ++i) {
        visit(model.lets[i]);
    }
}

/// The straight holes and slots of a board: what fills the substrate's holes.
class Plugs {
public:
    Plugs(const BoardModel& model, const std::vector<std::size_t>& holeLayers) : m_lets(model.lets) {
        for (const std::size_t layer : holeLayers) {
            forClusters(model, layer, [&](const shader::Cluster& cluster) {
                for (std::uint32_t i = cluster.firstLet; i < cluster.firstLet + cluster.count; ++i) {
                    const shader::Let& let = m_lets[i];
                    if (kindOf(let) == shader::kLetStadium && (let.meta & shader::kLetBore) == 0) {
                        m_locations.push_back({0.5F * (let.p0 + let.p2), 0.5F * (let.p1 + let.p3), i});
                    }
                }
            });
        }
        std::ranges::sort(m_locations);
    }

    /// The layer of the hole that a round cutout comes from: they have the same centre to the last bit.
    [[nodiscard]] std::optional<std::uint32_t> layerOfCircle(const shader::Let& hole) const {
        for (auto location = std::ranges::lower_bound(m_locations, Location{hole.p0, hole.p1, 0});
             location != m_locations.end() && location->x == hole.p0 && location->y == hole.p1; ++location) {
            const shader::Let& plug = m_lets[location->let];
            const bool isRound = plug.p0 == plug.p2 && plug.p1 == plug.p3;
            if (isRound && std::abs(plug.p4 - hole.p5) < kSlack) {
                return plug.meta >> shader::kLetLayerShift;
            }
        }
        return std::nullopt;
    }

    /// The same for a loop of chords.
    [[nodiscard]] std::optional<std::uint32_t> layerOfLoop(const Loop& loop) const {
        constexpr float kChords = 0.06F;  // mm: so far chords may shift the middle
        const Box2 box = boxAround(loop);
        const glm::vec2 middle = 0.5F * (box.min + box.max);
        for (auto location = std::ranges::lower_bound(m_locations, middle.x - kChords, {}, &Location::x);
             location != m_locations.end() && location->x <= middle.x + kChords; ++location) {
            if (std::abs(location->y - middle.y) <= kChords && fills(m_lets[location->let], loop)) {
                return m_lets[location->let].meta >> shader::kLetLayerShift;
            }
        }
        return std::nullopt;
    }

private:
    /// The middle of a plug.
    struct Location {
        float x;
        float y;
        std::uint32_t let;
        auto operator<=>(const Location&) const = default;
    };

    /// Do all corners lie on the outline of the hole?
    static bool fills(const shader::Let& plug, const Loop& loop) {
        const Edge middleLine{startOf(plug), {plug.p2, plug.p3}};
        return std::ranges::all_of(loop,
                                   [&](glm::vec2 p) { return std::abs(middleLine.distance(p) - plug.p4) < kSlack; });
    }

    std::span<const shader::Let> m_lets;
    std::vector<Location> m_locations;
};

/// A part of the substrate: its edges, and one point of each loop.
struct SubstratePart {
    std::vector<Edge> edges;
    Loop loopPoints;

    void add(const Loop& loop) {
        for (std::size_t i = 0; i < loop.size(); ++i) {
            edges.push_back(edgeOf(loop, i));
        }
        loopPoints.push_back(loop.front());
    }
};

/// A square around a round hole.
Loop squareAround(const shader::Let& hole) {
    const glm::vec2 c = startOf(hole);
    const float r = hole.p5;
    return {c + glm::vec2(-r, -r), c + glm::vec2(r, -r), c + glm::vec2(r, r), c + glm::vec2(-r, r)};
}

bool winds(const Loop& loop, glm::vec2 p) {
    bool isIn = false;
    for (std::size_t i = 0; i < loop.size(); ++i) {
        isIn ^= edgeOf(loop, i).isRightOf(p);
    }
    return isIn;
}

/// How far the content of layers keeps inside one part.
class SubstratePartMargins {
public:
    SubstratePartMargins(const BoardModel& model, const SubstratePart& part)
        : m_model(model), m_grid(part.edges), m_loopPoints(part.loopPoints) {}

    [[nodiscard]] float marginOf(std::size_t layer) const {
        const float lets = marginOfLets(layer);
        return lets < 0.0F ? lets : std::min(lets, marginOfAreas(layer));
    }

private:
    /// `inset` after something has been found `distance` inside, or outside unless it holds `point`.
    [[nodiscard]] float lessened(float margin, float distance, glm::vec2 point) const {
        return distance > 0.0F && m_grid.contains(point) ? std::min(margin, distance) : -1.0F;
    }

    [[nodiscard]] float marginOfLets(std::size_t layer) const {
        float margin = kLargestMargin;
        forClusters(m_model, layer, [&](const shader::Cluster& cluster) {
            if (margin < 0.0F || cluster.onlyAs != 0) {
                return;
            }
            const float distance = m_grid.distance(cluster.boxMin, cluster.boxMax, margin);
            if (distance >= margin) {
                margin = lessened(margin, distance, cluster.boxMin);
                return;
            }
            forLets(m_model, cluster, [&](const shader::Let& let) {
                if (margin >= 0.0F && kindOf(let) != shader::kLetHole) {
                    margin = marginOfLet(let, margin);
                }
            });
        });
        return margin;
    }

    [[nodiscard]] float marginOfLet(const shader::Let& let, float margin) const {
        if (kindOf(let) == shader::kLetArc) {
            const Box2 box = boxOf(let);
            return lessened(margin, m_grid.distance(box.min, box.max, margin), box.min);
        }
        constexpr float kDiagonal = 1.4142136F;
        const float reach = let.p4 * ((let.meta & shader::kLetSquarePen) != 0 ? kDiagonal : 1.0F);
        const float distance = m_grid.distance({startOf(let), {let.p2, let.p3}}, reach + margin) - reach;
        return lessened(margin, distance, startOf(let));
    }

    /// Along its walls; an area may also lie around a loop of the substrate without meeting it.
    [[nodiscard]] float marginOfAreas(std::size_t layer) const {
        if (m_loopPoints.size() > kMostLoops) {
            return m_model.areaBatchesOfLayer[layer].count == 0 ? kLargestMargin : -1.0F;
        }
        float margin = kLargestMargin;
        std::vector<std::uint8_t> isAround(m_loopPoints.size(), 0);
        forInstances(m_model, layer, [&](const shader::AreaInstance& instance) {
            if (margin < 0.0F || instance.onlyAs != 0) {
                return;
            }
            forLoops(m_model, instance, [&](const Loop& loop) {
                const Box2 box = boxAround(loop);
                margin = std::min(margin, marginOfLoop(loop, box, margin));
                for (std::size_t p = 0; p < m_loopPoints.size(); ++p) {
                    if (isWithin(box, m_loopPoints[p])) {
                        isAround[p] ^= static_cast<std::uint8_t>(winds(loop, m_loopPoints[p]));
                    }
                }
            });
        });
        // Solder mask ends at the very edge of the substrate, where rounding would decide.
        const bool isAroundAny = margin > kSlack && std::ranges::count(isAround, 1) > 0;
        return isAroundAny ? -1.0F : margin;
    }

    [[nodiscard]] float marginOfLoop(const Loop& loop, const Box2& box, float margin) const {
        if (margin > 2.0F * kSlack && m_grid.distance(box.min, box.max, margin) >= margin) {
            return m_grid.contains(loop.front()) ? margin : -1.0F;  // as all of it
        }
        for (std::size_t i = 0; i < loop.size() && margin >= 0.0F; ++i) {
            const Edge edge = edgeOf(loop, i);
            margin = std::min(margin, m_grid.distance(edge, std::max(margin, 2.0F * kSlack)));
            const bool isInside = m_grid.contains(edge.a) || m_grid.distance({edge.a, edge.a}, kSlack) < kSlack;
            if (!isInside || (margin <= kSlack && m_grid.isCrossedBy(edge.a, edge.b, kSlack))) {
                margin = -1.0F;
            }
        }
        return margin;
    }

    const BoardModel& m_model;
    EdgeGrid m_grid;
    Loop m_loopPoints;
};

class MarginFinder {
public:
    MarginFinder(const model::Document& document, const BoardModel& model)
        : m_model(model), m_result(document.layers.size()) {
        for (std::size_t i = 0; i < document.layers.size(); ++i) {
            const model::Layer& layer = document.layers[i];
            m_isBodies.push_back(layer.type == model::LayerType::ComponentBody ? 1 : 0);
            if (layer.type == model::LayerType::Body) {
                m_result[i].role = Role::Substrate;
            } else if (layer.type == model::LayerType::Drill || layer.type == model::LayerType::Rout) {
                m_holeLayers.push_back(i);
            }
        }
    }

    std::vector<LayerInSubstrate> run() {
        std::vector<SubstratePartMargins> parts;
        const Plugs plugs(m_model, m_holeLayers);
        for (std::size_t layer = 0; layer < m_result.size(); ++layer) {
            if (m_result[layer].role == Role::Substrate) {
                parts.emplace_back(m_model, partOf(plugs, layer));
            }
        }
        base::parallelFor(m_result.size(), [&](std::size_t layer) {
            const bool isEmpty =
                m_model.clustersOfLayer[layer].count == 0 && m_model.areaBatchesOfLayer[layer].count == 0;
            if (m_result[layer].role == Role::Substrate || (parts.empty() && !isEmpty) || m_isBodies[layer] != 0) {
                return;
            }
            float margin = kLargestMargin;
            for (const SubstratePartMargins& part : parts) {
                margin = margin < 0.0F ? margin : std::min(margin, part.marginOf(layer));
            }
            m_result[layer].marginMm = margin;
            m_result[layer].isMilled = isMilled(layer);
        });
        return std::move(m_result);
    }

private:
    [[nodiscard]] bool isMilled(std::size_t layer) const {
        bool isAny = false;
        forClusters(m_model, layer, [&](const shader::Cluster& cluster) { isAny = isAny || cluster.onlyAs != 0; });
        forInstances(m_model, layer, [&](const shader::AreaInstance& area) { isAny = isAny || area.onlyAs != 0; });
        return isAny;
    }

    SubstratePart partOf(const Plugs& plugs, std::size_t layer) {
        SubstratePart part;
        const auto addUnlessPlugged = [&](std::optional<std::uint32_t> plug, const Loop& loop) {
            if (plug) {
                m_result[*plug].role = Role::Plug;
            } else {
                part.add(loop);
            }
        };
        forInstances(m_model, layer, [&](const shader::AreaInstance& instance) {
            forLoops(m_model, instance, [&](const Loop& loop) { addUnlessPlugged(plugs.layerOfLoop(loop), loop); });
        });
        forClusters(m_model, layer, [&](const shader::Cluster& cluster) {
            forLets(m_model, cluster,
                    [&](const shader::Let& let) { addUnlessPlugged(plugs.layerOfCircle(let), squareAround(let)); });
        });
        return part;
    }

    const BoardModel& m_model;
    std::vector<LayerInSubstrate> m_result;
    std::vector<std::size_t> m_holeLayers;
    std::vector<std::uint8_t> m_isBodies;  ///< by layer: bodies, whose pins come out on the other side of the board
};

}  // namespace

std::vector<LayerInSubstrate> findSubstrateMargins(const model::Document& document, const BoardModel& model) {
    return MarginFinder(document, model).run();
}

}  // namespace render
