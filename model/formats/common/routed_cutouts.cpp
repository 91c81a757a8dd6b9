#include "model/formats/common/routed_cutouts.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <numeric>
#include <utility>
#include <vector>

#include "model/board/element_copy.h"
#include "model/formats/common/element_regions.h"
#include "model/formats/common/painting.h"
#include "model/geometry/outlines.h"
#include "model/solids/shells/area_shell.h"

namespace model::formats {

namespace {

/// Copper that covers less than this of a piece only touches it, nm²: the smallest pads are ten times as large.
constexpr double kTouch = 3e9;
/// Programs round the ends of paths, and the paths along an outline, by less than this.
constexpr double kRounding = 5'000.0;

double distance(Point a, Point b) {
    return std::hypot(double(a.x) - b.x, double(a.y) - b.y);
}

double areaOf(const std::vector<EdgeLoops>& regions) {
    return std::accumulate(regions.begin(), regions.end(), 0.0,
                           [](double sum, const EdgeLoops& region) { return sum + model::areaOf(region); });
}

double overlap(const std::vector<EdgeLoops>& piece, const std::vector<EdgeLoops>& with) {
    return areaOf(piece) - areaOf(differenceOf(piece, with).regions);
}

bool isBoardCopper(const Layer& layer) {
    return layer.isCopper() && layer.context == LayerContext::Board;
}

class RoutedPieces {
public:
    explicit RoutedPieces(const Document& board)
        : m_board(board), m_outline(areaOutlines(board.shapes, board.profile)), m_half(areaOf(m_outline) / 2.0) {}

    /// What an element of the document cuts loose; empty: nothing.
    [[nodiscard]] std::vector<EdgeLoops> cutLooseBy(const Document& routed, ElementId path) const {
        std::vector<EdgeLoops> piece = enclosedBy(routed, path);
        const double area = areaOf(piece);
        const bool isPiece = area > 0.0 && area < m_half && overlap(piece, m_outline) > area / 2.0;
        return isPiece && !holdsCopper(piece) ? piece : std::vector<EdgeLoops>();
    }

    /// Layers whose paths go through the whole board.
    [[nodiscard]] bool cuts(const Layer& layer) const {
        return layer.type == LayerType::Rout && layer.use == LayerUse::Plain &&
               std::ranges::all_of(m_board.layers, [&](const Layer& copper) {
                   const auto row = static_cast<std::size_t>(&copper - m_board.layers.data());
                   return !isBoardCopper(copper) || layer.spans(LayerId{row});
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
            for (std::uint32_t i = 0; i < layer.elements.count && isBoardCopper(layer); ++i) {
                const ElementId id{layer.elements.first + i};
                const bool isLookedAt = (m_board.elements.kind[id.row()] == ElementKind::Area) == areas;
                if (isLookedAt && box.meets(m_board.boxOf(id)) &&
                    overlap(piece, regionsOf(m_board, id).regions) > kTouch) {
                    return true;
                }
            }
        }
        return false;
    }

    const Document& m_board;
    std::vector<EdgeLoops> m_outline;
    double m_half;
};

bool isCompensated(const Document& routed, ElementId element) {
    return std::ranges::any_of(routed.attributesOf(element), [](const auto& attribute) {
        return attribute.first == ".comp" && attribute.second != "none" && attribute.second != "0";
    });
}

/// Finds what lies on an outline.
class OutlineFollower {
public:
    explicit OutlineFollower(const std::vector<EdgeLoops>& outline) {
        for (const EdgeLoops& region : outline) {
            m_edges.insert(m_edges.end(), region.edges.begin(), region.edges.end());
        }
    }

    /// Does the middle line of the pen follow the outline?
    [[nodiscard]] bool isFollowedBy(const Document& routed, ElementId element) const {
        const std::uint32_t row = routed.elements.geometry[element.row()];
        switch (routed.elements.kind[element.row()]) {
            case ElementKind::Line: return isOn(routed.lines[row].a) && isOn(routed.lines[row].b);
            case ElementKind::Arc: return isOn(routed.arcs[row].node.point) && isOn(routed.arcs[row].end);
            case ElementKind::Circle: return isOn(routed.circles[row].centre);
            case ElementKind::Trail:
                return std::ranges::all_of(routed.nodesOf(routed.trails[row]),
                                           [this](const PathNode& node) { return isOn(node.point); });
            case ElementKind::Area: return false;
        }
        return false;
    }

private:
    [[nodiscard]] bool isOn(Point point) const {
        const PointD place{static_cast<double>(point.x), static_cast<double>(point.y)};
        return std::ranges::any_of(m_edges, [&](const Edge& edge) {
            const PointD nearest = nearestOn(edge, place);
            return std::hypot(nearest.x - place.x, nearest.y - place.y) <= kRounding;
        });
    }

    std::vector<Edge> m_edges;
};

/// Elements of one document on the layer of a builder of their own.
class ElementPile {
public:
    explicit ElementPile(const Document& from) : m_from(from), m_copier(m_pile, from) {
        m_pile.beginLayer(m_pile.addLayer({}));
    }
    void add(ElementId element) {
        m_copier.copy(element, originOf(m_pile, m_from, element.row()));
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
        builder.setProfile(builder.addShape(sketchOf(pieces.without(taken).regions)));
    }
}

void addRouted(DocumentBuilder& builder, const RoutedLayer& layer) {
    const Document& routed = layer.routed->soFar();
    const Document& board = builder.soFar();
    const std::vector<EdgeLoops> outline =
        board.profile.isValid() ? areaOutlines(board.shapes, board.profile) : std::vector<EdgeLoops>();
    const OutlineFollower follower(outline);
    ElementPile others(routed);
    ElementPile beside(routed);
    for (std::size_t i = 0; i < routed.elements.size(); ++i) {
        const ElementId element{i};
        if (isCompensated(routed, element) && follower.isFollowedBy(routed, element)) {
            builder.diagnostics().report(Severity::Info, layer.file, routed.elements.line[i],
                                         "a routed path with compensation is the edge of what stays: only what it "
                                         "covers beyond the board outline is cut");
            beside.add(element);
        } else {
            others.add(element);
        }
    }
    beside.takeAway(sketchOf(outline));
    builder.beginLayer(layer.layer);
    others.addTo(builder, layer.file);
    beside.addTo(builder, layer.file);
}

}  // namespace model::formats
