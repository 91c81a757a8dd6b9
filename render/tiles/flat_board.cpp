#include "render/tiles/flat_board.h"

#include <algorithm>
#include <bit>
#include <cmath>

#include "render/tiles/outline_scan.h"

namespace render {

namespace {

using shader::Let;

constexpr glm::dvec2 kUnmoved[] = {{0.0, 0.0}};

bool has(std::uint32_t flags, std::uint32_t flag) {
    return (flags & flag) != 0;
}

/// pixel = turn * mm + shift.
struct Affine {
    glm::dmat2 turn{1.0};
    glm::dvec2 shift{0.0};
    double scale = 1.0;  ///< pixels per mm

    [[nodiscard]] glm::dvec2 operator()(glm::dvec2 mm) const { return turn * mm + shift; }
};

Affine placeOf(const shader::AreaInstance& instance) {
    const double c = instance.cosSin.x;
    const double s = instance.cosSin.y;
    const double sign = instance.isMirrored != 0 ? -1.0 : 1.0;
    return {{{sign * c, -s}, {sign * s, c}}, instance.origin, 1.0};
}

/// Around a box, turned.
Box2 boxOf(const Affine& map, const Box2& box) {
    Box2 all;
    for (const float x : {box.min.x, box.max.x}) {
        for (const float y : {box.min.y, box.max.y}) {
            all.include(glm::vec2(map(glm::dvec2(x, y))));
        }
    }
    return all;
}

bool overlap(const Box2& a, const Box2& b) {
    return a.min.x <= b.max.x && b.min.x <= a.max.x && a.min.y <= b.max.y && b.min.y <= a.max.y;
}

/// A tile with room for what is moved, in the coordinates of what is mapped to it.
Box2 reachOf(const Affine& map) {
    constexpr double kRoom = 3.0;
    const glm::dmat2 back = glm::inverse(map.turn);
    Box2 box;
    for (const double x : {-kRoom, kTilePixels + kRoom}) {
        for (const double y : {-kRoom, kTilePixels + kRoom}) {
            box.include(glm::vec2(back * (glm::dvec2(x, y) - map.shift)));
        }
    }
    return box;
}

/// How far it reaches from the centre, back and forth along one axis of its cell (lib/cell.glsl).
glm::dvec2 cellReach(float packed) {
    const auto bits = std::bit_cast<std::uint32_t>(packed);
    return glm::dvec2(bits & 0xffffU, bits >> 16U) / double{shader::kCellUnitsPerMm};
}

/// As in lib/outline.glsl, in millimetres of the let's step.
class Arc {
public:
    explicit Arc(const Let& let)
        : m_centre(let.p0, let.p1),
          m_radius(let.p2),
          m_halfWidth(let.p5),
          m_middle(atAngle(let.p3 + 0.5 * let.p4)),
          m_end(atAngle(0.5 * std::abs(double{let.p4}))),
          m_from(m_radius * atAngle(let.p3)),
          m_to(m_radius * atAngle(double{let.p3} + double{let.p4})) {}

    [[nodiscard]] bool contains(glm::dvec2 place) const {
        const glm::dvec2 q = place - m_centre;
        const glm::dvec2 local(glm::dot(q, m_middle), std::abs(glm::dot(q, glm::dvec2(-m_middle.y, m_middle.x))));
        if (local.y * m_end.x <= local.x * m_end.y) {
            return std::abs(glm::length(q) - m_radius) <= m_halfWidth;
        }
        return std::min(glm::length(q - m_from), glm::length(q - m_to)) <= m_halfWidth;
    }

private:
    static glm::dvec2 atAngle(double angle) { return {std::cos(angle), std::sin(angle)}; }

    glm::dvec2 m_centre;
    double m_radius;
    double m_halfWidth;
    glm::dvec2 m_middle;  ///< the direction of the arc's middle, and, as an angle from it, of its ends
    glm::dvec2 m_end;
    glm::dvec2 m_from;
    glm::dvec2 m_to;
};

/// What an axis-parallel square pen passes; the same place.
bool isInSquareTrack(const Let& let, double radius, glm::dvec2 place) {
    const glm::dvec2 a(let.p0, let.p1);
    const glm::dvec2 b(let.p2, let.p3);
    const glm::dvec2 q = place - 0.5 * (a + b);
    const glm::dvec2 beyond = glm::abs(q) - 0.5 * glm::abs(b - a) - radius;
    if (std::max(beyond.x, beyond.y) > 0.0) {
        return false;
    }
    const glm::dvec2 d = b - a;
    const double length = glm::length(d);
    const glm::dvec2 normal = length > 0.0 ? glm::dvec2(-d.y, d.x) / length : glm::dvec2(0.0);
    return std::abs(glm::dot(q, normal)) <= radius * (std::abs(normal.x) + std::abs(normal.y)) || length == 0.0;
}

}  // namespace

/// Draws elements of one step of the board.
class FlatBoard::Drawing {
public:
    Drawing(const Affine& map, MaskTile& tile, OutlineScan& outline) : m_map(map), m_tile(tile), m_outline(outline) {}

    void let(const Let& let) {
        SampleScan scan(m_tile, has(let.meta, shader::kLetBore));
        const std::uint32_t kind = let.meta & shader::kLetKindMask;
        if (kind == shader::kLetArc) {
            arc(scan, let);
        } else if (kind == shader::kLetHole) {
            hole(scan, let);
        } else if (has(let.meta, shader::kLetSquarePen)) {
            square(scan, let);
        } else {
            scan.track(m_map({let.p0, let.p1}), m_map({let.p2, let.p3}), let.p4 * m_map.scale, let.p5 * m_map.scale);
        }
    }

    void area(const Step& step, const shader::AreaInstance& instance) {
        const Affine place = placeOf(instance);
        const Affine map{m_map.turn * place.turn, m_map(place.shift), m_map.scale};
        m_outline.begin(glm::determinant(map.turn) > 0.0);
        for (const AreaOutlines::Chain& chain : step.outlines.chainsOf(instance.shape)) {
            chainOf(step.outlines.pointsOf(chain), boxOf(map, chain.box), map);
        }
        m_outline.fill();
    }

private:
    void chainOf(std::span<const glm::vec2> points, const Box2& box, const Affine& map) {
        constexpr float kRoom = 4.0F;  // corners are moved by less, and boxes are floats
        constexpr float kEnd = kTilePixels + kRoom;
        if (box.max.y < -kRoom || box.min.y > kEnd || box.min.x > kEnd) {
            return;
        }
        if (box.max.x < -kRoom) {
            m_outline.edgesOnTheLeft(map(points.front()), map(points.back()));
            return;
        }
        glm::dvec2 from = map(points.front());
        for (const glm::vec2& point : points.subspan(1)) {
            const glm::dvec2 to = map(point);
            m_outline.edge(from, to);
            from = to;
        }
    }

    void arc(SampleScan& scan, const Let& let) {
        const glm::dmat2 back = glm::inverse(m_map.turn);
        const Arc arc(let);
        scan.annulus(m_map({let.p0, let.p1}), (let.p2 + let.p5) * m_map.scale, (let.p2 - let.p5) * m_map.scale,
                     [&](glm::dvec2 at) { return arc.contains(back * (at - m_map.shift)); });
    }

    void hole(SampleScan& scan, const Let& let) {
        const glm::dvec2 centre(let.p0, let.p1);
        const double t = let.p4;
        const glm::dvec2 along = glm::dvec2(1.0 - t * t, 2.0 * t) / (1.0 + t * t);
        const glm::dvec2 across(-along.y, along.x);
        const glm::dvec2 x = cellReach(let.p2);
        const glm::dvec2 y = cellReach(let.p3);
        const auto corner = [&](double u, double v) { return m_map(centre + u * along + v * across); };
        scan.cell({corner(-x.x, -y.x), corner(x.y, -y.x), corner(x.y, y.y), corner(-x.x, y.y)}, m_map(centre),
                  let.p5 * m_map.scale);
    }

    void square(SampleScan& scan, const Let& let) {
        const glm::dmat2 back = glm::inverse(m_map.turn);
        const glm::dvec2 a(let.p0, let.p1);
        const glm::dvec2 b(let.p2, let.p3);
        scan.annulus(
            m_map(0.5 * (a + b)), (0.5 * glm::length(b - a) + 1.5 * let.p4) * m_map.scale, 0.0, [&](glm::dvec2 at) {
                const glm::dvec2 place = back * (at - m_map.shift);
                return isInSquareTrack(let, let.p4, place) && !(let.p5 > 0.0F && isInSquareTrack(let, let.p5, place));
            });
    }

    Affine m_map;
    MaskTile& m_tile;
    OutlineScan& m_outline;
};

FlatBoard::FlatBoard(std::shared_ptr<const BoardModel> model) : m_model(std::move(model)) {
    m_steps.push_back(stepOf(*m_model));
    for (const BoardModel& step : m_model->steps) {
        m_steps.push_back(stepOf(step));
    }
    m_withBores.resize(m_model->layers.size());
    for (const Step& step : m_steps) {
        for (const Let& let : step.model->lets) {
            if (has(let.meta, shader::kLetBore)) {
                m_withBores[let.meta >> shader::kLetLayerShift] = true;
            }
        }
    }
    m_isDrawable = std::ranges::none_of(m_model->copies, &ModelCopy::isFlipped);
}

FlatBoard::Step FlatBoard::stepOf(const BoardModel& model) {
    Step step{&model, AreaOutlines(model), {}};
    step.boxOfInstance.reserve(model.instances.size());
    for (const shader::AreaInstance& instance : model.instances) {
        Box2 box;
        for (const AreaOutlines::Chain& chain : step.outlines.chainsOf(instance.shape)) {
            box.include(chain.box.min);
            box.include(chain.box.max);
        }
        step.boxOfInstance.push_back(box.min.x <= box.max.x ? boxOf(placeOf(instance), box) : box);
    }
    return step;
}

template <class Wanted>
bool FlatBoard::drawWanted(std::uint32_t layer, const PlaneMap& map, const Drawn& drawn, const Wanted& isWanted,
                           std::span<const glm::dvec2> moves, MaskTile& tile) const {
    const std::uint32_t leftOut = drawn.isFabricated ? shader::kOnlyAsDesigned : shader::kOnlyAsFabricated;
    bool isDrawn = false;
    OutlineScan outline(tile);
    for (const ModelCopy& copy : m_model->copies) {
        const Step& step = m_steps[copy.step];
        const BoardModel& model = *step.model;
        if (layer >= model.clustersOfLayer.size()) {
            continue;
        }
        const glm::dmat2 scale{{map.scale.x, 0.0}, {0.0, map.scale.y}};
        const Affine unmoved{scale * copy.rotation, map.scale * copy.origin + map.offset, std::abs(map.scale.x)};
        const Box2 reach = reachOf(unmoved);
        const auto stateOf = [&](std::uint32_t element) {
            const bool isKnown = copy.step < drawn.states.size() && element < drawn.states[copy.step].size();
            return isKnown ? drawn.states[copy.step][element] : kPlain;
        };
        const auto forMoves = [&](const auto& draw) {
            isDrawn = true;
            for (const glm::dvec2& move : moves) {
                Drawing drawing({unmoved.turn, unmoved.shift + move, unmoved.scale}, tile, outline);
                draw(drawing);
            }
        };
        const LayerRun clusters = model.clustersOfLayer[layer];
        for (std::uint32_t row = clusters.first; row < clusters.first + clusters.count; ++row) {
            const shader::Cluster& cluster = model.clusters[row];
            if (has(cluster.onlyAs, leftOut) || !overlap(reach, {cluster.boxMin, cluster.boxMax})) {
                continue;
            }
            for (std::uint32_t i = cluster.firstLet; i < cluster.firstLet + cluster.count; ++i) {
                if (isWanted(stateOf(model.lets[i].element))) {
                    forMoves([&](Drawing& drawing) { drawing.let(model.lets[i]); });
                }
            }
        }
        const LayerRun batches = model.areaBatchesOfLayer[layer];
        for (std::uint32_t row = batches.first; row < batches.first + batches.count; ++row) {
            const AreaBatch& batch = model.areaBatches[row];
            for (std::uint32_t i = batch.firstInstance; i < batch.firstInstance + batch.instanceCount; ++i) {
                const shader::AreaInstance& instance = model.instances[i];
                if (overlap(reach, step.boxOfInstance[i]) && !has(instance.onlyAs, leftOut) &&
                    isWanted(stateOf(instance.element))) {
                    forMoves([&](Drawing& drawing) { drawing.area(step, instance); });
                }
            }
        }
    }
    return isDrawn;
}

bool FlatBoard::draw(std::uint32_t layer, const PlaneMap& map, const Drawn& drawn, MaskTile& tile) const {
    return drawWanted(
        layer, map, drawn, [](ElementState state) { return (state & kHidden) == 0; }, kUnmoved, tile);
}

bool FlatBoard::drawStandingOut(std::uint32_t layer, const PlaneMap& map, const Drawn& drawn, ElementState state,
                                std::span<const glm::dvec2> moves, MaskTile& tile) const {
    return drawWanted(
        layer, map, drawn, [state](ElementState own) { return own == state; }, moves, tile);
}

}  // namespace render
