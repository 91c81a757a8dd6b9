#include "model/formats/common/element_maker.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "model/geometry/boolean.h"
#include "model/geometry/outlines.h"
#include "model/geometry/region.h"
#include "model/geometry/swept_tracks.h"

namespace model::formats {

namespace {

/// Lasers drill 25 µm and more.
constexpr Nm kLeastHole = 5'000;

/// What a stroke draws in the text's own system.
PolygonSet sweptBy(const TextStroke& stroke) {
    ShapeSketch pen;
    if (stroke.isSquare) {
        addBox(pen, stroke.width, stroke.width, false);
    } else {
        model::addDisc(pen, stroke.width, false);
    }
    return stroke.width > 0 ? sweep(polygonsOf(pen), {rounded(stroke.a), {}, EdgeKind::Line}, rounded(stroke.b))
                            : PolygonSet{};
}

}  // namespace

void ElementMaker::report(Severity severity, const ElementSource& source, std::string_view text) {
    m_diagnostics.report(severity, m_path, source.origin.line, text);
}

DocumentBuilder::Origin ElementMaker::originOf(const ElementSource& source, int flags) const {
    DocumentBuilder::Origin origin = source.origin;
    origin.flags = static_cast<std::uint8_t>(flags | (m_holes != nullptr ? kHole : 0));
    return origin;
}

/// The hole that is made, with its flags put into `origin`; off layers of holes what is drawn.
Hole ElementMaker::drill(const ElementSource& source, Nm size, DocumentBuilder::Origin& origin) {
    if (m_holes == nullptr) {
        return {0, size};
    }
    const Hole hole = m_holes->hole(source.hit, size);
    origin.flags = static_cast<std::uint8_t>(origin.flags | hole.flags);
    const bool isPlated = (hole.flags & kPlated) != 0;
    if (hole.isPlatingAssumed) {
        report(Severity::Info, source,
               isPlated ? "neither the feature nor the tools say whether the hole is plated; taken as plated"
                        : "neither the feature nor the tools say whether the hole is plated; taken as NPTH");
    }
    if (hole.isBarrelAssumed) {
        report(Severity::Info, source,
               "the job does not say how thick the copper in plated holes is; taken as 25 µm inside of the hole");
    }
    if (size > 0 && size < kLeastHole) {
        report(Severity::Warning, source,
               "the hole is less than 5 µm wide, which nothing drills; the job may mean another unit");
    }
    if (hole.isContradicted) {
        report(Severity::Warning, source,
               "the feature and the tool of this size disagree about plating; the feature is believed");
    }
    return hole;
}

// ---- tracks ----

void ElementMaker::addTrack(const ElementSource& source, const PadShape& pen, PathNode start, Point end) {
    if (pen.kind == PadShape::Kind::Nothing) {
        return endChain();
    }
    if (start.edge != EdgeKind::Line && (start.point == start.centre || end == start.centre)) {
        report(Severity::Warning, source, "an arc without a radius; taken as a straight line");
        start.edge = EdgeKind::Line;
    }
    if (pen.kind == PadShape::Kind::Round) {
        const bool isJoined = continues(source, start.point, pen.width);
        return extend(source, start, {end, {}, EdgeKind::Line}, pen.width, isJoined);
    }
    endChain();
    if (start.edge == EdgeKind::Line && pen.isSquarePen) {
        return addLine(source, {start.point, end, pen.width, 0}, kSquarePen);
    }
    addSweptTrack(source, pen, start, end);
}

bool ElementMaker::continues(const ElementSource& source, Point start, Nm width) const {
    if (m_chain.nodes.empty() || m_chain.nodes.back().point != start || m_chain.width != width) {
        return false;
    }
    const DocumentBuilder::Origin& first = m_chain.source.origin;
    return (m_holes == nullptr || m_holes->joinsTracks()) && source.isNegative == m_chain.source.isNegative &&
           source.origin.symbol == first.symbol && source.origin.attributes == first.attributes &&
           source.origin.net == first.net;
}

void ElementMaker::extend(const ElementSource& source, const PathNode& start, const PathNode& end, Nm width,
                          bool isJoined) {
    if (start.point == end.point) {  // a dot or a full circle
        endChain();
        return addSingleTrack(source, std::array{start, end}, width);
    }
    if (!isJoined) {
        endChain();
        m_chain.source = source;
        m_chain.width = width;
        m_chain.nodes.push_back(start);
    } else {
        m_chain.nodes.back() = start;
    }
    m_chain.nodes.push_back(end);
}

void ElementMaker::endChain() {
    if (m_chain.nodes.empty()) {
        return;
    }
    if (m_chain.nodes.size() == 2) {
        addSingleTrack(m_chain.source, m_chain.nodes, m_chain.width);
    } else {
        DocumentBuilder::Origin origin = originOf(m_chain.source, 0);
        const Hole hole = drill(m_chain.source, m_chain.width, origin);
        m_builder.addTrail(m_chain.nodes, hole.drilled, origin, hole.finished);
        note(m_chain.source);
    }
    m_chain.nodes.clear();
}

void ElementMaker::addSingleTrack(const ElementSource& source, std::span<const PathNode> nodes, Nm width) {
    if (nodes[0].edge == EdgeKind::Line) {
        return addLine(source, {nodes[0].point, nodes[1].point, width, 0}, 0);
    }
    DocumentBuilder::Origin origin = originOf(source, 0);
    const Hole hole = drill(source, width, origin);
    m_builder.addArc({nodes[0], nodes[1].point, hole.drilled, hole.finished}, origin);
    note(source);
}

void ElementMaker::addLine(const ElementSource& source, LineGeometry line, int flags) {
    DocumentBuilder::Origin origin = originOf(source, flags);
    const Hole hole = drill(source, line.width, origin);
    m_builder.addLine({line.a, line.b, hole.drilled, hole.finished}, origin);
    note(source);
}

void ElementMaker::addSweptTrack(const ElementSource& source, const PadShape& pen, const PathNode& start, Point end) {
    if (start.edge == EdgeKind::Line && start.point == end && pen.kind == PadShape::Kind::Region) {
        return addArea(source, regionOf(pen), {end, 0.0, false}, 0);
    }
    const ShapeSketch outline = outlineOf(pen);
    const auto [finest, isNew] = m_pens.try_emplace(&pen);
    if (isNew) {
        finest->second = polygonsOf(outline, kFinestSweep);
    }
    const SweptTrack swept = sweep(outline, finest->second, start, end);
    if (swept.chordNm == 0.0) {
        return report(Severity::Warning, source, "a track whose pen has too many sides; it draws nothing");
    }
    if (swept.chordNm > kFinestSweep.chordToleranceNm) {
        report(Severity::Info, source, "a track whose pen has many sides; drawn with chords up to 50 µm off");
    }
    const ShapeSketch sketch = sketchOf(swept.cover);
    if (sketch.isEmpty()) {
        return report(Severity::Warning, source, "a track with a pen too small to draw anything");
    }
    addSketch(source, sketch, {});
}

// ---- pads and areas ----

void ElementMaker::addPad(const ElementSource& source, const PadShape& shape, const Placement& placement) {
    endChain();
    switch (shape.kind) {
        case PadShape::Kind::Nothing: return;
        case PadShape::Kind::Round:
        case PadShape::Kind::Ring: return addDisc(source, shape, placement.origin);
        case PadShape::Kind::Oval: return addOval(source, shape, placement);
        case PadShape::Kind::Region: return addArea(source, regionOf(shape), placement, kPad);
    }
}

ShapeId ElementMaker::regionOf(const PadShape& shape) {
    const auto [location, isNew] = m_regions.try_emplace(&shape);
    if (isNew) {
        location->second = m_builder.addShape(shape.region);
    }
    return location->second;
}

void ElementMaker::addDisc(const ElementSource& source, const PadShape& shape, Point centre) {
    DocumentBuilder::Origin origin = originOf(source, kPad);
    Hole hole = drill(source, shape.width, origin);
    if (m_holes == nullptr && shape.kind == PadShape::Kind::Ring) {
        hole.finished = shape.height;
    }
    m_builder.addCircle({centre, hole.drilled, hole.finished}, origin);
    note(source);
}

void ElementMaker::addOval(const ElementSource& source, const PadShape& shape, const Placement& placement) {
    const double reach = (shape.width - shape.height) / 2.0;
    const PointD tip = reach >= 0 ? PointD{reach, 0} : PointD{0, reach};
    const Point a = rounded(placement.apply(PointD{-tip.x, -tip.y}));
    const Point b = rounded(placement.apply(tip));
    addLine(source, {a, b, std::min(shape.width, shape.height), 0}, kPad);
}

void ElementMaker::addArea(const ElementSource& source, ShapeId shape, const Placement& placement) {
    endChain();
    addArea(source, shape, placement, 0);
}

void ElementMaker::addPadArea(const ElementSource& source, ShapeId shape, const Placement& placement) {
    endChain();
    addArea(source, shape, placement, kPad);
}

void ElementMaker::addArea(const ElementSource& source, ShapeId shape, const Placement& placement, int flags) {
    DocumentBuilder::Origin origin = originOf(source, flags);
    const Box box = m_builder.shapes().shapes[shape.row()].box;
    // The barrel of an area has no thickness of its own.
    static_cast<void>(drill(source, static_cast<Nm>(std::min(box.width(), box.height())), origin));
    m_builder.addArea({shape, placement}, origin);
    note(source);
}

void ElementMaker::addSketch(const ElementSource& source, const ShapeSketch& sketch, const Placement& placement) {
    if (!sketch.isEmpty()) {
        addArea(source, m_builder.addShape(sketch), placement, 0);
    }
}

// ---- texts ----

void ElementMaker::addStrokes(const ElementSource& source, std::span<const TextStroke> strokes,
                              const Placement& placement) {
    endChain();
    if (std::ranges::any_of(strokes, &TextStroke::isNegative)) {
        return paintStrokes(source, strokes, placement);
    }
    for (const TextStroke& stroke : strokes) {
        if (stroke.isSquare) {
            endChain();
            addSquareStroke(source, stroke, placement);
            continue;
        }
        const PathNode start{rounded(placement.apply(stroke.a)), {}, EdgeKind::Line};
        const PathNode end{rounded(placement.apply(stroke.b)), {}, EdgeKind::Line};
        const bool isJoined =
            !m_chain.nodes.empty() && m_chain.nodes.back().point == start.point && m_chain.width == stroke.width;
        extend(source, start, end, stroke.width, isJoined);
    }
    endChain();
}

/// A text whose characters take something away again becomes one area, strokes painted in their order.
void ElementMaker::paintStrokes(const ElementSource& source, std::span<const TextStroke> strokes,
                                const Placement& placement) {
    PolygonSet painted;
    for (const TextStroke& stroke : strokes) {
        const PolygonSet swept = sweptBy(stroke);
        if (stroke.isNegative) {
            painted = subtract(painted, swept);
        } else {
            painted.append(swept);
        }
    }
    addSketch(source, sketchOf(unite(painted)), placement);
}

void ElementMaker::addSquareStroke(const ElementSource& source, const TextStroke& stroke, const Placement& placement) {
    if (std::fmod(placement.clockwiseDeg, 90.0) == 0.0) {
        const Point a = rounded(placement.apply(stroke.a));
        return addLine(source, {a, rounded(placement.apply(stroke.b)), stroke.width, 0}, kSquarePen);
    }
    addSketch(source, sketchOf(sweptBy(stroke)), placement);
}

}  // namespace model::formats
