#include "model/formats/common/painting.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <optional>
#include <set>

#include "model/base/parallel.h"
#include "model/board/element_copy.h"
#include "model/figures/element_polygons.h"
#include "model/geometry/boolean.h"
#include "model/geometry/box_index.h"
#include "model/geometry/edges.h"
#include "model/geometry/outlines.h"
#include "model/geometry/region.h"

namespace model::formats {

namespace {

/// The negative elements, so that an element is compared with those near it only.
class NegativeIndex {
public:
    NegativeIndex(const Document& document, std::span<const std::uint8_t> negatives) : m_document(document) {
        std::vector<Box> boxes;
        for (std::size_t i = 0; i < negatives.size(); ++i) {
            if (negatives[i] != 0) {
                m_rows.push_back(i);
                boxes.push_back(document.boxOf(ElementId{i}));
            }
        }
        m_index.emplace(boxes);
    }

    /// Rows of the negatives behind `element` whose boxes meet its box, rising.
    [[nodiscard]] std::vector<std::size_t> above(std::size_t element) const {
        std::vector<std::size_t> found;
        m_index->visit(m_document.boxOf(ElementId{element}), [&](std::uint32_t negative) {
            if (m_rows[negative] > element) {
                found.push_back(m_rows[negative]);
            }
        });
        std::ranges::sort(found);
        return found;
    }

private:
    const Document& m_document;
    std::vector<std::size_t> m_rows;  ///< of the negatives
    std::optional<BoxIndex> m_index;
};

/// What is left of a positive element that negative ones lie over.
struct Remainder {
    PolygonSet left;
    std::vector<std::uint32_t> features;  ///< its own and those of the negatives, rising
};

/// Nothing when the element is untouched.
std::optional<Remainder> remainder(const Document& document, std::size_t element, const NegativeIndex& index) {
    const std::vector<std::size_t> above = index.above(element);
    if (above.empty()) {
        return std::nullopt;
    }
    Remainder result;
    result.features.push_back(document.elements.firstFeature[element]);
    PolygonSet cut;
    for (const std::size_t row : above) {
        cut.append(discretise(document, ElementId{row}, kBooleanChords));
        result.features.push_back(document.elements.firstFeature[row]);
    }
    result.features.erase(std::unique(result.features.begin(), result.features.end()), result.features.end());
    result.left = subtract(discretise(document, ElementId{element}, kBooleanChords), cut);
    return result;
}

std::vector<std::optional<Remainder>> remainders(const Document& document, std::span<const std::uint8_t> negatives) {
    const NegativeIndex index(document, negatives);
    std::vector<std::optional<Remainder>> left(negatives.size());
    base::parallelFor(negatives.size(), [&](std::size_t i) {
        if (negatives[i] == 0) {
            left[i] = remainder(document, i, index);
        }
    });
    return left;
}

PolygonSet visible(const Document& document, std::span<const std::uint8_t> negatives) {
    const std::vector<std::optional<Remainder>> left = remainders(document, negatives);
    PolygonSet all;
    for (std::size_t i = 0; i < left.size(); ++i) {
        if (negatives[i] == 0) {
            all.append(left[i] ? left[i]->left : discretise(document, ElementId{i}, kBooleanChords));
        }
    }
    return all;
}

DocumentBuilder::Origin originOf(DocumentBuilder& builder, const Document& document, std::size_t row) {
    const ElementTable& table = document.elements;
    DocumentBuilder::Origin origin;
    origin.net = table.net[row];
    origin.subnet = table.subnet[row];
    origin.feature = table.firstFeature[row];
    origin.line = table.line[row];
    origin.flags = table.flags[row];
    origin.attributes = builder.attributes(document.attributesOf(ElementId{row}));
    if (table.symbol[row].isValid()) {
        origin.symbol = builder.symbol(document.symbols[table.symbol[row].row()]);
    }
    return origin;
}

/// The outline of an element with exact arcs, where that is easy.
std::optional<ShapeSketch> exactOutline(const Document& document, std::size_t row) {
    const std::uint32_t geometry = document.elements.geometry[row];
    const ElementKind kind = document.elements.kind[row];
    if (kind == ElementKind::Area) {
        const AreaGeometry& area = document.areas[geometry];
        return sketchOf(document.shapes, area.shape, area.placement);
    }
    ShapeSketch sketch;
    if (kind == ElementKind::Circle) {
        const CircleGeometry& circle = document.circles[geometry];
        if (circle.diameter < 2) {
            return std::nullopt;
        }
        sketch.addCircle(circle.centre, circle.diameter / 2, false);
        if (circle.innerDiameter > 0) {
            sketch.addCircle(circle.centre, circle.innerDiameter / 2, true);
        }
        return sketch;
    }
    const bool isRoundLine = kind == ElementKind::Line && (document.elements.flags[row] & kSquarePen) == 0;
    if (!isRoundLine || document.lines[geometry].width < 2) {
        return std::nullopt;
    }
    const LineGeometry& line = document.lines[geometry];
    addCapsule(sketch, base::toDouble(line.a), base::toDouble(line.b), line.width);
    return sketch;
}

/// More elements than this are not tested pair by pair for exactness.
constexpr std::size_t kMaxExactElements = 64;

bool keepApart(const Document& document) {
    const std::size_t count = document.elements.size();
    for (std::size_t i = 0; i < count; ++i) {
        for (std::size_t j = i + 1; j < count; ++j) {
            if (document.boxOf(ElementId{i}).meets(document.boxOf(ElementId{j}))) {
                return false;
            }
        }
    }
    return true;
}

std::optional<ShapeSketch> exactRegion(const Document& document, std::span<const std::uint8_t> negatives) {
    const bool isPositive = std::ranges::all_of(negatives, [](std::uint8_t n) { return n == 0; });
    if (!isPositive || negatives.size() > kMaxExactElements || !keepApart(document)) {
        return std::nullopt;
    }
    ShapeSketch all;
    for (std::size_t i = 0; i < negatives.size(); ++i) {
        const std::optional<ShapeSketch> outline = exactOutline(document, i);
        if (!outline) {
            return std::nullopt;
        }
        all.append(*outline, {});
    }
    return all;
}

/// Finds the features whose outlines run along a piece. Booleans round crossings to whole nanometres, so the middle of
/// an edge of the result lies within 2 nm of the edge it is a part of.
class OutlineSources {
public:
    explicit OutlineSources(const Document& painted) {
        for (std::size_t row = 0; row < painted.elements.size(); ++row) {
            const PolygonSet polygons = discretise(painted, ElementId{row}, kBooleanChords);
            for (std::size_t i = 0; i < polygons.loopCount(); ++i) {
                addLoop(polygons.loop(i), painted.elements.firstFeature[row]);
            }
        }
        std::vector<Box> boxes;
        for (const Edge& edge : m_edges) {
            boxes.push_back(boxOf(edge).grownBy(kReach));
        }
        m_index.emplace(boxes);
    }

    void collect(std::span<const Point> loop, std::set<std::uint32_t>& features) const {
        for (std::size_t i = 0; i < loop.size(); ++i) {
            const Point a = loop[i];
            const Point b = loop[(i + 1) % loop.size()];
            const PointD middle = {(static_cast<double>(a.x) + b.x) / 2, (static_cast<double>(a.y) + b.y) / 2};
            Box box;
            box.include(rounded(middle));
            m_index->visit(box, [&](std::uint32_t row) {
                const PointD on = nearestOn(m_edges[row], middle);
                if (std::hypot(on.x - middle.x, on.y - middle.y) <= kReach) {
                    features.insert(m_features[row]);
                }
            });
        }
    }

private:
    static constexpr Nm kReach = 2;

    void addLoop(std::span<const Point> loop, std::uint32_t feature) {
        for (std::size_t i = 0; i < loop.size(); ++i) {
            m_edges.push_back(edgeOf({loop[i], {}, EdgeKind::Line}, loop[(i + 1) % loop.size()]));
            m_features.push_back(feature);
        }
    }

    std::vector<Edge> m_edges;
    std::vector<std::uint32_t> m_features;  ///< by edge
    std::optional<BoxIndex> m_index;
};

/// Finds the polygon around a point. Edges lie in horizontal strips, so that few are looked at.
class PieceLocator {
public:
    explicit PieceLocator(const PolygonSet& pieces) : m_pieces(pieces) {
        for (const Point& point : pieces.points) {
            m_low = std::min(m_low, std::int64_t{point.y});
            m_high = std::max(m_high, std::int64_t{point.y});
        }
        constexpr std::size_t kEdgesPerStrip = 8;
        constexpr std::size_t kMostStrips = 1U << 14U;
        m_strips.resize(std::clamp<std::size_t>(pieces.points.size() / kEdgesPerStrip, 1, kMostStrips));
        for (std::uint32_t p = 0; p < pieces.polygons.size(); ++p) {
            for (std::uint32_t i = 0; i < pieces.polygons[p].loopCount; ++i) {
                addLoop(p, pieces.loop(pieces.polygons[p].firstLoop + i));
            }
        }
    }

    /// Number of pieces when the point lies in none.
    [[nodiscard]] std::size_t pieceAt(Point point) const {
        if (point.y < m_low || point.y > m_high) {
            return m_pieces.polygons.size();
        }
        std::vector<std::uint32_t> crossed;
        for (const Side& edge : m_strips[stripOf(point.y)]) {
            if (crossesToTheRight(edge, point)) {
                crossed.push_back(edge.piece);
            }
        }
        std::ranges::sort(crossed);
        for (auto first = crossed.begin(); first != crossed.end();) {  // crossings of the piece around it are odd
            const auto end = std::upper_bound(first, crossed.end(), *first);
            if ((end - first) % 2 != 0) {
                return *first;
            }
            first = end;
        }
        return m_pieces.polygons.size();
    }

private:
    struct Side {
        Point low;
        Point high;
        std::uint32_t piece;
    };

    void addLoop(std::uint32_t piece, std::span<const Point> loop) {
        for (std::size_t i = 0; i < loop.size(); ++i) {
            const Point a = loop[i];
            const Point b = loop[(i + 1) % loop.size()];
            const Side side = a.y < b.y ? Side{a, b, piece} : Side{b, a, piece};
            const std::size_t last = stripOf(side.high.y);
            for (std::size_t strip = stripOf(side.low.y); strip <= last && a.y != b.y; ++strip) {
                m_strips[strip].push_back(side);
            }
        }
    }

    [[nodiscard]] std::size_t stripOf(std::int64_t y) const {
        return static_cast<std::size_t>((y - m_low) * static_cast<std::int64_t>(m_strips.size() - 1) /
                                        std::max<std::int64_t>(m_high - m_low, 1));
    }

    static bool crossesToTheRight(const Side& edge, Point p) {
        if (p.y < edge.low.y || p.y >= edge.high.y) {
            return false;
        }
        // Coordinates are below 2^30, so the products stay below 2^62.
        const std::int64_t side = (std::int64_t{edge.high.x} - edge.low.x) * (std::int64_t{p.y} - edge.low.y) -
                                  (std::int64_t{edge.high.y} - edge.low.y) * (std::int64_t{p.x} - edge.low.x);
        return side > 0;
    }

    const PolygonSet& m_pieces;
    std::int64_t m_low = std::numeric_limits<Nm>::max();
    std::int64_t m_high = std::numeric_limits<Nm>::min();
    std::vector<std::vector<Side>> m_strips;
};

/// The first one of those with most votes.
PieceNet winner(const std::map<NetId, std::size_t>& counts) {
    const auto most = std::ranges::max_element(counts, {}, [](const auto& entry) { return entry.second; });
    return most == counts.end() ? PieceNet{} : PieceNet{most->first, counts.size() > 1};
}

Inverse::Piece pieceOf(const PolygonSet& pieces, const PolygonSet::Polygon& polygon, NetId net,
                       const OutlineSources& sources) {
    Inverse::Piece piece;
    piece.net = net;
    std::set<std::uint32_t> features;
    for (std::uint32_t i = 0; i < polygon.loopCount; ++i) {
        piece.sketch.addPolygon(pieces.loop(polygon.firstLoop + i), i > 0);
        sources.collect(pieces.loop(polygon.firstLoop + i), features);
    }
    piece.features.assign(features.begin(), features.end());
    return piece;
}

}  // namespace

void addPainted(DocumentBuilder& builder, const Document& painted, std::span<const std::uint8_t> negatives) {
    const std::vector<std::optional<Remainder>> left = remainders(painted, negatives);
    ElementCopier copier(builder, painted);
    for (std::size_t i = 0; i < left.size(); ++i) {
        if (negatives[i] != 0) {
            continue;
        }
        if (!left[i]) {
            copier.copy(ElementId{i}, originOf(builder, painted, i));
        } else if (const ShapeSketch sketch = sketchOf(left[i]->left); !sketch.isEmpty()) {
            builder.addPaintedArea({builder.addShape(sketch), {}}, originOf(builder, painted, i), left[i]->features);
        }
    }
}

std::vector<NetVote> votesOn(const Document& document, LayerId layer, const Document& ownFeatures) {
    std::vector<NetVote> votes;
    for (const Layer& holes : document.layers) {
        for (std::uint32_t i = 0; holes.spans(layer) && i < holes.elements.count; ++i) {
            const std::size_t row = holes.elements.first + i;
            const NetId net = document.elements.net[row];
            if ((document.elements.flags[row] & kPlated) != 0 && net.isValid()) {
                votes.push_back({document.boxOf(ElementId{row}).middle(), net});
            }
        }
    }
    for (std::size_t row = 0; row < ownFeatures.elements.size(); ++row) {
        if ((ownFeatures.elements.flags[row] & kPad) != 0 && ownFeatures.elements.net[row].isValid()) {
            votes.push_back({ownFeatures.boxOf(ElementId{row}).middle(), ownFeatures.elements.net[row]});
        }
    }
    return votes;
}

std::vector<PieceNet> netsOf(const PolygonSet& pieces, std::span<const NetVote> votes) {
    std::vector<std::map<NetId, std::size_t>> counts(pieces.polygons.size());
    const PieceLocator locator(pieces);
    for (const NetVote& vote : votes) {
        const std::size_t piece = locator.pieceAt(vote.location);
        if (piece < counts.size()) {
            ++counts[piece][vote.net];
        }
    }
    std::vector<PieceNet> nets;
    for (const std::map<NetId, std::size_t>& count : counts) {
        nets.push_back(winner(count));
    }
    return nets;
}

Inverse inverseOf(const PolygonSet& base, const Document& painted, std::span<const std::uint8_t> negatives,
                  std::span<const NetVote> votes) {
    const PolygonSet pieces = subtract(base, visible(painted, negatives));
    const std::vector<PieceNet> nets = netsOf(pieces, votes);
    const OutlineSources sources(painted);
    Inverse inverse;
    inverse.summary.pieces = pieces.polygons.size();
    for (std::size_t i = 0; i < nets.size(); ++i) {
        inverse.pieces.push_back(pieceOf(pieces, pieces.polygons[i], nets[i].net, sources));
        inverse.summary.withoutNet += nets[i].net.isValid() ? 0 : 1;
        inverse.summary.withSeveralNets += nets[i].hasOtherVotes ? 1 : 0;
    }
    return inverse;
}

void addInverse(DocumentBuilder& builder, const Inverse& inverse) {
    for (const Inverse::Piece& piece : inverse.pieces) {
        DocumentBuilder::Origin origin;
        origin.net = piece.net;
        builder.addPaintedArea({builder.addShape(piece.sketch), {}}, origin, piece.features);
    }
}

ShapeSketch regionOf(const Document& painted, std::span<const std::uint8_t> negatives) {
    std::optional<ShapeSketch> exact = exactRegion(painted, negatives);
    return exact ? std::move(*exact) : sketchOf(unite(visible(painted, negatives)));
}

}  // namespace model::formats
