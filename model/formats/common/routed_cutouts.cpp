#include "model/formats/common/routed_cutouts.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <numeric>
#include <unordered_map>
#include <utility>
#include <vector>

#include "model/board/element_copy.h"
#include "model/formats/common/element_regions.h"
#include "model/formats/common/painting.h"
#include "model/geometry/edges.h"
#include "model/geometry/loops/region_search.h"
#include "model/geometry/outlines.h"
#include "model/geometry/vectors.h"
#include "model/solids/shells/area_shell.h"

namespace model::formats {

namespace {

/// Copper that covers less than this of a piece only touches it, nm²: the smallest pads are ten times as large.
constexpr double kTouch = 3e9;
/// Programs round the ends of paths, and the paths along an outline, by less than this.
constexpr double kRounding = 5'000.0;

double areaOf(const std::vector<EdgeLoops>& regions) {
    return std::accumulate(regions.begin(), regions.end(), 0.0,
                           [](double sum, const EdgeLoops& region) { return sum + model::areaOf(region); });
}

double overlap(const std::vector<EdgeLoops>& piece, const std::vector<EdgeLoops>& with) {
    return areaOf(piece) - areaOf(differenceOf(piece, with).regions);
}

class RoutedPieces {
public:
    explicit RoutedPieces(const Document& board)
        : m_board(board),
          m_outline(board.profile.isValid() ? areaOutlines(board.shapes, board.profile) : std::vector<EdgeLoops>()),
          m_half(areaOf(m_outline) / 2.0) {}

    /// Of the board; empty where it has none.
    [[nodiscard]] const std::vector<EdgeLoops>& outline() const { return m_outline; }

    /// What an element of the document cuts loose; empty: nothing.
    [[nodiscard]] std::vector<EdgeLoops> cutLooseBy(const Document& routed, ElementId path) const {
        std::vector<EdgeLoops> piece = enclosedBy(routed, path);
        const double area = areaOf(piece);
        const bool isPiece = area > 0.0 && area < m_half && overlap(piece, m_outline) > area / 2.0;
        return isPiece && !holdsCopper(piece) ? piece : std::vector<EdgeLoops>();
    }

    /// Is it closed, with half of the board or more within?
    [[nodiscard]] bool isAroundBoard(const Document& routed, ElementId path) const {
        const std::vector<EdgeLoops> piece = enclosedBy(routed, path);
        return m_half > 0.0 && !piece.empty() && overlap(piece, m_outline) >= m_half;
    }

    /// Layers whose paths go through the whole board.
    [[nodiscard]] bool cuts(const Layer& layer) const {
        return layer.type == LayerType::Rout && layer.use == LayerUse::Plain &&
               std::ranges::all_of(m_board.layers, [&](const Layer& copper) {
                   const auto row = static_cast<std::size_t>(&copper - m_board.layers.data());
                   return !copper.isBoardCopper() || layer.spans(LayerId{row});
               });
    }

    [[nodiscard]] RegionBoolean without(const std::vector<EdgeLoops>& pieces) const {
        return differenceOf(m_outline, pieces);
    }

private:
    /// Within the middle line of a path that ends where it begins.
    static std::vector<EdgeLoops> enclosedBy(const Document& routed, ElementId path) {
        ShapeSketch sketch;
        const std::uint32_t row = routed.elements.geometry[path.row()];
        if (routed.elements.kind[path.row()] == ElementKind::Trail) {
            const TrailGeometry& trail = routed.trails[row];
            const std::span<const PathNode> nodes = routed.nodesOf(trail);
            if (isClosed(nodes, trail.width)) {
                addPath(sketch, nodes.first(nodes.size() - 1), false);
            }
        } else if (routed.elements.kind[path.row()] == ElementKind::Arc) {
            const ArcGeometry& arc = routed.arcs[row];
            if (arc.node.point == arc.end) {
                addPath(sketch, std::span(&arc.node, 1), false);
            }
        }
        return sketch.isEmpty() ? std::vector<EdgeLoops>() : unionOf(regionsOf(sketch)).regions;
    }

    /// Do both ends of the cutter's way overlap?
    static bool isClosed(std::span<const PathNode> nodes, Nm width) {
        const double reach = std::max(width / 2.0, kRounding);
        return nodes.size() > 2 && distance(nodes.front().point, nodes.back().point) <= reach;
    }

    [[nodiscard]] bool holdsCopper(const std::vector<EdgeLoops>& piece) const {
        Box box;
        for (const EdgeLoops& region : piece) {
            box.include(boxOf(region));
        }
        const bool holdsStep = std::ranges::any_of(m_board.instances, [&](const StepInstance& instance) {
            return box.meets(instance.placement.boxOf(m_board.steps[instance.step]->board));
        });
        return holdsStep || holdsCopper(piece, box, false) || holdsCopper(piece, box, true);
    }

    /// Areas take longest, so they are looked at last.
    [[nodiscard]] bool holdsCopper(const std::vector<EdgeLoops>& piece, const Box& box, bool areas) const {
        for (const Layer& layer : m_board.layers) {
            for (std::uint32_t i = 0; i < layer.elements.count && layer.isBoardCopper(); ++i) {
                const ElementId id{layer.elements.first + i};
                const bool isLookedAt = (m_board.elements.kind[id.row()] == ElementKind::Area) == areas;
                if (isLookedAt && box.meets(m_board.boxOf(id)) && covers(id, piece, areas)) {
                    return true;
                }
            }
        }
        return false;
    }

    [[nodiscard]] bool covers(ElementId copper, const std::vector<EdgeLoops>& piece, bool isArea) const {
        const std::vector<EdgeLoops> parts = isArea ? partsNear(piece, copper) : regionsOf(m_board, copper).regions;
        return !parts.empty() && overlap(piece, parts) > kTouch;
    }

    /// What an area has where a piece may reach it. Planes have a great many edges, and paths lie in clearances of
    /// them.
    [[nodiscard]] std::vector<EdgeLoops> partsNear(const std::vector<EdgeLoops>& piece, ElementId area) const {
        const std::vector<RegionSearch> cuts(piece.begin(), piece.end());
        std::vector<EdgeLoops> near;
        for (const RegionSearch& part : partsOf(area)) {
            if (std::ranges::any_of(cuts, [&](const RegionSearch& cut) { return lieOf(cut, part) != CutLie::Apart; })) {
                near.push_back(part.region());
            }
        }
        return near;
    }

    /// Made once, for all paths.
    [[nodiscard]] const std::vector<RegionSearch>& partsOf(ElementId area) const {
        const auto [found, isNew] = m_areas.try_emplace(area.row());
        if (isNew) {
            RegionBoolean parts = regionsOf(m_board, area);
            for (EdgeLoops& region : parts.regions) {
                found->second.emplace_back(std::move(region));
            }
        }
        return found->second;
    }

    const Document& m_board;
    std::vector<EdgeLoops> m_outline;
    double m_half;
    mutable std::unordered_map<std::size_t, std::vector<RegionSearch>> m_areas;
};

/// As wide as a path cuts; 0 for areas too.
Nm penOf(const Document& routed, ElementId element) {
    const std::uint32_t row = routed.elements.geometry[element.row()];
    switch (routed.elements.kind[element.row()]) {
        case ElementKind::Line: return routed.lines[row].width;
        case ElementKind::Arc: return routed.arcs[row].width;
        case ElementKind::Trail: return routed.trails[row].width;
        case ElementKind::Circle: return routed.circles[row].diameter;
        case ElementKind::Area: return 0;
    }
    return 0;
}

bool isCompensated(const Document& routed, ElementId element) {
    return std::ranges::any_of(routed.attributesOf(element), [](const auto& attribute) {
        return attribute.first == ".comp" && attribute.second != "none" && attribute.second != "0";
    });
}

Edge straight(Point from, Point to) {
    PathNode node;
    node.point = from;
    return edgeOf(node, to);
}

/// The middle line of what a round pen draws; empty for areas.
std::vector<Edge> middleLineOf(const Document& routed, ElementId element) {
    const std::uint32_t row = routed.elements.geometry[element.row()];
    switch (routed.elements.kind[element.row()]) {
        case ElementKind::Line: return {straight(routed.lines[row].a, routed.lines[row].b)};
        case ElementKind::Arc: return {edgeOf(routed.arcs[row].node, routed.arcs[row].end)};
        case ElementKind::Circle: return {straight(routed.circles[row].centre, routed.circles[row].centre)};
        case ElementKind::Trail: {
            std::vector<Edge> edges;
            const std::span<const PathNode> nodes = routed.nodesOf(routed.trails[row]);
            for (std::size_t i = 0; i + 1 < nodes.size(); ++i) {
                edges.push_back(edgeOf(nodes[i], nodes[i + 1].point));
            }
            return edges;
        }
        case ElementKind::Area: return {};
    }
    return {};
}

/// How a path lies to an outline.
class OutlineFollower {
public:
    explicit OutlineFollower(const std::vector<EdgeLoops>& outline) {
        for (const EdgeLoops& region : outline) {
            m_edges.insert(m_edges.end(), region.edges.begin(), region.edges.end());
        }
    }

    /// Does it begin and turn on the outline only? Programs make chords of arcs in either of both.
    [[nodiscard]] bool holdsCornersOf(const std::vector<Edge>& path) const {
        return std::ranges::all_of(
            path, [this](const Edge& edge) { return isNear(edge.a, kRounding) && isNear(edge.b, kRounding); });
    }
    /// Does all of it lie on the outline, or so far beside it that the pen reaches up to it from beyond? At corners it
    /// is farther off by half.
    [[nodiscard]] bool isFollowedBy(const std::vector<Edge>& path, double pen) const {
        return everyPointOf(path, [&](PointD point) {
            return isNear(point, kRounding) || (isNear(point, 0.75 * pen + kRounding) && !holds(point));
        });
    }
    /// Does none of it lie within the outline?
    [[nodiscard]] bool isPassedBy(const std::vector<Edge>& path) const {
        return everyPointOf(path, [this](PointD point) { return isNear(point, kRounding) || !holds(point); });
    }

private:
    template <class Check>
    [[nodiscard]] bool everyPointOf(const std::vector<Edge>& path, const Check& check) const {
        constexpr int kParts = 4;  // of each edge; a line that joins two locations of the outline leaves it in between
        return !m_edges.empty() && std::ranges::all_of(path, [&](const Edge& edge) {
            const double length = lengthOf(edge);
            bool isGood = check(edge.a) && check(edge.b);
            for (int i = 1; i < kParts && isGood && length > 0.0; ++i) {
                isGood = check(pointAt(edge, length * i / kParts));
            }
            return isGood;
        });
    }

    [[nodiscard]] bool isNear(PointD place, double reach) const {
        return std::ranges::any_of(m_edges, [&](const Edge& edge) {
            const PointD nearest = nearestOn(edge, place);
            return std::hypot(nearest.x - place.x, nearest.y - place.y) <= reach;
        });
    }
    [[nodiscard]] bool holds(PointD place) const {
        return std::accumulate(m_edges.begin(), m_edges.end(), 0, [&](int winding, const Edge& edge) {
                   return winding + windingAround(edge, place);
               }) != 0;
    }

    std::vector<Edge> m_edges;
};

/// What a path on a layer of routed slots is, if it is no slot.
enum class Contour : std::uint8_t { None, Compensated, AlongOutline, WithoutWidth };

Contour contourOf(const RoutedPieces& pieces, const OutlineFollower& outline, const Document& routed,
                  ElementId element) {
    const std::vector<Edge> path = middleLineOf(routed, element);
    if (path.empty()) {
        return Contour::None;
    }
    if (isCompensated(routed, element) && outline.holdsCornersOf(path)) {
        return Contour::Compensated;
    }
    if ((routed.elements.flags[element.row()] & kPlated) != 0) {
        return Contour::None;  // plating of the edge
    }
    const Nm pen = penOf(routed, element);
    if (outline.isFollowedBy(path, static_cast<double>(pen))) {
        return Contour::AlongOutline;
    }
    const bool isAround = pen == 0 && (outline.isPassedBy(path) || pieces.isAroundBoard(routed, element));
    return isAround ? Contour::WithoutWidth : Contour::None;
}

const char* textOf(Contour contour) {
    switch (contour) {
        case Contour::None: break;
        case Contour::Compensated:
            return "a routed path with compensation is the edge of what stays: only what it covers beyond the board "
                   "outline is cut, and it counts as no hole";
        case Contour::AlongOutline:
            return "a routed path goes along the board outline: it counts as no hole, and what it covers within the "
                   "outline is not cut";
        case Contour::WithoutWidth:
            return "a routed path without a width goes around the board: it cuts nothing and counts as no hole";
    }
    return "";
}

/// Elements of one document on the layer of a builder of their own.
class ElementPile {
public:
    explicit ElementPile(const Document& from) : m_from(from), m_copier(m_pile, from) {
        m_pile.beginLayer(m_pile.addLayer({}));
    }
    void add(ElementId element, bool isHole) {
        DocumentBuilder::Origin origin = originOf(m_pile, m_from, element.row());
        if (!isHole) {
            origin.flags &= static_cast<std::uint8_t>(~kHole);
        }
        m_copier.copy(element, origin);
        m_negatives.push_back(0);
    }
    void takeAway(ShapeSketch sketch) {
        m_pile.addArea({m_pile.addShape(std::move(sketch)), {}}, {});
        m_negatives.push_back(1);
    }
    void addTo(DocumentBuilder& builder, std::string_view file) {
        addPainted(builder, m_pile.soFar(), m_negatives, file);
    }

private:
    const Document& m_from;
    DocumentBuilder m_pile;
    ElementCopier m_copier;
    std::vector<std::uint8_t> m_negatives;
};

}  // namespace

void takeOutRouted(DocumentBuilder& builder, std::span<const RoutedLayer> waiting) {
    const Document& board = builder.soFar();
    if (!board.profile.isValid()) {
        return;
    }
    const RoutedPieces pieces(board);
    std::vector<EdgeLoops> taken;
    const auto takeOut = [&](const Layer& layer, const Document& routed, ElementId path) {
        const bool isPlated = (routed.elements.flags[path.row()] & kPlated) != 0;
        std::vector<EdgeLoops> piece = isPlated ? std::vector<EdgeLoops>() : pieces.cutLooseBy(routed, path);
        if (!piece.empty()) {
            builder.diagnostics().report(
                Severity::Info, layer.file, routed.elements.line[path.row()],
                "a closed routed path cuts a piece without copper out of the board; it is taken out of the board's "
                "outline");
            std::ranges::move(piece, std::back_inserter(taken));
        }
    };
    for (const Layer& layer : board.layers) {
        for (std::uint32_t i = 0; i < layer.elements.count && pieces.cuts(layer); ++i) {
            takeOut(layer, board, ElementId{layer.elements.first + i});
        }
    }
    for (const RoutedLayer& layer : waiting) {
        const Document& routed = layer.routed->soFar();
        for (std::size_t i = 0; i < routed.elements.size() && pieces.cuts(board.layer(layer.layer)); ++i) {
            takeOut(board.layer(layer.layer), routed, ElementId{i});
        }
    }
    if (!taken.empty()) {
        builder.setProfile(builder.addShape(sketchOf(pieces.without(taken).regions)), board.profileSource);
    }
}

void addRouted(DocumentBuilder& builder, const RoutedLayer& layer) {
    const Document& routed = layer.routed->soFar();
    const RoutedPieces pieces(builder.soFar());
    const OutlineFollower follower(pieces.outline());
    ElementPile others(routed);
    ElementPile beside(routed);
    for (std::size_t i = 0; i < routed.elements.size(); ++i) {
        const ElementId element{i};
        const Contour contour = contourOf(pieces, follower, routed, element);
        if (contour != Contour::None) {
            builder.diagnostics().report(Severity::Info, layer.file, routed.elements.line[i], textOf(contour));
        }
        const bool isBeside = contour != Contour::None && penOf(routed, element) > 0;
        (isBeside ? beside : others).add(element, contour == Contour::None);
    }
    beside.takeAway(sketchOf(pieces.outline()));
    builder.beginLayer(layer.layer);
    others.addTo(builder, layer.file);
    beside.addTo(builder, layer.file);
}

}  // namespace model::formats
