#include "model/formats/gerber/image/primitives.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

#include "model/geometry/boolean.h"
#include "model/geometry/loops/edge_union.h"
#include "model/geometry/loops/region_booleans.h"
#include "model/geometry/outlines.h"
#include "model/geometry/region.h"

namespace model::gerber {

namespace {

constexpr std::size_t kMostCorners = 100'000;
constexpr int kMostRings = 100;

/// Turns points counter-clockwise about the macro's origin. Quarter turns are exact.
class Turn {
public:
    explicit Turn(double degrees) {
        const double quarter = std::fmod(degrees, 360.0) / 90.0;
        const bool isQuarter = quarter == std::nearbyint(quarter);
        const double angle = degrees * std::numbers::pi / 180.0;
        m_cos = isQuarter ? std::nearbyint(std::cos(angle)) : std::cos(angle);
        m_sin = isQuarter ? std::nearbyint(std::sin(angle)) : std::sin(angle);
    }
    [[nodiscard]] PointD operator()(double x, double y) const { return {x * m_cos - y * m_sin, x * m_sin + y * m_cos}; }

private:
    double m_cos = 1.0;
    double m_sin = 0.0;
};

EdgeLoops polygon(std::span<const PointD> corners) {
    EdgeLoops loops;
    for (std::size_t i = 0; i < corners.size(); ++i) {
        loops.addLine(corners[i], corners[i + 1 < corners.size() ? i + 1 : 0]);
    }
    loops.endLoop();
    return loops;
}

EdgeLoops disc(PointD centre, double diameter) {
    EdgeLoops loops;
    loops.addCircle(centre, diameter / 2);
    return loops;
}

std::vector<EdgeLoops> box(double x0, double y0, double x1, double y1, const Turn& turn) {
    if (x1 <= x0 || y1 <= y0) {
        return {};
    }
    const PointD corners[] = {turn(x0, y0), turn(x1, y0), turn(x1, y1), turn(x0, y1)};
    return {polygon(corners)};
}

double at(PrimitiveValues values, std::size_t index) {
    return index < values.size() ? values[index] : 0.0;
}

std::vector<EdgeLoops> circle(PrimitiveValues v) {
    const Turn turn(at(v, 4));
    return at(v, 1) > 0 ? std::vector{disc(turn(at(v, 2), at(v, 3)), at(v, 1))} : std::vector<EdgeLoops>();
}

std::vector<EdgeLoops> vectorLine(PrimitiveValues v) {
    const Turn turn(at(v, 6));
    const PointD a{at(v, 2), at(v, 3)};
    const PointD b{at(v, 4), at(v, 5)};
    const double length = std::hypot(b.x - a.x, b.y - a.y);
    if (length <= 0 || at(v, 1) <= 0) {
        return {};
    }
    const double nx = -(b.y - a.y) / length * at(v, 1) / 2;
    const double ny = (b.x - a.x) / length * at(v, 1) / 2;
    const PointD corners[] = {turn(a.x - nx, a.y - ny), turn(b.x - nx, b.y - ny), turn(b.x + nx, b.y + ny),
                              turn(a.x + nx, a.y + ny)};
    return {polygon(corners)};
}

std::vector<EdgeLoops> centreLine(PrimitiveValues v) {
    const double w = at(v, 1) / 2;
    const double h = at(v, 2) / 2;
    return box(at(v, 3) - w, at(v, 4) - h, at(v, 3) + w, at(v, 4) + h, Turn(at(v, 5)));
}

std::vector<EdgeLoops> lowerLeftLine(PrimitiveValues v) {
    return box(at(v, 3), at(v, 4), at(v, 3) + at(v, 1), at(v, 4) + at(v, 2), Turn(at(v, 5)));
}

/// exposure, n, n + 1 points of which the last one repeats the first, rotation.
std::vector<EdgeLoops> outline(PrimitiveValues v) {
    const double n = at(v, 1);
    if (!(n >= 2) || n > static_cast<double>(kMostCorners) || v.size() < 2 + 2 * static_cast<std::size_t>(n)) {
        return {};
    }
    const auto corners = static_cast<std::size_t>(n);
    const Turn turn(at(v, 2 + 2 * (corners + 1)));
    std::vector<PointD> points;
    for (std::size_t i = 0; i < corners; ++i) {
        points.push_back(turn(v[2 + 2 * i], v[3 + 2 * i]));
    }
    return {polygon(points)};
}

std::vector<EdgeLoops> regularPolygon(PrimitiveValues v) {
    const int n = static_cast<int>(std::clamp(at(v, 1), 0.0, 1000.0));
    if (n < 3 || at(v, 4) <= 0) {
        return {};
    }
    const Turn turn(at(v, 5));
    std::vector<PointD> points;
    for (int i = 0; i < n; ++i) {
        const double angle = 2 * std::numbers::pi * i / n;
        points.push_back(turn(at(v, 2) + at(v, 4) / 2 * std::cos(angle), at(v, 3) + at(v, 4) / 2 * std::sin(angle)));
    }
    return {polygon(points)};
}

EdgeLoops ring(PointD centre, double outer, double inner) {
    EdgeLoops loops = disc(centre, outer);
    if (inner > 0) {
        loops.addCircle(centre, inner / 2);
    }
    return loops;
}

/// x, y, outer diameter, thickness, gap, most rings, thickness and length of the cross, rotation.
std::vector<EdgeLoops> moire(PrimitiveValues v) {
    const Turn turn(at(v, 8));
    std::vector<EdgeLoops> pieces;
    double outer = at(v, 2);
    const int rings = static_cast<int>(std::clamp(at(v, 5), 0.0, static_cast<double>(kMostRings)));
    for (int i = 0; i < rings && outer > 0 && at(v, 3) > 0; ++i) {
        pieces.push_back(ring(turn(at(v, 0), at(v, 1)), outer, outer - 2 * at(v, 3)));
        outer -= 2 * (at(v, 3) + at(v, 4));
    }
    const double half = at(v, 7) / 2;
    const double thick = at(v, 6) / 2;
    for (const bool isUpright : {false, true}) {
        const double w = isUpright ? thick : half;
        const double h = isUpright ? half : thick;
        for (EdgeLoops& bar : box(at(v, 0) - w, at(v, 1) - h, at(v, 0) + w, at(v, 1) + h, turn)) {
            pieces.push_back(std::move(bar));
        }
    }
    return pieces;
}

/// x, y, outer and inner diameter, gap, rotation.
std::vector<EdgeLoops> thermal(PrimitiveValues v) {
    const Turn turn(at(v, 5));
    const double outer = at(v, 2);
    const double gap = at(v, 4) / 2;
    if (outer <= 0 || at(v, 3) >= outer || at(v, 4) >= outer * std::numbers::sqrt2 / 2) {
        return {};
    }
    const std::vector whole{ring(turn(at(v, 0), at(v, 1)), outer, at(v, 3))};
    std::vector<EdgeLoops> cross = box(at(v, 0) - outer, at(v, 1) - gap, at(v, 0) + outer, at(v, 1) + gap, turn);
    for (EdgeLoops& bar : box(at(v, 0) - gap, at(v, 1) - outer, at(v, 0) + gap, at(v, 1) + outer, turn)) {
        cross.push_back(std::move(bar));
    }
    return subtract(whole, cross).value_or(whole);
}

formats::PadShape painted(std::span<const Primitive> primitives) {
    PolygonSet set;
    for (const Primitive& one : primitives) {
        if (one.isDark) {
            set.append(polygonsOf(one.pieces));
        } else {
            set = subtract(set, polygonsOf(one.pieces));
        }
    }
    formats::PadShape shape;
    shape.region = sketchOf(unite(set));
    return shape;
}

/// Consecutive primitives of one exposure are one operand.
std::optional<std::vector<EdgeLoops>> exact(std::span<const Primitive> primitives) {
    std::vector<EdgeLoops> result;
    for (std::size_t i = 0; i < primitives.size();) {
        std::vector<EdgeLoops> operand;
        const bool isDark = primitives[i].isDark;
        for (; i < primitives.size() && primitives[i].isDark == isDark; ++i) {
            operand.insert(operand.end(), primitives[i].pieces.begin(), primitives[i].pieces.end());
        }
        if (isDark) {
            result.insert(result.end(), operand.begin(), operand.end());
        }
        const bool isPlain = isDark && result.size() < 2;
        if (isPlain || result.empty()) {
            continue;
        }
        std::optional<std::vector<EdgeLoops>> next = isDark ? unite(result) : subtract(result, operand);
        if (!next) {
            return std::nullopt;
        }
        result = std::move(*next);
    }
    return result;
}

/// Is the region a disc, or a ring, around the origin?
bool isRound(std::span<const EdgeLoops> regions, formats::PadShape& shape) {
    if (regions.size() != 1 || regions[0].edges.empty() || regions[0].edges.size() != regions[0].loopCount() ||
        regions[0].loopCount() > 2) {
        return false;
    }
    for (const Edge& edge : regions[0].edges) {
        if (!edge.isFullCircle() || std::hypot(edge.centre.x, edge.centre.y) > 0.5) {
            return false;
        }
    }
    const bool isRing = regions[0].loopCount() == 2;
    shape.kind = isRing ? formats::PadShape::Kind::Ring : formats::PadShape::Kind::Round;
    shape.width = static_cast<Nm>(std::nearbyint(2 * regions[0].edges[0].radius));
    shape.height = isRing ? static_cast<Nm>(std::nearbyint(2 * regions[0].edges[1].radius)) : 0;
    return true;
}

bool isWithin(std::span<const Primitive> primitives) {
    return std::ranges::all_of(primitives, [](const Primitive& one) {
        return std::ranges::all_of(one.pieces, [](const EdgeLoops& piece) {
            return std::ranges::all_of(piece.edges, [](const Edge& edge) {
                const double reach = std::max({std::abs(edge.a.x), std::abs(edge.a.y), edge.radius});
                return reach < base::kMaxCoordinate / 4.0;
            });
        });
    });
}

}  // namespace

Primitive primitive(int code, PrimitiveValues values, bool& isKnown) {
    isKnown = true;
    const bool hasExposure = code != 6 && code != 7;
    Primitive result{!hasExposure || at(values, 0) != 0.0, {}};
    switch (code) {
        case 1: result.pieces = circle(values); break;
        case 2:
        case 20: result.pieces = vectorLine(values); break;
        case 21: result.pieces = centreLine(values); break;
        case 22: result.pieces = lowerLeftLine(values); break;
        case 4: result.pieces = outline(values); break;
        case 5: result.pieces = regularPolygon(values); break;
        case 6: result.pieces = moire(values); break;
        case 7: result.pieces = thermal(values); break;
        default: isKnown = false;
    }
    return result;
}

std::vector<EdgeLoops> regionsOf(const ShapeSketch& sketch) {
    std::vector<EdgeLoops> regions;
    for (std::size_t i = 0; i < sketch.contourCount(); ++i) {
        if (!sketch.isHole(i) || regions.empty()) {
            regions.emplace_back();
        }
        EdgeLoops& region = regions.back();
        const PathNodes nodes = sketch.contour(i);
        for (std::size_t k = 0; k < nodes.size(); ++k) {
            const PointD a = base::toDouble(nodes[k].point);
            const PointD b = base::toDouble(nodes.endOf(k));
            if (nodes[k].edge == EdgeKind::Line) {
                region.addLine(a, b);
            } else if (nodes[k].point == nodes.endOf(k)) {
                const PointD c = base::toDouble(nodes[k].centre);
                region.addCircle(c, std::hypot(a.x - c.x, a.y - c.y));
            } else {
                region.addArc(a, b, base::toDouble(nodes[k].centre), nodes[k].edge == EdgeKind::ArcClockwise);
            }
        }
        region.endLoop();
    }
    std::erase_if(regions, [](const EdgeLoops& region) { return region.loopCount() == 0; });
    return regions;
}

formats::PadShape combined(std::vector<Primitive> primitives) {
    for (Primitive& one : primitives) {
        std::erase_if(one.pieces, [](const EdgeLoops& piece) { return piece.loopCount() == 0; });
    }
    std::erase_if(primitives, [](const Primitive& one) { return one.pieces.empty(); });
    formats::PadShape shape;
    if (!isWithin(primitives)) {
        shape.problem = "has an absurd size; it draws nothing";
        return shape;
    }
    const std::optional<std::vector<EdgeLoops>> regions = exact(primitives);
    if (!regions) {
        shape = painted(primitives);
    } else if (!isRound(*regions, shape)) {
        shape.region = sketchOf(*regions);
    }
    if (!shape.region.isEmpty()) {
        shape.kind = formats::PadShape::Kind::Region;
    }
    return shape;
}

}  // namespace model::gerber
