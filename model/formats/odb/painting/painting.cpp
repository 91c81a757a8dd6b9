#include "model/formats/odb/painting/painting.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <set>

#include "model/base/parallel.h"
#include "model/figures/element_polygons.h"
#include "model/formats/common/outlines.h"
#include "model/formats/common/region.h"
#include "model/geometry/boolean.h"
#include "model/geometry/box_index.h"

namespace model::odb {

namespace {

bool overlaps(const Box& a, const Box& b) {
    return a.min.x <= b.max.x && b.min.x <= a.max.x && a.min.y <= b.max.y && b.min.y <= a.max.y;
}

/// The negative elements in columns of x, so that an element asks only those near it.
class NegativeIndex {
public:
    NegativeIndex(const Document& document, std::span<const std::uint8_t> negatives) : m_columns(kColumns) {
        for (std::size_t i = 0; i < negatives.size(); ++i) {
            m_boxes.push_back(document.boxOf(ElementId{i}));
            if (negatives[i] != 0) {
                m_extent.include(m_boxes.back());
            }
        }
        for (std::size_t i = 0; i < negatives.size(); ++i) {
            if (negatives[i] != 0) {
                for (std::size_t c = columnOf(m_boxes[i].min.x); c <= columnOf(m_boxes[i].max.x); ++c) {
                    m_columns[c].push_back(i);
                }
            }
        }
    }

    /// Rows of the negatives behind `element` whose boxes meet its box, rising.
    [[nodiscard]] std::vector<std::size_t> above(std::size_t element) const {
        std::vector<std::size_t> found;
        const Box& box = m_boxes[element];
        if (m_extent.isEmpty() || !overlaps(box, m_extent)) {
            return found;
        }
        for (std::size_t c = columnOf(box.min.x); c <= columnOf(box.max.x); ++c) {
            const std::vector<std::size_t>& column = m_columns[c];
            for (auto row = std::ranges::upper_bound(column, element); row != column.end(); ++row) {
                if (overlaps(m_boxes[*row], box)) {
                    found.push_back(*row);
                }
            }
        }
        std::ranges::sort(found);
        found.erase(std::unique(found.begin(), found.end()), found.end());
        return found;
    }

private:
    static constexpr std::size_t kColumns = 512;

    [[nodiscard]] std::size_t columnOf(Nm x) const {
        const std::int64_t offset = std::clamp<std::int64_t>(std::int64_t{x} - m_extent.min.x, 0, m_extent.width());
        return static_cast<std::size_t>(offset * static_cast<std::int64_t>(kColumns - 1) /
                                        std::max<std::int64_t>(m_extent.width(), 1));
    }

    std::vector<Box> m_boxes;
    Box m_extent;
    std::vector<std::vector<std::size_t>> m_columns;
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
    origin.attributes = builder.attributes(document.attributes.values(table.attributes[row]));
    if (table.symbol[row].isValid()) {
        origin.symbol = builder.symbol(document.symbols[table.symbol[row].row()]);
    }
    return origin;
}

/// Copies elements between documents, shared shapes once.
class ElementCopier {
public:
    ElementCopier(DocumentBuilder& builder, const Document& from) : m_builder(builder), m_from(from) {}

    void copy(std::size_t row) {
        const DocumentBuilder::Origin origin = originOf(m_builder, m_from, row);
        const std::uint32_t geometry = m_from.elements.geometry[row];
        switch (m_from.elements.kind[row]) {
            case ElementKind::Line: m_builder.addLine(m_from.lines[geometry], origin); break;
            case ElementKind::Arc: m_builder.addArc(m_from.arcs[geometry], origin); break;
            case ElementKind::Circle: m_builder.addCircle(m_from.circles[geometry], origin); break;
            case ElementKind::Trail: {
                const TrailGeometry& trail = m_from.trails[geometry];
                m_builder.addTrail(m_from.nodesOf(trail), trail.width, origin, trail.innerWidth);
                break;
            }
            case ElementKind::Area: copyArea(m_from.areas[geometry], origin); break;
        }
    }

private:
    void copyArea(AreaGeometry area, const DocumentBuilder::Origin& origin) {
        const auto [location, isNew] = m_shapes.try_emplace(area.shape);
        if (isNew) {
            location->second = m_builder.addShape(sketchOf(m_from.shapes, area.shape.value, {}));
        }
        area.shape = location->second;
        m_builder.addArea(area, origin);
    }

    DocumentBuilder& m_builder;
    const Document& m_from;
    std::map<ShapeId, ShapeId> m_shapes;
};

/// The outline of an element with exact arcs, where that is easy.
std::optional<ShapeSketch> exactOutline(const Document& document, std::size_t row) {
    const std::uint32_t geometry = document.elements.geometry[row];
    const ElementKind kind = document.elements.kind[row];
    if (kind == ElementKind::Area) {
        const AreaGeometry& area = document.areas[geometry];
        return sketchOf(document.shapes, area.shape.value, area.placement);
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
            if (overlaps(document.boxOf(ElementId{i}), document.boxOf(ElementId{j}))) {
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
        for (std::size_t contour = 0; contour < outline->contourCount(); ++contour) {
            all.beginContour(outline->isHole(contour));
            for (const PathNode& node : outline->contour(contour)) {
                all.addNode(node);
            }
        }
    }
    return all;
}

}  // namespace

namespace {

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
            Box box;
            box.include(edge.a);
            box.include(edge.b);
            boxes.push_back(box.grownBy(kReach));
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
                if (distance(m_edges[row], middle) <= kReach) {
                    features.insert(m_edges[row].feature);
                }
            });
        }
    }

private:
    struct Edge {
        Point a;
        Point b;
        std::uint32_t feature = 0;
    };
    static constexpr Nm kReach = 2;

    void addLoop(std::span<const Point> loop, std::uint32_t feature) {
        for (std::size_t i = 0; i < loop.size(); ++i) {
            m_edges.push_back({loop[i], loop[(i + 1) % loop.size()], feature});
        }
    }

    /// From the point to the edge.
    static double distance(const Edge& edge, PointD p) {
        const double dx = static_cast<double>(edge.b.x) - edge.a.x;
        const double dy = static_cast<double>(edge.b.y) - edge.a.y;
        const double along = ((p.x - edge.a.x) * dx + (p.y - edge.a.y) * dy) / std::max(dx * dx + dy * dy, 1.0);
        const double t = std::clamp(along, 0.0, 1.0);
        return std::hypot(p.x - edge.a.x - t * dx, p.y - edge.a.y - t * dy);
    }

    std::vector<Edge> m_edges;
    std::optional<BoxIndex> m_index;
};

void addPiece(DocumentBuilder& builder, const PolygonSet& pieces, const PolygonSet::Polygon& piece, NetId net,
              const OutlineSources& sources) {
    ShapeSketch sketch;
    std::set<std::uint32_t> features;
    for (std::uint32_t i = 0; i < piece.loopCount; ++i) {
        sketch.addPolygon(pieces.loop(piece.firstLoop + i), i > 0);
        sources.collect(pieces.loop(piece.firstLoop + i), features);
    }
    DocumentBuilder::Origin origin;
    origin.net = net;
    builder.addPaintedArea({builder.addShape(sketch), {}}, origin,
                           std::vector<std::uint32_t>(features.begin(), features.end()));
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
            copier.copy(i);
        } else if (const ShapeSketch sketch = sketchOf(left[i]->left); !sketch.isEmpty()) {
            builder.addPaintedArea({builder.addShape(sketch), {}}, originOf(builder, painted, i), left[i]->features);
        }
    }
}

InverseSummary addInverse(DocumentBuilder& builder, const PolygonSet& base, const Document& painted,
                          std::span<const std::uint8_t> negatives, std::span<const NetVote> votes) {
    const PolygonSet pieces = subtract(base, visible(painted, negatives));
    const std::vector<PieceNet> nets = netsOf(pieces, votes);
    const OutlineSources sources(painted);
    InverseSummary summary;
    summary.pieces = pieces.polygons.size();
    for (std::size_t i = 0; i < nets.size(); ++i) {
        addPiece(builder, pieces, pieces.polygons[i], nets[i].net, sources);
        summary.withoutNet += nets[i].net.isValid() ? 0 : 1;
        summary.withSeveralNets += nets[i].hasOtherVotes ? 1 : 0;
    }
    return summary;
}

ShapeSketch regionOf(const Document& painted, std::span<const std::uint8_t> negatives) {
    std::optional<ShapeSketch> exact = exactRegion(painted, negatives);
    return exact ? std::move(*exact) : sketchOf(unite(visible(painted, negatives)));
}

}  // namespace model::odb
