#include "model/section/section.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <tuple>

#include "model/board/holes.h"
#include "model/section/line_cut.h"
#include "model/text/formatting.h"

namespace model {

namespace {

/// A slanting line is looked up in this many boxes, which hug it; elements in several are met once.
constexpr double kQueries = 64.0;

/// Bores by the heights they pass.
using Bores = std::map<std::pair<Nm, Nm>, std::vector<Interval>>;

/// A straight part of the line.
struct Leg {
    PointD a;
    PointD b;
    double start = 0.0;  ///< how far along the whole line
    double length = 0.0;
};

/// One copy of a step, as a leg meets it.
struct Placed {
    std::uint32_t copy = 0;
    const Document& step;
    const StepCopy& how;
    CutLine line;  ///< in the step's coordinates
};

PointD pointOn(const Leg& leg, double part) {
    return {leg.a.x + (leg.b.x - leg.a.x) * part, leg.a.y + (leg.b.y - leg.a.y) * part};
}

Box boxAround(PointD a, PointD b) {
    const auto down = [](double v) { return static_cast<Nm>(std::floor(v)); };
    Box box;
    box.include(Point{down(std::min(a.x, b.x)), down(std::min(a.y, b.y))});
    box.include(Point{down(std::max(a.x, b.x)) + 1, down(std::max(a.y, b.y)) + 1});
    return box;
}

/// Keeps a far line's coordinates within those of boards.
PointD clamped(PointD p) {
    return {std::clamp<double>(p.x, -base::kMaxCoordinate, base::kMaxCoordinate),
            std::clamp<double>(p.y, -base::kMaxCoordinate, base::kMaxCoordinate)};
}

/// Goes along one line over a board.
class Cutter {
public:
    Cutter(const BoardIndex& index, const std::vector<bool>& layers) : m_index(index), m_layers(layers) {}

    void cut(const Leg& leg) {
        for (std::uint32_t copy = 0; copy < m_index.tree.copies.size(); ++copy) {
            const StepCopy& how = m_index.tree.copies[copy];
            const Document& step = *m_index.tree.steps[how.step];
            const Placed placed{copy, step, how, CutLine::through(leg.a, leg.b).seenFrom(how.placement)};
            for (const std::uint32_t row : near(leg, placed)) {
                cutElementOf(placed, ElementId{row}, leg);
            }
        }
        finishLeg();
    }

    std::vector<SectionPiece> pieces;
    std::vector<SectionPiece> bores;
    std::size_t wallless = 0;  ///< plated areas met, whose walls are not known

private:
    const Document& board() const { return *m_index.board; }

    /// Elements whose boxes the leg meets, rising.
    [[nodiscard]] std::vector<std::uint32_t> near(const Leg& leg, const Placed& placed) const {
        const PointD a = clamped(unplaced(leg.a, placed.how.placement));
        const PointD b = clamped(unplaced(leg.b, placed.how.placement));
        std::vector<std::uint32_t> rows;
        if (!boxAround(a, b).meets(m_index.extents[placed.how.step])) {
            return rows;
        }
        const Leg own{a, b, 0.0, 0.0};
        const bool isSlanting = std::min(std::abs(a.x - b.x), std::abs(a.y - b.y)) > 1e5;
        const double queries = isSlanting ? kQueries : 1.0;
        for (double i = 0.0; i < queries; ++i) {
            m_index.elements[placed.how.step].visit(
                boxAround(pointOn(own, i / queries), pointOn(own, (i + 1.0) / queries)),
                [&](std::uint32_t row) { rows.push_back(row); });
        }
        std::ranges::sort(rows);
        rows.erase(std::unique(rows.begin(), rows.end()), rows.end());
        return rows;
    }

    void cutElementOf(const Placed& placed, ElementId element, const Leg& leg) {
        const Document& step = placed.step;
        const LayerId layer = step.layerOfCopy(step.elements.layer[element.row()], placed.how.isFlipped);
        const std::uint8_t flags = step.elements.flags[element.row()];
        const bool isHole = (flags & kHole) != 0;
        if (!(isHole || m_layers[layer.row()]) || !placed.line.meets(step.boxOf(element))) {
            return;
        }
        ElementCut found = cutElement(step, element, placed.line);
        found.covered = clipped(found.covered, 0.0, leg.length);
        const SectionPiece piece{layer, {placed.copy, element}, 0.0, 0.0, 0, 0};
        if (isHole) {
            add(m_drilled, piece, boreOf(layer), found.covered, leg);
        }
        if (m_layers[layer.row()] && (!isHole || (flags & kPlated) != 0)) {
            const Intervals solid = subtracted(found.covered, found.opening);
            wallless += isHole && solid.empty() && !found.covered.empty() ? 1 : 0;
            const auto heights = isHole ? platingOf(placed, element) : heightsOf(placed, element, layer);
            add(m_found, piece, heights, solid, leg);
        }
    }

    [[nodiscard]] ZRange boreOf(LayerId drill) const {
        const Layer& layer = board().layer(drill);
        return layer.spanTop.isValid() && layer.spanBottom.isValid() ? between(layer.spanTop, layer.spanBottom)
                                                                     : ZRange{layer.z, layer.z + layer.thickness};
    }

    /// None: other drills have taken all of it.
    [[nodiscard]] std::optional<ZRange> platingOf(const Placed& placed, ElementId hole) const {
        const PlatedSpan span = placed.step.platedSpanOf(hole);
        if (!span.top.isValid() || !span.bottom.isValid()) {
            return std::nullopt;
        }
        return between(placed.step.layerOfCopy(span.top, placed.how.isFlipped),
                       placed.step.layerOfCopy(span.bottom, placed.how.isFlipped));
    }

    /// From the outer face of one copper layer to that of the other, in either order.
    [[nodiscard]] ZRange between(LayerId top, LayerId bottom) const {
        const Layer& a = board().layer(top);
        const Layer& b = board().layer(bottom);
        return {std::min(a.z, b.z), std::max(a.z + a.thickness, b.z + b.thickness)};
    }

    [[nodiscard]] std::optional<ZRange> heightsOf(const Placed& placed, ElementId element, LayerId onBoard) const {
        const Layer& own = placed.step.layer(placed.step.elements.layer[element.row()]);
        const Layer& layer = board().layer(onBoard);
        const ZRange z = placed.step.heightsOf(element);
        const Nm above = placed.how.isFlipped ? own.z + own.thickness - z.top : z.bottom - own.z;
        return ZRange{layer.z + above, layer.z + above + (z.top - z.bottom)};
    }

    static void add(std::vector<SectionPiece>& to, SectionPiece piece, const std::optional<ZRange>& heights,
                    const Intervals& intervals, const Leg& leg) {
        if (!heights) {
            return;
        }
        piece.bottom = heights->bottom;
        piece.top = heights->top;
        for (const Interval& interval : intervals) {
            piece.from = leg.start + interval.from;
            piece.to = leg.start + interval.to;
            to.push_back(piece);
        }
    }

    /// Takes what a leg has drilled out of what it has found.
    void finishLeg() {
        Bores byHeight;
        for (const SectionPiece& bore : m_drilled) {
            byHeight[{bore.bottom, bore.top}].push_back({bore.from, bore.to});
        }
        for (auto& [heights, locations] : byHeight) {
            locations = united(std::move(locations));
        }
        for (const SectionPiece& piece : m_found) {
            for (const Interval& interval : outsideOf(byHeight, piece)) {
                pieces.push_back(piece);
                pieces.back().from = interval.from;
                pieces.back().to = interval.to;
            }
        }
        bores.insert(bores.end(), m_drilled.begin(), m_drilled.end());
        m_found.clear();
        m_drilled.clear();
    }

    [[nodiscard]] Intervals outsideOf(const Bores& byHeight, const SectionPiece& piece) const {
        Intervals rest = {{piece.from, piece.to}};
        const Layer& layer = board().layer(piece.layer);
        if (!layer.isCopper() && layer.type != LayerType::Dielectric) {
            return rest;
        }
        for (const auto& [heights, locations] : byHeight) {
            if (heights.first <= piece.bottom && heights.second >= piece.top) {
                rest = subtracted(rest, locations);
            }
        }
        return rest;
    }

    const BoardIndex& m_index;
    const std::vector<bool>& m_layers;
    std::vector<SectionPiece> m_found;  ///< by the leg at work
    std::vector<SectionPiece> m_drilled;
};

base::Result<std::vector<Leg>> legsOf(const std::vector<PointD>& line) {
    const auto error = [](const char* why) { return base::Error{base::ErrorCode::BadUsage, why}; };
    if (line.size() > kMostCorners) {
        return error("a section line has 10000 corners at most");
    }
    std::vector<Leg> legs;
    double start = 0.0;
    for (std::size_t i = 0; i < line.size(); ++i) {
        const bool isOnBoards =
            std::abs(line[i].x) <= base::kMaxCoordinate && std::abs(line[i].y) <= base::kMaxCoordinate;
        if (!isOnBoards) {
            return error("the section line leaves the coordinates of boards (1.07 m around the origin)");
        }
        const double length = i == 0 ? 0.0 : std::hypot(line[i].x - line[i - 1].x, line[i].y - line[i - 1].y);
        if (length > 0.0) {
            legs.push_back({line[i - 1], line[i], start, length});
            start += length;
        }
    }
    if (legs.empty()) {
        return error("a section line needs two locations that are apart");
    }
    return legs;
}

std::vector<bool> layersWithSubstance(const Document& board) {
    std::vector<bool> layers;
    for (const Layer& layer : board.layers) {
        layers.push_back(hasSubstance(layer));
    }
    return layers;
}

/// Names of the cut layers that have a property.
template <class Has>
std::string cutLayers(const Document& board, const std::vector<SectionPiece>& pieces, Has has) {
    std::vector<bool> hasSection(board.layers.size());
    for (const SectionPiece& piece : pieces) {
        hasSection[piece.layer.row()] = true;
    }
    std::vector<std::string> names;
    for (std::size_t row = 0; row < board.layers.size(); ++row) {
        if (hasSection[row] && has(board.layers[row])) {
            names.push_back(board.layers[row].name);
        }
    }
    return joined(names);
}

void addNotes(const Document& board, std::size_t wallless, Section& section) {
    if (wallless > 0) {
        section.notes.push_back("plated holes without a known plating thickness, drawn without it: " +
                                std::to_string(wallless));
    }
    if (section.pieces.empty() && section.bores.empty()) {
        section.notes.push_back("the line meets nothing of the board");
    }
    // Holes and the substrate follow from other layers, bodies of components have heights of their own.
    const auto hasOwn = [](const Layer& l) {
        return !isHoles(l.type) && l.type != LayerType::Body && l.type != LayerType::ComponentBody;
    };
    const std::string flat =
        cutLayers(board, section.pieces, [&](const Layer& l) { return l.thickness == 0 && hasOwn(l); });
    if (!flat.empty()) {
        section.notes.push_back("without a thickness, drawn as a line: " + flat);
    }
    const std::string assumed = cutLayers(board, section.pieces, [&](const Layer& l) {
        return l.thickness > 0 && l.thicknessSource == Source::Assumed && hasOwn(l);
    });
    if (!assumed.empty()) {
        section.notes.push_back("thickness assumed: " + assumed);
    }
}

void sort(std::vector<SectionPiece>& pieces) {
    std::ranges::sort(pieces, {}, [](const SectionPiece& p) {
        return std::tuple(p.layer, p.from, p.bottom, p.at.copy, p.at.element, p.to, p.top);
    });
}

}  // namespace

bool hasSubstance(const Layer& layer) {
    switch (layer.type) {
        case LayerType::SolderMask: return layer.isSynthetic;
        case LayerType::Document:
        case LayerType::Profile:
        case LayerType::Component:
        case LayerType::Mask:
        case LayerType::Other: return false;
        default: return layer.context == LayerContext::Board;
    }
}

base::Result<Section> makeSection(const BoardIndex& index, const SectionRequest& request) {
    ASSIGN_OR_RETURN(const std::vector<Leg> legs, legsOf(request.line));
    const std::vector<bool> layers = request.layers.empty() ? layersWithSubstance(*index.board) : request.layers;
    Cutter cutter(index, layers);
    Section section;
    section.line.push_back(legs.front().a);
    section.stations.push_back(0.0);
    for (const Leg& leg : legs) {
        cutter.cut(leg);
        section.line.push_back(leg.b);
        section.stations.push_back(leg.start + leg.length);
    }
    section.pieces = std::move(cutter.pieces);
    section.bores = std::move(cutter.bores);
    sort(section.pieces);
    sort(section.bores);
    addNotes(*index.board, cutter.wallless, section);
    return section;
}

std::vector<SectionPiece> merged(const std::vector<SectionPiece>& pieces) {
    std::map<std::tuple<LayerId, Nm, Nm>, std::vector<Interval>> byHeight;
    for (const SectionPiece& piece : pieces) {
        byHeight[{piece.layer, piece.bottom, piece.top}].push_back({piece.from, piece.to});
    }
    std::vector<SectionPiece> out;
    for (auto& [key, intervals] : byHeight) {
        const auto& [layer, bottom, top] = key;
        for (const Interval& interval : united(std::move(intervals))) {
            out.push_back({layer, {}, interval.from, interval.to, bottom, top});
        }
    }
    return out;
}

}  // namespace model
