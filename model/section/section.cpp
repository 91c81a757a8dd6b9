#include "model/section/section.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <optional>
#include <tuple>

#include "model/base/parallel.h"
#include "model/board/holes.h"
#include "model/board/laser_via.h"
#include "model/section/leg_shape.h"
#include "model/section/line_cut.h"
#include "model/section/section_notes.h"
#include "model/section/standing_parts.h"

namespace model {

namespace {

/// Leads reach no farther beyond the body of a component.
constexpr Nm kLeads = 10 * kMm;

/// A slanting line is looked up in this many boxes, which hug it; elements in several are met once.
constexpr double kQueries = 64.0;

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
    Cutter(const BoardIndex& index, const std::vector<bool>& layers, const SectionRequest& request)
        : m_index(index),
          m_layers(layers),
          m_isAsSolid(request.isAsSolid),
          m_milled(request.milled),
          m_outlines(index),
          m_shaper(*index.board, request.isAsSolid) {
        if (!m_isAsSolid) {
            findBodies();
        }
    }

    void cut(const Leg& leg) {
        for (std::uint32_t copy = 0; copy < m_index.tree.copies.size(); ++copy) {
            const StepCopy& how = m_index.tree.copies[copy];
            const Document& step = *m_index.tree.steps[how.step];
            const Placed placed{copy, step, how, CutLine::through(leg.a, leg.b).seenFrom(how.placement)};
            meetMilling(placed);
            cutElements(placed, leg);
            cutParts(placed, leg);
        }
        for (auto [layer, locations] : m_outlines.between(leg.a, leg.b)) {
            for (Interval& location : locations) {
                location = {leg.start + location.from, leg.start + location.to};
            }
            m_leg.ranges[layer] = std::move(locations);
        }
        if (!m_isAsSolid) {
            addUndrawn();
        }
        finishLeg(leg);
    }

    std::vector<SectionPiece> pieces;
    std::vector<SectionPiece> bores;
    CutFindings findings;

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

    /// Without what the line meets of it.
    [[nodiscard]] SectionPiece pieceOf(const Placed& placed, ElementId element) const {
        const LayerId own = placed.step.elements.layer[element.row()];
        SectionPiece piece{placed.step.layerOfCopy(own, placed.how.isFlipped), {placed.copy, element}};
        piece.material = materialOf(board(), piece.layer);
        piece.isMirrored = isMirroredInCopy(placed.step, own, placed.how.isFlipped);
        return piece;
    }

    [[nodiscard]] bool isCut(const Placed& placed, ElementId element) const {
        const Document& step = placed.step;
        const LayerId layer = step.layerOfCopy(step.elements.layer[element.row()], placed.how.isFlipped);
        const bool isHole = (step.elements.flags[element.row()] & kHole) != 0;
        const bool isPart = board().layer(layer).type == LayerType::ComponentBody && !m_isAsSolid;
        const bool isLeftCopper = !isHole && !m_layers[layer.row()] && board().layer(layer).isCopper() && !m_isAsSolid;
        return !isPart && (isHole || isLeftCopper || m_layers[layer.row()]) && placed.line.meets(step.boxOf(element));
    }

    /// Most of the time goes into edges of large areas: all cores take part.
    void cutElements(const Placed& placed, const Leg& leg) {
        std::vector<std::uint32_t> rows = near(leg, placed);
        std::erase_if(rows, [&](std::uint32_t row) { return !isCut(placed, ElementId{row}); });
        std::vector<ElementCut> found(rows.size());
        base::parallelFor(rows.size(),
                          [&](std::size_t i) { found[i] = cutElement(placed.step, ElementId{rows[i]}, placed.line); });
        for (std::size_t i = 0; i < rows.size(); ++i) {
            take(placed, ElementId{rows[i]}, std::move(found[i]), leg);
        }
    }

    /// What the line meets of an element that is cut.
    void take(const Placed& placed, ElementId element, ElementCut found, const Leg& leg) {
        const Document& step = placed.step;
        const LayerId layer = step.layerOfCopy(step.elements.layer[element.row()], placed.how.isFlipped);
        const std::uint8_t flags = step.elements.flags[element.row()];
        const bool isHole = (flags & kHole) != 0;
        const bool isLeftCopper = !isHole && !m_layers[layer.row()];  // no other layer that is left out is cut
        // A short leg may lie within the bore altogether: walls are looked for all along its line.
        const bool hasWalls = !subtracted(found.covered, found.opening).empty();
        found.covered = clipped(found.covered, 0.0, leg.length);
        const bool isMilled = isOfMilled(placed, element) && mill({placed.copy, element}, found.covered);
        const SectionPiece piece = pieceOf(placed, element);
        const std::optional<LandingVia> via =
            isHole && !isMilled && !found.covered.empty() ? landingOf(placed, element, leg) : std::nullopt;
        if (isHole) {
            const ZRange bore = via ? ZRange{std::min(via->entry, via->target), std::max(via->entry, via->target)}
                                    : boreOf(placed, element);
            add(m_leg.bores, SectionPiece{layer, piece.at}, bore, found.covered, leg);
        }
        if (via && m_layers[layer.row()]) {
            m_leg.vias.emplace_back(*via, piece);
            ++findings.landed;
        } else if (isLeftCopper) {
            add(m_leg.leftCopper, piece, heightsInCopy(step, element, placed.how.isFlipped), found.covered, leg);
        } else if (m_layers[layer.row()] && (!isHole || (flags & kPlated) != 0)) {
            const Intervals solid = subtracted(found.covered, found.opening);
            if (isHole && !hasWalls && !found.covered.empty()) {
                findings.wallless.emplace(placed.copy, element);
            }
            const auto heights =
                isHole ? platingOf(placed, element) : heightsInCopy(step, element, placed.how.isFlipped);
            add(m_leg.pieces, piece, heights, solid, leg);
        }
    }

    [[nodiscard]] bool isOfMilled(const Placed& placed, ElementId element) const {
        return placed.how.step < m_milled.size() && std::ranges::binary_search(m_milled[placed.how.step], element);
    }

    /// Finds where milling leaves nothing. Other steps than the board itself are milled from a panel later, but their
    /// cut-outs are open.
    void meetMilling(const Placed& placed) {
        if (placed.how.step >= m_milled.size() || m_milled[placed.how.step].empty()) {
            return;
        }
        const ShapeTable& shapes = placed.step.shapes;
        const ShapeId outline = placed.step.profile;
        constexpr double kFar = std::numeric_limits<double>::max();
        m_open = placed.copy == 0 ? subtracted({{-kFar, kFar}}, cutShape(shapes, outline, placed.line))
                                  : cutHolesOf(shapes, outline, placed.line);
    }

    /// Leaves of an element what milling leaves. False: that is all of it.
    bool mill(const BoardElement& element, Intervals& covered) {
        Intervals rest = subtracted(covered, m_open);
        if (rest == covered) {
            return false;
        }
        covered = std::move(rest);
        findings.milled.insert(element);
        return true;
    }

    /// Once for all legs: turned bodies are placed to be measured.
    void findBodies() {
        for (const Document* step : m_index.tree.steps) {
            std::vector<Box>& boxes = m_bodyBoxes.emplace_back();
            for (const Body& body : step->bodies) {
                boxes.push_back(step->boxOf(body.element).grownBy(kLeads));
            }
        }
    }

    /// Components whose leads may be met: those reach beyond the element of the body.
    void cutParts(const Placed& placed, const Leg& leg) {
        if (m_isAsSolid) {
            return;  // they are prisms then
        }
        const Box around =
            boxAround(clamped(unplaced(leg.a, placed.how.placement)), clamped(unplaced(leg.b, placed.how.placement)));
        const std::vector<Box>& boxes = m_bodyBoxes[placed.how.step];
        for (std::size_t row = 0; row < boxes.size(); ++row) {
            if (!boxes[row].meets(around) || !placed.line.meets(boxes[row])) {
                continue;
            }
            const Body& body = placed.step.bodies[row];
            const LayerId layer =
                placed.step.layerOfCopy(placed.step.elements.layer[body.element.row()], placed.how.isFlipped);
            if (m_layers[layer.row()]) {
                cutPart(placed, body, layer, leg);
            }
        }
    }

    void cutPart(const Placed& placed, const Body& body, LayerId layer, const Leg& leg) {
        const BodyPlan none;
        const SectionPiece like{layer, {placed.copy, body.element}};
        const LayerId own = placed.step.elements.layer[body.element.row()];
        StandingPart part{!growsDownInCopy(placed.step, own, placed.how.isFlipped), placed.how.isFlipped, {}};
        const BodyPlan& plan = body.component.isValid() ? m_plans.of(placed.step, body.component) : none;
        for (SectionPiece piece : partPieces(placed.step, body, plan, placed.line, like)) {
            piece.from = leg.start + std::clamp(piece.from, 0.0, leg.length);
            piece.to = leg.start + std::clamp(piece.to, 0.0, leg.length);
            if (piece.from < piece.to) {
                part.pieces.push_back(piece);
            }
        }
        if (!part.pieces.empty()) {
            m_leg.parts.push_back(std::move(part));
        }
    }

    /// A laser via, which ends on its target pad.
    [[nodiscard]] std::optional<LandingVia> landingOf(const Placed& placed, ElementId hole, const Leg& leg) const {
        const Document& step = placed.step;
        const LayerId landsOn = targetOf(step, hole);
        if (!landsOn.isValid()) {
            return std::nullopt;
        }
        const Layer& drill = step.layer(step.elements.layer[hole.row()]);
        const LayerId beginsOn = landsOn == drill.spanTop ? drill.spanBottom : drill.spanTop;
        const ZRange entry = heightsInCopy(step, beginsOn, placed.how.isFlipped);
        const ZRange target = heightsInCopy(step, landsOn, placed.how.isFlipped);
        const bool isFromTop = entry.bottom > target.bottom;
        const auto faceOf = [](const ZRange& of, bool isUpper) { return isUpper ? of.top : of.bottom; };
        const CircleGeometry& circle = step.circles[step.elements.geometry[hole.row()]];
        const PointD centre = base::toDouble(circle.centre);
        LandingVia via{leg.start + placed.line.along(centre), std::abs(placed.line.beside(centre)),
                       circle.diameter / 2.0, (double{1} * circle.diameter - circle.innerDiameter) / 2};
        via.entry = faceOf(entry, isFromTop);
        via.shoulder = faceOf(entry, !isFromTop);
        via.target = faceOf(target, isFromTop);
        return via.shoulder != via.target ? std::optional(via) : std::nullopt;
    }

    [[nodiscard]] static ZRange boreOf(const Placed& placed, ElementId hole) {
        const LayerId drill = placed.step.elements.layer[hole.row()];
        const Layer& layer = placed.step.layer(drill);
        return layer.spanTop.isValid() && layer.spanBottom.isValid()
                   ? heightsInCopy(placed.step, layer.spanTop, layer.spanBottom, placed.how.isFlipped)
                   : heightsInCopy(placed.step, drill, placed.how.isFlipped);
    }

    /// None: other drills have taken all of it.
    [[nodiscard]] static std::optional<ZRange> platingOf(const Placed& placed, ElementId hole) {
        const PlatedSpan span = placed.step.platedSpanOf(hole);
        if (!span.top.isValid() || !span.bottom.isValid()) {
            return std::nullopt;
        }
        return heightsInCopy(placed.step, span.top, span.bottom, placed.how.isFlipped);
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

    /// Films of which the job draws nothing are all over the zones that have them, but for holes that are no vias.
    void addUndrawn() {
        std::vector<Interval> holes;
        for (const SectionPiece& bore : m_leg.bores) {
            const Document& step = m_index.stepOf(bore.at.copy);
            if ((step.elements.flags[bore.at.element.row()] & kVia) == 0) {
                holes.push_back({bore.from, bore.to});
            }
        }
        const Intervals taken = united(std::move(holes));
        for (const auto& [layer, locations] : m_leg.ranges) {
            if (!isUndrawnFilm(layer)) {
                continue;
            }
            for (const Interval& location : subtracted(locations, taken)) {
                SectionPiece piece{layer, {}, location.from, location.to};
                piece.bottom = board().layer(layer).z;
                piece.top = piece.bottom + board().layer(layer).thickness;
                piece.material = materialOf(board(), layer);
                m_leg.pieces.push_back(piece);
                findings.undrawn.insert(layer);
            }
        }
    }

    [[nodiscard]] bool isUndrawnFilm(LayerId id) const {
        const auto isEmpty = [](const Layer& layer) {
            return std::ranges::all_of(layer.countsWithCopies, [](std::uint64_t count) { return count == 0; });
        };
        const auto mask = std::ranges::find(board().layers, id, &Layer::openings);
        const bool isMask = mask != board().layers.end();
        const auto shown = isMask ? static_cast<std::size_t>(mask - board().layers.begin()) : id.row();
        return isLaidOn(board().layer(id)) && m_layers[shown] && isEmpty(board().layer(id)) &&
               (!isMask || isEmpty(*mask));
    }

    /// Takes what a leg has drilled out of what it has found.
    void finishLeg(const Leg& leg) {
        drill(m_leg.pieces);
        drill(m_leg.leftCopper);
        bores.insert(bores.end(), m_leg.bores.begin(), m_leg.bores.end());
        m_leg.from = leg.start;
        m_leg.to = leg.start + leg.length;
        const std::vector<SectionPiece> shaped = m_shaper.shape(std::move(m_leg));
        pieces.insert(pieces.end(), shaped.begin(), shaped.end());
        m_leg = {};
    }

    void drill(std::vector<SectionPiece>& found) const {
        std::map<std::pair<Nm, Nm>, Intervals> drilled;  // pieces have few heights
        std::vector<SectionPiece> left;
        for (const SectionPiece& piece : found) {
            const Layer& layer = board().layer(piece.layer);
            if (!layer.isCopper() && layer.type != LayerType::Dielectric) {
                left.push_back(piece);
                continue;
            }
            const auto [taken, isNew] = drilled.try_emplace({piece.bottom, piece.top});
            if (isNew) {
                taken->second = drilledThrough(piece.bottom, piece.top);
            }
            for (const Interval& interval : subtracted({{piece.from, piece.to}}, taken->second)) {
                left.push_back(piece);
                left.back().from = interval.from;
                left.back().to = interval.to;
            }
        }
        found = std::move(left);
    }

    /// Where bores of the leg go all the way from one height to another.
    [[nodiscard]] Intervals drilledThrough(Nm bottom, Nm top) const {
        std::vector<Interval> through;
        for (const SectionPiece& bore : m_leg.bores) {
            if (bore.bottom <= bottom && bore.top >= top) {
                through.push_back({bore.from, bore.to});
            }
        }
        return united(std::move(through));
    }

    const BoardIndex& m_index;
    const std::vector<bool>& m_layers;
    bool m_isAsSolid = false;
    const std::vector<std::vector<ElementId>>& m_milled;  ///< by step
    Intervals m_open;  ///< where on the leg milling leaves nothing of the copy that is cut
    LayerOutlines m_outlines;
    LegShaper m_shaper;
    std::vector<std::vector<Box>> m_bodyBoxes;  ///< by step and body, with where leads may be; none as solid
    PartPlans m_plans;
    LegCut m_leg;  ///< at work
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

void sort(std::vector<SectionPiece>& pieces) {
    std::ranges::sort(pieces, {}, [](const SectionPiece& p) {
        return std::tuple(p.layer, p.from, p.bottom, p.at.copy, p.at.element, p.to, p.top);
    });
}

}  // namespace

bool hasSubstance(const Layer& layer) {
    switch (layer.type) {
        case LayerType::SolderMask: return layer.isSynthetic;
        case LayerType::Mask: return layer.context == LayerContext::Board && isLaidOn(layer);
        case LayerType::Document:
        case LayerType::Profile:
        case LayerType::Component:
        case LayerType::Other: return false;
        default: return layer.context == LayerContext::Board;
    }
}

base::Result<Section> makeSection(const BoardIndex& index, const SectionRequest& request) {
    ASSIGN_OR_RETURN(const std::vector<Leg> legs, legsOf(request.line));
    const std::vector<bool> layers = request.layers.empty() ? layersWithSubstance(*index.board) : request.layers;
    Cutter cutter(index, layers, request);
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
    addNotes(*index.board, cutter.findings, section);
    if (!request.isAsSolid) {
        addAssumptions(*index.board, cutter.findings, section);
    }
    return section;
}

std::vector<double> bendsOf(const Section& section) {
    constexpr double kStraight = 0.98480775301;  // cosine of 10 degrees
    std::vector<double> bends;
    for (std::size_t i = 1; i + 1 < section.line.size(); ++i) {
        const CutLine before = CutLine::through(section.line[i - 1], section.line[i]);
        const CutLine behind = CutLine::through(section.line[i], section.line[i + 1]);
        if (before.unit.x * behind.unit.x + before.unit.y * behind.unit.y < kStraight) {
            bends.push_back(section.stations[i]);
        }
    }
    return bends;
}

std::vector<SectionPiece> merged(const std::vector<SectionPiece>& pieces) {
    std::map<std::tuple<LayerId, Nm, Nm, SectionMaterial, bool>, std::vector<Interval>> byHeight;
    std::vector<SectionPiece> out;
    for (const SectionPiece& piece : pieces) {
        if (piece.leans()) {
            out.push_back(piece);
            out.back().at = {};
        } else {
            byHeight[{piece.layer, piece.bottom, piece.top, piece.material, piece.isMirrored}].push_back(
                {piece.from, piece.to});
        }
    }
    for (auto& [key, intervals] : byHeight) {
        const auto& [layer, bottom, top, material, isMirrored] = key;
        for (const Interval& interval : united(std::move(intervals))) {
            out.push_back({layer, {}, interval.from, interval.to, bottom, top, 0.0, 0.0, material, {}, isMirrored});
        }
    }
    std::ranges::stable_sort(out, {}, &SectionPiece::layer);
    return out;
}

}  // namespace model
