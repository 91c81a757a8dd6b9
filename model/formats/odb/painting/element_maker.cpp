#include "model/formats/odb/painting/element_maker.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "model/formats/common/outlines.h"
#include "model/formats/common/region.h"
#include "model/formats/odb/painting/swept_tracks.h"
#include "model/formats/odb/symbols/barcode.h"
#include "model/geometry/boolean.h"

namespace model::odb {

namespace {

double normalisedDeg(double degrees) {
    const double turn = std::fmod(degrees, 360.0);
    return turn < 0 ? turn + 360.0 : turn;
}

bool isQuarterTurn(const Placement& placement) {
    return std::fmod(placement.clockwiseDeg, 90.0) == 0.0;
}

}  // namespace

void ElementMaker::add(const FeatureSource& source, const HoleRules* holes) {
    m_source = source;
    m_holes = holes;
    m_resolved.assign(source.file->symbols.size(), {});
    m_attributes.assign(source.file->attributes.sets.size(), {});
    m_ownSurfaces = &m_surfaces[source.file];
    m_ownSurfaces->resize(source.file->surfaces.size());
    for (std::size_t i = 0; i < source.file->features.size(); ++i) {
        switch (source.file->features[i].kind) {
            case FeatureKind::Line:
            case FeatureKind::Arc: track(i); break;
            case FeatureKind::Pad:
                flush();
                pad(i);
                break;
            case FeatureKind::Surface:
                flush();
                surface(i);
                break;
            case FeatureKind::Text:
                flush();
                text(i);
                break;
            case FeatureKind::Barcode:
                flush();
                barcode(i);
                break;
            case FeatureKind::Bad: flush(); break;  // reported by the parser
        }
    }
    flush();
}

void ElementMaker::report(Severity severity, std::size_t feature, std::string_view text) {
    m_diagnostics.report(severity, m_source.path, m_source.file->features[feature].line, text);
}

ElementMaker::Resolved& ElementMaker::resolve(std::size_t feature) {
    const Feature& f = m_source.file->features[feature];
    const SymbolRef& symbol = m_source.file->symbols[f.index];
    Resolved& resolved = m_resolved[f.index];
    if (resolved.shape == nullptr) {
        resolved.shape = &m_symbols.shape(symbol);
        resolved.id = m_builder.symbol(symbol.name);
    }
    if (!resolved.shape->problem.empty()) {
        m_symbols.reportProblem(symbol, *resolved.shape, m_source.path, f.line);
    }
    return resolved;
}

NetLink ElementMaker::linkOf(std::size_t feature) const {
    return feature < m_source.links.size() ? m_source.links[feature] : NetLink{};
}

DocumentBuilder::Origin ElementMaker::originOf(std::size_t feature) {
    const Feature& f = m_source.file->features[feature];
    DocumentBuilder::Origin origin;
    const NetLink link = linkOf(feature);
    origin.net = link.net;
    origin.subnet = link.subnet;
    const bool hasSymbol = f.kind == FeatureKind::Line || f.kind == FeatureKind::Arc || f.kind == FeatureKind::Pad;
    origin.symbol = hasSymbol ? m_resolved[f.index].id : SymbolId{};
    origin.attributes = attributesOf(f);
    origin.feature = static_cast<std::uint32_t>(feature);
    origin.line = f.line;
    origin.flags = m_holes != nullptr ? kHole : 0;
    return origin;
}

/// Sets are put into words once each.
AttributeSetId ElementMaker::attributesOf(const Feature& feature) {
    if (m_source.attributeTypes == nullptr || feature.attributes == FeatureAttributes::kNone) {
        return {};
    }
    AttributeSetId& set = m_attributes[feature.attributes];
    if (!set.isValid()) {
        set = m_builder.attributes(m_source.file->attributes.values(feature.attributes, *m_source.attributeTypes));
    }
    return set;
}

/// The hole a feature makes, with its flags put into `origin`.
Hole ElementMaker::drill(std::size_t feature, Nm size, DocumentBuilder::Origin& origin) {
    const Feature& f = m_source.file->features[feature];
    const Hole hole = m_holes->hole(f, size, origin.net.isValid());
    origin.flags = static_cast<std::uint8_t>(origin.flags | hole.flags);
    const bool isPlated = (hole.flags & kPlated) != 0;
    if (hole.isPlatingAssumed) {
        report(Severity::Info, feature,
               isPlated ? "neither attribute .drill nor the tools say whether the hole is plated; taken as plated"
                        : "neither attribute .drill nor the tools say whether the hole is plated; taken as bare");
    }
    if (hole.isWallAssumed) {
        report(Severity::Info, feature,
               "the tools do not say how thick the copper in plated holes is; taken as 25 µm inside of the hole");
    }
    if (hole.isContradicted) {
        report(Severity::Warning, feature,
               "attribute .drill and the tool of this size disagree about plating; the attribute is believed");
    }
    return hole;
}

// ---- strokes ----

void ElementMaker::track(std::size_t feature) {
    Resolved& pen = resolve(feature);
    const bool isStraight = m_source.file->features[feature].kind == FeatureKind::Line;
    if (pen.shape->kind == SymbolShape::Kind::Round) {
        return roundTrack(feature, pen.shape->width);
    }
    flush();
    if (pen.shape->kind == SymbolShape::Kind::Nothing) {
        return;
    }
    if (isStraight && pen.shape->isSquarePen) {
        return squareTrack(feature, pen);
    }
    sweptTrack(feature, pen);
}

PathNode ElementMaker::startOf(std::size_t feature) {
    const Feature& f = m_source.file->features[feature];
    PathNode start{f.a, f.centre, EdgeKind::Line};
    if (f.kind == FeatureKind::Arc && (f.a == f.centre || f.b == f.centre)) {
        report(Severity::Warning, feature, "an arc without a radius; taken as a straight line");
    } else if (f.kind == FeatureKind::Arc) {
        start.edge = f.isClockwise ? EdgeKind::ArcClockwise : EdgeKind::ArcCounterClockwise;
    }
    return start;
}

bool ElementMaker::continues(std::size_t feature, const PathNode& start) const {
    if (m_pending.nodes.empty() || m_pending.nodes.back().point != start.point) {
        return false;
    }
    const Feature& f = m_source.file->features[feature];
    const Feature& first = m_source.file->features[m_pending.feature];
    const bool mayJoin = m_holes == nullptr || m_holes->joinsStrokes();
    return mayJoin && f.index == first.index && f.isNegative == first.isNegative && f.attributes == first.attributes &&
           linkOf(feature).net == linkOf(m_pending.feature).net;
}

void ElementMaker::roundTrack(std::size_t feature, Nm width) {
    const PathNode start = startOf(feature);
    const PathNode end{m_source.file->features[feature].b, {}, EdgeKind::Line};
    extend(feature, start, end, width, continues(feature, start));
}

void ElementMaker::extend(std::size_t feature, const PathNode& start, const PathNode& end, Nm width, bool isJoined) {
    if (start.point == end.point) {  // a dot or a full circle
        flush();
        return addSingleTrack(feature, std::array{start, end}, width);
    }
    if (!isJoined) {
        flush();
        m_pending.feature = feature;
        m_pending.width = width;
        m_pending.nodes.push_back(start);
    } else {
        m_pending.nodes.back() = start;
    }
    m_pending.nodes.push_back(end);
}

void ElementMaker::flush() {
    if (m_pending.nodes.empty()) {
        return;
    }
    const Nm width = m_pending.width;
    if (m_pending.nodes.size() == 2) {
        addSingleTrack(m_pending.feature, m_pending.nodes, width);
    } else {
        DocumentBuilder::Origin origin = originOf(m_pending.feature);
        const Hole hole = m_holes != nullptr ? drill(m_pending.feature, width, origin) : Hole{0, width};
        m_builder.addTrail(m_pending.nodes, hole.drilled, origin, hole.open);
        note(m_pending.feature);
    }
    m_pending.nodes.clear();
}

void ElementMaker::addSingleTrack(std::size_t feature, std::span<const PathNode> nodes, Nm width) {
    if (nodes[0].edge == EdgeKind::Line) {
        return addLine(feature, {nodes[0].point, nodes[1].point, width, 0}, 0);
    }
    DocumentBuilder::Origin origin = originOf(feature);
    const Hole hole = m_holes != nullptr ? drill(feature, width, origin) : Hole{0, width};
    m_builder.addArc({nodes[0], nodes[1].point, hole.drilled, hole.open}, origin);
    note(feature);
}

void ElementMaker::addLine(std::size_t feature, LineGeometry line, std::uint8_t flags) {
    DocumentBuilder::Origin origin = originOf(feature);
    origin.flags |= flags;
    if (m_holes != nullptr) {
        const Hole hole = drill(feature, line.width, origin);
        line.width = hole.drilled;
        line.innerWidth = hole.open;
    }
    m_builder.addLine(line, origin);
    note(feature);
}

void ElementMaker::squareTrack(std::size_t feature, const Resolved& pen) {
    const Feature& f = m_source.file->features[feature];
    addLine(feature, {f.a, f.b, pen.shape->width, 0}, kSquarePen);
}

void ElementMaker::sweptTrack(std::size_t feature, Resolved& pen) {
    const Feature& f = m_source.file->features[feature];
    const PathNode start = startOf(feature);
    if (start.edge == EdgeKind::Line && f.a == f.b && pen.shape->kind == SymbolShape::Kind::Region) {
        return addArea(feature, regionOf(*pen.shape), {f.a, 0.0, false}, 0);
    }
    if (pen.pen.polygons.empty()) {
        pen.pen = penOf(*pen.shape);
    }
    const SweptTrack swept = sweep(*pen.shape, pen.pen, start, f.b);
    if (swept.chordNm == 0.0) {
        return report(Severity::Warning, feature, "a stroke whose pen has too many sides; it draws nothing");
    }
    if (swept.chordNm > kFinestSweep.chordToleranceNm) {
        report(Severity::Info, feature, "a stroke whose pen has many sides; drawn with chords up to 50 µm off");
    }
    const ShapeSketch sketch = sketchOf(swept.cover);
    if (sketch.isEmpty()) {
        return report(Severity::Warning, feature, "a stroke with a pen too small to draw anything");
    }
    addArea(feature, m_builder.addShape(sketch), {}, 0);
}

// ---- pads and surfaces ----

void ElementMaker::pad(std::size_t feature) {
    Resolved& symbol = resolve(feature);
    const Placement placement = placementOf(feature);
    switch (symbol.shape->kind) {
        case SymbolShape::Kind::Nothing: return;
        case SymbolShape::Kind::Round:
        case SymbolShape::Kind::Ring: return discPad(feature, *symbol.shape);
        case SymbolShape::Kind::Oval: return ovalPad(feature, *symbol.shape, placement);
        case SymbolShape::Kind::Region: break;
    }
    addArea(feature, regionOf(*symbol.shape), placement, kPad);
}

Placement ElementMaker::placementOf(std::size_t feature) const {
    const Feature& f = m_source.file->features[feature];
    Placement placement{f.a, f.clockwiseDeg, f.isMirrored};
    placement.clockwiseDeg = normalisedDeg(placement.clockwiseDeg);
    return placement;
}

ShapeId ElementMaker::regionOf(const SymbolShape& shape) {
    const auto [location, isNew] = m_regions.try_emplace(&shape);
    if (isNew) {
        location->second = m_builder.addShape(shape.region);
    }
    return location->second;
}

void ElementMaker::discPad(std::size_t feature, const SymbolShape& shape) {
    const Feature& f = m_source.file->features[feature];
    DocumentBuilder::Origin origin = originOf(feature);
    origin.flags |= kPad;
    CircleGeometry circle{f.a, shape.width, shape.kind == SymbolShape::Kind::Ring ? shape.height : 0};
    if (m_holes != nullptr) {
        const Hole hole = drill(feature, shape.width, origin);
        circle.diameter = hole.drilled;
        circle.innerDiameter = hole.open;
    }
    m_builder.addCircle(circle, origin);
    note(feature);
}

void ElementMaker::ovalPad(std::size_t feature, const SymbolShape& shape, const Placement& placement) {
    const double reach = (shape.width - shape.height) / 2.0;
    const PointD tip = reach >= 0 ? PointD{reach, 0} : PointD{0, reach};
    const Point a = rounded(placement.apply(PointD{-tip.x, -tip.y}));
    const Point b = rounded(placement.apply(tip));
    addLine(feature, {a, b, std::min(shape.width, shape.height), 0}, kPad);
}

void ElementMaker::surface(std::size_t feature) {
    const Feature& f = m_source.file->features[feature];
    ShapeId& shape = (*m_ownSurfaces)[f.index];
    if (m_source.file->surfaces.shapes[f.index].contourCount == 0) {
        return report(Severity::Warning, feature, "a surface without a usable polygon draws nothing");
    }
    if (!shape.isValid()) {
        shape = m_builder.addShape(sketchOf(m_source.file->surfaces, f.index, {}));
    }
    addArea(feature, shape, {}, 0);
}

// ---- texts and barcodes ----

void ElementMaker::text(std::size_t feature) {
    const Feature& f = m_source.file->features[feature];
    const TextRecord& record = m_source.file->texts[f.index];
    const TextLayout layout = layOut(record, m_symbols.fonts().font(record.font, m_source.path, f.line));
    if (!layout.problem.empty()) {
        report(Severity::Warning, feature, layout.problem);
    }
    addStrokes(feature, layout.strokes);
}

void ElementMaker::barcode(std::size_t feature) {
    const Feature& f = m_source.file->features[feature];
    const BarcodeRecord& record = m_source.file->barcodes[f.index];
    if (record.elementWidth <= 0 || record.height <= 0) {
        return report(Severity::Warning, feature, "a barcode without a size draws nothing");
    }
    const Font& font = record.hasString ? m_symbols.fonts().font(record.font, m_source.path, f.line) : standInFont();
    const BarcodeLayout layout = layOut(record, font);
    if (!layout.problem.empty()) {
        report(Severity::Warning, feature, layout.problem);
    }
    if (record.hasString) {
        report(Severity::Info, feature, "a barcode does not say how large its text is; taken as 1.5 mm");
    }
    if (!layout.bars.isEmpty()) {
        addArea(feature, m_builder.addShape(layout.bars), placementOf(feature), 0);
    }
    addStrokes(feature, layout.string);
}

void ElementMaker::addStrokes(std::size_t feature, std::span<const TextStroke> tracks) {
    const Placement placement = placementOf(feature);
    if (std::ranges::any_of(tracks, &TextStroke::isNegative)) {
        return paintStrokes(feature, tracks, placement);
    }
    for (const TextStroke& track : tracks) {
        if (track.isSquare) {
            flush();
            squareTextStroke(feature, track, placement);
            continue;
        }
        const PathNode start{rounded(placement.apply(track.a)), {}, EdgeKind::Line};
        const PathNode end{rounded(placement.apply(track.b)), {}, EdgeKind::Line};
        const bool isJoined =
            !m_pending.nodes.empty() && m_pending.nodes.back().point == start.point && m_pending.width == track.width;
        extend(feature, start, end, track.width, isJoined);
    }
    flush();
}

/// A text whose characters take something away again becomes one area, strokes painted in their order.
void ElementMaker::paintStrokes(std::size_t feature, std::span<const TextStroke> tracks, const Placement& placement) {
    PolygonSet painted;
    for (const TextStroke& track : tracks) {
        const PolygonSet swept = sweptBy(track);
        if (track.isNegative) {
            painted = subtract(painted, swept);
        } else {
            painted.append(swept);
        }
    }
    const ShapeSketch sketch = sketchOf(unite(painted));
    if (!sketch.isEmpty()) {
        addArea(feature, m_builder.addShape(sketch), placement, 0);
    }
}

/// In the text's own system.
PolygonSet ElementMaker::sweptBy(const TextStroke& track) {
    ShapeSketch pen;
    if (track.isSquare) {
        addBox(pen, track.width, track.width, false);
    } else {
        addDisc(pen, track.width, false);
    }
    return track.width > 0 ? sweep(polygonsOf(pen), {rounded(track.a), {}, EdgeKind::Line}, rounded(track.b))
                           : PolygonSet{};
}

void ElementMaker::squareTextStroke(std::size_t feature, const TextStroke& track, const Placement& placement) {
    if (isQuarterTurn(placement)) {
        const LineGeometry line{rounded(placement.apply(track.a)), rounded(placement.apply(track.b)), track.width, 0};
        return addLine(feature, line, kSquarePen);
    }
    const ShapeSketch swept = sketchOf(sweptBy(track));
    if (!swept.isEmpty()) {
        addArea(feature, m_builder.addShape(swept), placement, 0);
    }
}

void ElementMaker::addArea(std::size_t feature, ShapeId shape, const Placement& placement, std::uint8_t flags) {
    DocumentBuilder::Origin origin = originOf(feature);
    origin.flags |= flags;
    if (m_holes != nullptr) {
        const Box box = m_builder.shapes().shapes[shape.row()].box;
        const auto size = static_cast<Nm>(std::min(box.width(), box.height()));
        (void)drill(feature, size, origin);  // the wall of an area has no thickness of its own
    }
    m_builder.addArea({shape, placement}, origin);
    note(feature);
}

}  // namespace model::odb
