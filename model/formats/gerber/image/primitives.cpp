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
constexpr int kMostPolygonCorners = 1000;
constexpr int kMostRings = 100;
constexpr double kSamePlace = 1000.0;  ///< nm: ends of an outline that differ by this much were rounded

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
std::vector<EdgeLoops> outline(PrimitiveValues v, std::string& problem) {
    const double n = at(v, 1);
    if (n > static_cast<double>(kMostCorners)) {
        problem = "an aperture macro has an outline (4) of more than 100000 corners; it draws nothing";
        return {};
    }
    const auto corners = static_cast<std::size_t>(std::max(n, 0.0));
    if (corners < 3 || v.size() < 2 + 2 * corners) {
        problem = "an aperture macro has an outline (4) that lacks corners; it draws nothing";
        return {};
    }
    const bool hasLast = v.size() >= 4 + 2 * corners;
    const std::size_t points = corners + (hasLast ? 1 : 0);
    const Turn turn(at(v, 2 + 2 * points));
    std::vector<PointD> loop;
    for (std::size_t i = 0; i < points; ++i) {
        loop.push_back(turn(v[2 + 2 * i], v[3 + 2 * i]));
    }
    const bool isBack = hasLast && std::hypot(loop.back().x - loop[0].x, loop.back().y - loop[0].y) <= kSamePlace;
    if (isBack) {
        loop.pop_back();
    } else {
        problem =
            "an aperture macro has an outline (4) that does not end where it began; it is closed by a straight line";
    }
    return {polygon(loop)};
}

std::vector<EdgeLoops> regularPolygon(PrimitiveValues v, std::string& problem) {
    CornerCount corners = cornersOfPolygon(at(v, 1));
    problem = std::move(corners.problem);
    if (corners.count == 0 || at(v, 4) <= 0) {
        return {};
    }
    const Turn turn(at(v, 5));
    std::vector<PointD> points;
    for (int i = 0; i < corners.count; ++i) {
        const double angle = 2 * std::numbers::pi * i / corners.count;
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
std::vector<EdgeLoops> moire(PrimitiveValues v, std::string& problem) {
    const Turn turn(at(v, 8));
    std::vector<EdgeLoops> pieces;
    double outer = at(v, 2);
    const int rings = static_cast<int>(std::clamp(at(v, 5), 0.0, static_cast<double>(kMostRings)));
    for (int i = 0; i < rings && outer > 0 && at(v, 3) > 0; ++i) {
        pieces.push_back(ring(turn(at(v, 0), at(v, 1)), outer, outer - 2 * at(v, 3)));
        outer -= 2 * (at(v, 3) + std::max(at(v, 4), 0.0));
    }
    if (at(v, 5) > kMostRings && outer > 0) {
        problem = "an aperture macro has a moire (6) of more than 100 rings; the inner ones are left out";
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

/// What is left of the first, with arcs where the edges can be cut exactly.
std::vector<EdgeLoops> without(const std::vector<EdgeLoops>& whole, const std::vector<EdgeLoops>& cut) {
    std::optional<std::vector<EdgeLoops>> exact = subtract(whole, cut);
    return exact ? std::move(*exact) : regionsOf(sketchOf(subtract(polygonsOf(whole), polygonsOf(cut))));
}

/// x, y, outer and inner diameter, gap, rotation.
std::vector<EdgeLoops> thermal(PrimitiveValues v, std::string& problem) {
    const Turn turn(at(v, 5));
    const double outer = at(v, 2);
    const double gap = at(v, 4) / 2;
    if (outer <= 0) {
        return {};
    }
    if (at(v, 3) >= outer || at(v, 4) >= outer * std::numbers::sqrt2 / 2) {
        problem = "an aperture macro has a thermal (7) whose hole or cuts take away all of it; it draws nothing";
        return {};
    }
    const std::vector whole{ring(turn(at(v, 0), at(v, 1)), outer, at(v, 3))};
    std::vector<EdgeLoops> cross = box(at(v, 0) - outer, at(v, 1) - gap, at(v, 0) + outer, at(v, 1) + gap, turn);
    for (EdgeLoops& bar : box(at(v, 0) - gap, at(v, 1) - outer, at(v, 0) + gap, at(v, 1) + outer, turn)) {
        cross.push_back(std::move(bar));
    }
    return without(whole, cross);
}

/// How many values a primitive has before its rotation; the one of an outline is in it.
std::size_t valuesOf(int code, PrimitiveValues v) {
    switch (code) {
        case 1: return 4;
        case 2:
        case 20: return 6;
        case 5:
        case 7:
        case 21:
        case 22: return 5;
        case 6: return 8;
        case 4: return 4 + 2 * static_cast<std::size_t>(std::clamp(at(v, 1), 0.0, 1.0 * kMostCorners));
        default: return 0;
    }
}

/// Which of its values are sizes, which may not be below 0.
std::vector<std::size_t> sizesOf(int code) {
    switch (code) {
        case 1:
        case 2:
        case 20: return {1};
        case 21:
        case 22: return {1, 2};
        case 5: return {4};
        case 6: return {2, 3, 4, 6, 7};
        case 7: return {2, 3, 4};
        default: return {};
    }
}

/// What is wrong with the values whatever they mean.
std::string problemOfValues(int code, PrimitiveValues v) {
    constexpr double kRounding = -0.5;  // of expressions, in nm
    const std::size_t count = valuesOf(code, v);
    if (v.size() < count) {
        return "an aperture macro has a primitive that lacks values; they are taken as 0";
    }
    if (std::ranges::any_of(sizesOf(code), [v](std::size_t index) { return at(v, index) < kRounding; })) {
        return "an aperture macro has a primitive with a size below 0, which is taken as 0";
    }
    const bool hasMore = std::ranges::any_of(v.subspan(std::min(v.size(), count + 1)), [](double x) { return x != 0; });
    return hasMore ? "an aperture macro has a primitive with more values than it takes; the last ones are left out"
                   : "";
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

CornerCount cornersOfPolygon(double number) {
    constexpr int kMostAllowed = 12;
    if (!(number >= 3)) {
        return {0, "an aperture has a polygon of fewer than 3 corners; it draws nothing"};
    }
    if (number > kMostPolygonCorners) {
        return {kMostPolygonCorners, "an aperture has a polygon of more than 1000 corners; it is drawn with 1000"};
    }
    const int count = static_cast<int>(number);
    if (count != number) {
        return {count, "an aperture has a polygon whose number of corners is not whole; it is rounded down"};
    }
    return {count, count > kMostAllowed
                       ? "an aperture has a polygon of more than the 12 corners that Gerber allows; it "
                         "is drawn with all of them"
                       : ""};
}

Primitive primitive(int code, PrimitiveValues values) {
    const bool hasExposure = code != 6 && code != 7;
    Primitive result{!hasExposure || at(values, 0) != 0.0, {}, {}};
    switch (code) {
        case 1: result.pieces = circle(values); break;
        case 2:
        case 20: result.pieces = vectorLine(values); break;
        case 21: result.pieces = centreLine(values); break;
        case 22: result.pieces = lowerLeftLine(values); break;
        case 4: result.pieces = outline(values, result.problem); break;
        case 5: result.pieces = regularPolygon(values, result.problem); break;
        case 6: result.pieces = moire(values, result.problem); break;
        case 7: result.pieces = thermal(values, result.problem); break;
        default: result.problem = "an aperture macro has a primitive that cannot be read; it was left out";
    }
    if (result.problem.empty()) {
        result.problem = problemOfValues(code, values);
    }
    return result;
}

formats::PadShape combined(std::vector<Primitive> primitives) {
    for (Primitive& one : primitives) {
        std::erase_if(one.pieces, [](const EdgeLoops& piece) { return piece.loopCount() == 0; });
    }
    std::erase_if(primitives, [](const Primitive& one) { return one.pieces.empty(); });
    formats::PadShape shape;
    if (!isWithin(primitives)) {
        shape.problem = "an aperture has an absurd size; it draws nothing";
        return shape;
    }
    const bool drawsSomething = std::ranges::any_of(primitives, &Primitive::isDark);
    const std::optional<std::vector<EdgeLoops>> regions = exact(primitives);
    if (!regions) {
        shape = painted(primitives);
    } else if (!isRound(*regions, shape)) {
        shape.region = sketchOf(*regions);
    }
    if (!shape.region.isEmpty()) {
        shape.kind = formats::PadShape::Kind::Region;
    }
    if (shape.kind == formats::PadShape::Kind::Nothing && drawsSomething) {
        shape.problem = "an aperture takes away all that it draws; it draws nothing";
    }
    return shape;
}

}  // namespace model::gerber
