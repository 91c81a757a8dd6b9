#include "model/formats/common/routed_cutouts.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <numeric>
#include <optional>
#include <vector>

#include "model/formats/common/element_regions.h"
#include "model/geometry/outlines.h"
#include "model/solids/shells/area_shell.h"

namespace model::formats {

namespace {

/// Copper that covers less than this of a piece only touches it, nm²: the smallest pads are ten times as large.
constexpr double kTouch = 3e9;

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

    /// What the element cuts loose; empty: nothing.
    [[nodiscard]] std::vector<EdgeLoops> cutLooseBy(ElementId path) const {
        std::vector<EdgeLoops> piece = enclosedBy(path);
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
    [[nodiscard]] std::vector<EdgeLoops> enclosedBy(ElementId path) const {
        ShapeSketch sketch;
        const std::uint32_t row = m_board.elements.geometry[path.row()];
        if (m_board.elements.kind[path.row()] == ElementKind::Trail) {
            const TrailGeometry& trail = m_board.trails[row];
            const std::span<const PathNode> nodes = m_board.nodesOf(trail);
            if (isClosed(nodes, trail.width)) {
                addPath(sketch, nodes.first(nodes.size() - 1), false);
            }
        } else if (m_board.elements.kind[path.row()] == ElementKind::Arc) {
            const ArcGeometry& arc = m_board.arcs[row];
            if (arc.node.point == arc.end) {
                addPath(sketch, std::span(&arc.node, 1), false);
            }
        }
        return sketch.isEmpty() ? std::vector<EdgeLoops>() : unionOf(regionsOf(sketch)).regions;
    }

    /// Do both ends of the cutter's way overlap?
    static bool isClosed(std::span<const PathNode> nodes, Nm width) {
        const Point from = nodes.front().point;
        const Point to = nodes.back().point;
        return nodes.size() > 2 && std::hypot(double(from.x) - to.x, double(from.y) - to.y) <= width / 2.0;
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

}  // namespace

void takeOutRouted(DocumentBuilder& builder) {
    const Document& board = builder.soFar();
    if (!board.profile.isValid()) {
        return;
    }
    const RoutedPieces pieces(board);
    std::vector<EdgeLoops> taken;
    for (const Layer& layer : board.layers) {
        for (std::uint32_t i = 0; i < layer.elements.count && pieces.cuts(layer); ++i) {
            const ElementId path{layer.elements.first + i};
            const bool isPlated = (board.elements.flags[path.row()] & kPlated) != 0;
            std::vector<EdgeLoops> piece = isPlated ? std::vector<EdgeLoops>() : pieces.cutLooseBy(path);
            if (!piece.empty()) {
                builder.diagnostics().report(Severity::Info, layer.file, board.elements.line[path.row()],
                                             "a closed routed path cuts a piece without copper out of the board; it is "
                                             "taken out of the board's outline");
                std::ranges::move(piece, std::back_inserter(taken));
            }
        }
    }
    if (!taken.empty()) {
        builder.setProfile(builder.addShape(sketchOf(pieces.without(taken).regions)));
    }
}

}  // namespace model::formats
