#include "model/formats/common/painting.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numbers>
#include <optional>
#include <set>

#include "model/base/parallel.h"
#include "model/board/element_copy.h"
#include "model/formats/common/element_regions.h"
#include "model/geometry/box_index.h"
#include "model/geometry/edges.h"
#include "model/geometry/loops/region_booleans.h"
#include "model/geometry/outlines.h"

namespace model::formats {

namespace {

constexpr const char* kChords = "arcs are straight edges within 1 µm, as they could not be kept";

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
    RegionBoolean left;
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
    RegionBoolean cut;
    for (const std::size_t row : above) {
        cut.append(regionsOf(document, ElementId{row}));
        result.features.push_back(document.elements.firstFeature[row]);
    }
    result.features.erase(std::unique(result.features.begin(), result.features.end()), result.features.end());
    const RegionBoolean own = regionsOf(document, ElementId{element});
    result.left = differenceOf(own.regions, cut.regions);
    result.left.isExact = result.left.isExact && own.isExact && cut.isExact;
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

/// More regions than this are not tested pair by pair.
constexpr std::size_t kMostPairwise = 64;

/// Is it certain that no two of them meet?
bool keepApart(std::span<const EdgeLoops> regions) {
    if (regions.size() > kMostPairwise) {
        return false;
    }
    std::vector<Box> boxes;
    for (const EdgeLoops& region : regions) {
        const Box box = boxOf(region);
        if (std::ranges::any_of(boxes, [&](const Box& other) { return other.meets(box); })) {
            return false;
        }
        boxes.push_back(box);
    }
    return true;
}

/// Finds the features whose outlines run along a piece: the middle of an edge of the result lies within 6 nm of the
/// edge it is a part of, as booleans and the grid move edges by less.
class OutlineSources {
public:
    explicit OutlineSources(const Document& painted) {
        std::vector<Box> boxes;
        for (std::size_t row = 0; row < painted.elements.size(); ++row) {
            for (const EdgeLoops& region : regionsOf(painted, ElementId{row}).regions) {
                for (const Edge& edge : region.edges) {
                    m_edges.push_back(edge);
                    m_features.push_back(painted.elements.firstFeature[row]);
                    boxes.push_back(boxOf(edge).grownBy(kReach));
                }
            }
        }
        m_index.emplace(boxes);
    }

    void collect(const EdgeLoops& region, std::set<std::uint32_t>& features) const {
        for (const Edge& edge : region.edges) {
            const PointD middle = pointAt(edge, lengthOf(edge) / 2);
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
    static constexpr Nm kReach = 6;

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

/// The piece in the middle of the vote, or else one that its hole cuts; past the last one if there is none.
std::size_t pieceAt(const PieceLocator& locator, const NetVote& vote, std::size_t none) {
    // Pieces have chords within 1 µm: copper that only touches the wall of a hole may lie on either side of it.
    constexpr Nm kWithin = 2'000;
    std::size_t piece = locator.pieceAt(vote.location);
    const Nm reach = vote.radius - kWithin;
    for (int x = -1; x <= 1 && piece == none && reach > 0; ++x) {
        for (int y = -1; y <= 1 && piece == none; ++y) {
            const double along = x != 0 && y != 0 ? reach * std::numbers::sqrt2 / 2.0 : reach;
            const Nm step = static_cast<Nm>(along);
            piece = locator.pieceAt({vote.location.x + x * step, vote.location.y + y * step});
        }
    }
    return piece;
}

Inverse::Piece pieceOf(const EdgeLoops& region, NetId net, const OutlineSources& sources) {
    Inverse::Piece piece{sketchOf({&region, 1}), net, {}};
    std::set<std::uint32_t> features;
    sources.collect(region, features);
    piece.features.assign(features.begin(), features.end());
    return piece;
}

}  // namespace

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

void addPainted(DocumentBuilder& builder, const Document& painted, std::span<const std::uint8_t> negatives,
                std::string_view file) {
    std::size_t inexact = 0;
    const std::vector<std::optional<Remainder>> left = remainders(painted, negatives);
    ElementCopier copier(builder, painted);
    for (std::size_t i = 0; i < left.size(); ++i) {
        if (negatives[i] != 0) {
            continue;
        }
        if (!left[i]) {
            copier.copy(ElementId{i}, originOf(builder, painted, i));
        } else if (const ShapeSketch sketch = sketchOf(left[i]->left.regions); !sketch.isEmpty()) {
            builder.addPaintedArea({builder.addShape(sketch), {}}, originOf(builder, painted, i), left[i]->features);
            inexact += left[i]->left.isExact ? 0 : 1;
        }
    }
    if (inexact > 0) {
        builder.diagnostics().report(Severity::Info, file, 0,
                                     "of " + std::to_string(inexact) + " features that negative ones cut, " + kChords);
    }
}

std::vector<NetVote> votesOn(const Document& document, LayerId layer, const Document& ownFeatures) {
    std::vector<NetVote> votes;
    for (const Layer& holes : document.layers) {
        for (std::uint32_t i = 0; holes.spans(layer) && i < holes.elements.count; ++i) {
            const std::size_t row = holes.elements.first + i;
            const NetId net = document.elements.net[row];
            if ((document.elements.flags[row] & kPlated) != 0 && net.isValid()) {
                const Box box = document.boxOf(ElementId{row});
                const bool isRound = document.elements.kind[row] == ElementKind::Circle;
                votes.push_back({box.middle(), net, isRound ? static_cast<Nm>(box.width() / 2) : 0});
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
        const std::size_t piece = pieceAt(locator, vote, counts.size());
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

RegionBoolean visibleOf(const Document& document, std::span<const std::uint8_t> negatives) {
    std::vector<std::optional<Remainder>> left = remainders(document, negatives);
    RegionBoolean all;
    for (std::size_t i = 0; i < left.size(); ++i) {
        if (left[i]) {
            all.append(std::move(left[i]->left));
        } else if (negatives[i] == 0) {
            all.append(regionsOf(document, ElementId{i}));
        }
    }
    return all;
}

Inverse inverseOf(const std::vector<EdgeLoops>& base, const RegionBoolean& visible, const Document& painted,
                  std::span<const NetVote> votes) {
    const RegionBoolean pieces = differenceOf(base, visible.regions);
    const std::vector<PieceNet> nets = netsOf(polygonsOf(pieces.regions), votes);
    const OutlineSources sources(painted);
    Inverse inverse;
    inverse.summary.pieces = pieces.regions.size();
    inverse.summary.isExact = visible.isExact && pieces.isExact;
    for (std::size_t i = 0; i < nets.size(); ++i) {
        inverse.pieces.push_back(pieceOf(pieces.regions[i], nets[i].net, sources));
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

ShapeSketch regionOf(const Document& painted, std::span<const std::uint8_t> negatives, Diagnostics& diagnostics,
                     std::string_view file) {
    RegionBoolean shown = visibleOf(painted, negatives);
    if (!keepApart(shown.regions)) {
        const bool areExact = shown.isExact;
        shown = unionOf(shown.regions);
        shown.isExact = shown.isExact && areExact;
    }
    if (!shown.isExact) {
        diagnostics.report(Severity::Info, file, 0, std::string("in what it draws, ") + kChords);
    }
    return sketchOf(shown.regions);
}

}  // namespace model::formats
