#include "model/formats/ipc2581/shape_reader.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "model/base/limits.h"
#include "model/formats/common/text_layout.h"
#include "model/formats/ipc2581/shapes/hatches.h"
#include "model/formats/ipc2581/shapes/primitives.h"
#include "model/formats/ipc2581/xml/xml_values.h"
#include "model/geometry/outlines.h"

namespace model::ipc2581 {

namespace {

using formats::PadShape;

/// Of the height of the letters.
constexpr double kTextPen = 0.1;

/// The first child that is a shape, with the cursor at its start tag.
template <class Read>
void atShapeOf(XmlCursor& at, const Read& read) {
    bool isRead = false;
    forEachChild(at, [&] {
        if (!isRead) {
            isRead = read();
        }
    });
}

}  // namespace

bool ShapeReader::draw(XmlCursor& at, const Turn& turn, double unitNm) {
    const std::string_view name = at.name();
    if (name == "StandardPrimitiveRef") {
        return drawReference(at, turn);
    }
    if (name == "Line" || name == "Arc") {
        return drawLine(at, turn, unitNm);
    }
    if (name == "Contour" || name == "Polygon") {
        drawContour(at, turn, unitNm);
    } else if (name == "Polyline") {
        drawPolyline(at, turn, unitNm);
    } else if (name == "Outline") {
        drawOutline(at, turn, unitNm);
    } else if (name == "UserPrimitiveRef") {
        return drawUser(at, turn);
    } else if (name == "UserSpecial") {
        drawSpecial(at, turn, unitNm);
    } else if (name == "Text") {
        drawText(at, turn, unitNm);
    } else if (isPrimitive(name)) {
        drawPrimitive(at, turn, unitNm);
    } else {
        return false;
    }
    return true;
}

void ShapeReader::drawSpecial(XmlCursor& at, const Turn& turn, double unitNm) {
    if (m_depth >= base::kMostShapeDepth) {
        return m_reading.report(Severity::Error, at.line(),
                                "shapes contain each other or have " + base::moreThan(base::kMostShapeDepth, "levels") +
                                    "; the rest is left out");
    }
    ++m_depth;
    forEachChild(at, [&] {
        if (m_references > 0 && ++m_expansions > base::kMostReferred) {
            m_reading.report(
                Severity::Error, at.line(),
                "shapes refer to " + base::moreThan(base::kMostReferred, "other shapes") + "; the rest is left out");
        } else if (!draw(at, turn, unitNm)) {
            m_reading.reportUnknown(at);
        }
    });
    --m_depth;
}

bool ShapeReader::drawUser(const XmlCursor& at, const Turn& turn) {
    const DictionaryEntry* const entry = m_dictionaries.user(at.value("id"));
    if (entry == nullptr) {
        m_reading.report(Severity::Warning, at.line(),
                         "a shape refers to an entry that no dictionary has; it draws nothing");
        return true;
    }
    XmlCursor inside = m_reading.at(entry->section);
    inside.next();
    ++m_depth;
    ++m_references;
    forEachChild(inside, [&] {
        if (m_depth > base::kMostShapeDepth) {
            m_reading.report(Severity::Error, inside.line(),
                             "shapes contain each other or have " + base::moreThan(base::kMostShapeDepth, "levels") +
                                 "; the rest is left out");
        } else if (!draw(inside, turn, entry->unitNm)) {
            m_reading.reportUnknown(inside);
        }
    });
    --m_references;
    --m_depth;
    return true;
}

bool ShapeReader::drawReference(const XmlCursor& at, const Turn& turn) {
    if (!drawStandard(at.value("id"), turn)) {
        m_reading.report(Severity::Warning, at.line(),
                         "a shape refers to an entry that no dictionary has; it draws nothing");
    }
    return true;
}

bool ShapeReader::drawStandard(std::string_view id, const Turn& turn) {
    if (const auto found = m_filled.find(id); found != m_filled.end() && turn.scale == 1.0) {
        m_canvas.addPad(found->second.symbol, turn.after(found->second.own));
        return true;
    }
    const DictionaryEntry* const entry = m_dictionaries.standard(id);
    if (entry == nullptr) {
        return false;
    }
    XmlCursor inside = m_reading.at(entry->section);
    inside.next();
    atShapeOf(inside, [&] {
        if (inside.name() == "Contour") {
            return drawStandardContour(inside, id, turn, entry->unitNm);
        }
        if (!isPrimitive(inside.name())) {
            m_reading.reportUnknown(inside);
            return false;
        }
        const std::int32_t symbol = primitiveSymbol(inside, entry->unitNm * turn.scale);
        Turn own;
        LineStyle line;
        FillStyle fill;
        forEachChild(inside, [&] {
            if (!readTurn(m_reading, inside, entry->unitNm, own) &&
                !m_dictionaries.readStyle(inside, entry->unitNm, line, fill)) {
                m_reading.reportUnknown(inside);
            }
        });
        if (turn.scale == 1.0 && own.scale == 1.0 && fill.kind == FillKind::Fill && line.width == 0.0) {
            m_filled[id] = {symbol, own};
        }
        paint(symbol, turn.after(own), line, fill);
        return true;
    });
    return true;
}

/// Contours of dictionaries are symbols of their own.
bool ShapeReader::drawStandardContour(XmlCursor& at, std::string_view id, const Turn& turn, double unitNm) {
    const std::uint32_t line = m_canvas.ink().line;
    m_canvas.setLine(at.line());
    Polygon polygon;
    polygon.line = {};
    readPolygon(at, unitNm, polygon);
    std::string name = "Contour " + textOf(id) + (turn.scale == 1.0 ? "" : " x " + std::to_string(turn.scale));
    std::int32_t symbol = m_canvas.findSymbol(name);
    if (symbol < 0) {
        PadShape shape;
        shape.region = m_canvas.sketchOf(polygon.region, Turn{{}, 0.0, false, turn.scale}.after(polygon.own));
        shape.kind = shape.region.isEmpty() ? PadShape::Kind::Nothing : PadShape::Kind::Region;
        shape.problem = shape.region.isEmpty() ? "has no area; it draws nothing" : "";
        symbol = m_canvas.addSymbol(std::move(name), std::move(shape));
    }
    if (turn.scale == 1.0 && polygon.fill.kind == FillKind::Fill && polygon.line.width == 0.0) {
        m_filled[id] = {symbol, {}};
    }
    m_canvas.setLine(line);
    paint(symbol, turn, polygon.line, polygon.fill);
    return true;
}

std::int32_t ShapeReader::primitiveSymbol(const XmlCursor& at, double unitNm) {
    std::string name = primitiveName(at, unitNm);
    const std::int32_t known = m_canvas.findSymbol(name);
    return known >= 0 ? known : m_canvas.addSymbol(std::move(name), primitiveShape(at, unitNm));
}

void ShapeReader::drawPrimitive(XmlCursor& at, const Turn& turn, double unitNm) {
    const std::int32_t symbol = primitiveSymbol(at, unitNm * turn.scale);
    Turn own;
    LineStyle line;
    FillStyle fill;
    forEachChild(at, [&] {
        if (!readTurn(m_reading, at, unitNm, own) && !m_dictionaries.readStyle(at, unitNm, line, fill)) {
            m_reading.reportUnknown(at);
        }
    });
    paint(symbol, turn.after(own), line, fill);
}

void ShapeReader::paint(std::int32_t symbol, const Turn& turn, const LineStyle& line, const FillStyle& fill) {
    switch (fill.kind) {
        case FillKind::Fill: m_canvas.addPad(symbol, turn); break;
        case FillKind::Void: m_canvas.clear([&] { m_canvas.addPad(symbol, turn); }); break;
        case FillKind::Hatch: {
            ShapeSketch area;
            area.append(
                formats::outlineOf(m_canvas.symbol(symbol)),
                {m_reading.rounded(turn.origin, m_canvas.ink().line), normalDegrees(-turn.ccwDeg), turn.isMirrored});
            hatch(area, fill);
            break;
        }
        case FillKind::Hollow: break;
    }
    if (line.width > 0.0 || fill.kind == FillKind::Hollow) {
        m_canvas.strokeSymbol(symbol, turn, line.scaledBy(turn.scale));
    }
}

bool ShapeReader::drawLine(XmlCursor& at, const Turn& turn, double unitNm) {
    const bool isArcHere = at.name() == "Arc";
    const auto coordinates = [&](const char* x, const char* y) {
        return PointD{m_reading.length(at, x, unitNm), m_reading.length(at, y, unitNm)};
    };
    Path path = {{coordinates("startX", "startY"), {}, EdgeKind::Line},
                 {coordinates("endX", "endY"), {}, EdgeKind::Line}};
    if (isArcHere) {
        path[1].centre = coordinates("centerX", "centerY");
        path[1].edge = isTrue(at.value("clockwise")) ? EdgeKind::ArcClockwise : EdgeKind::ArcCounterClockwise;
    }
    LineStyle line = m_pen;
    FillStyle fill;
    line.width = m_reading.lengthOr(at, "lineWidth", unitNm, line.width);  // some write it there
    forEachChild(at, [&] {
        if (!m_dictionaries.readStyle(at, unitNm, line, fill)) {
            m_reading.reportUnknown(at);
        }
    });
    m_canvas.stroke(path, turn, line);
    return true;
}

void ShapeReader::readPath(XmlCursor& at, double unitNm, Polygon& polygon, Path& path) {
    path.clear();
    forEachChild(at, [&] {
        const std::string_view name = at.name();
        if (name == "PolyStepSegment" || name == "PolyBegin") {
            path.push_back({m_reading.point(at, unitNm), {}, EdgeKind::Line});
        } else if (name == "PolyStepCurve") {
            path.push_back({m_reading.point(at, unitNm),
                            {m_reading.length(at, "centerX", unitNm), m_reading.length(at, "centerY", unitNm)},
                            isTrue(at.value("clockwise")) ? EdgeKind::ArcClockwise : EdgeKind::ArcCounterClockwise});
        } else if (!readTurn(m_reading, at, unitNm, polygon.own) &&
                   !m_dictionaries.readStyle(at, unitNm, polygon.line, polygon.fill)) {
            m_reading.reportUnknown(at);
        }
    });
}

/// A Contour, Outline or Profile (polygon and cutouts), or a Polygon by itself.
void ShapeReader::readPolygon(XmlCursor& at, double unitNm, Polygon& polygon) {
    if (at.name() == "Polygon") {
        return readPath(at, unitNm, polygon, polygon.region.outline);
    }
    forEachChild(at, [&] {
        if (at.name() == "Polygon") {
            if (!polygon.region.outline.empty()) {
                m_reading.report(Severity::Warning, at.line(), "an area has several polygons; the last one is used");
            }
            readPath(at, unitNm, polygon, polygon.region.outline);
        } else if (at.name() == "Cutout") {
            readCutout(at, unitNm, polygon);
        } else if (!m_dictionaries.readStyle(at, unitNm, polygon.line, polygon.fill)) {
            m_reading.reportUnknown(at);
        }
    });
}

void ShapeReader::readCutout(XmlCursor& at, double unitNm, Polygon& polygon) {
    const std::uint32_t line = at.line();
    Polygon cutout;
    readPath(at, unitNm, cutout, polygon.region.cutouts.emplace_back());
    const bool isMoved = !cutout.own.isPlain() || cutout.own.origin != PointD{};
    if (isMoved || cutout.line.width > 0.0) {
        m_reading.report(Severity::Warning, line,
                         "the Xform and LineDesc of a cutout are not read; it is cut out plainly");
    }
}

void ShapeReader::drawPolyline(XmlCursor& at, const Turn& turn, double unitNm) {
    Polygon polyline;
    polyline.line = m_pen;
    readPath(at, unitNm, polyline, polyline.region.outline);
    m_canvas.stroke(polyline.region.outline, turn.after(polyline.own), polyline.line);
}

void ShapeReader::drawOutline(XmlCursor& at, const Turn& turn, double unitNm) {
    Polygon polygon;
    readPolygon(at, unitNm, polygon);
    // A line without width says nothing: KiCad writes letters of outline fonts so.
    if (m_outlines == OutlineMeaning::Area || polygon.line.width == 0.0) {
        return m_canvas.fill(polygon.region, turn.after(polygon.own));
    }
    polygon.fill.kind = FillKind::Hollow;
    paint(polygon, turn);
}

void ShapeReader::drawContour(XmlCursor& at, const Turn& turn, double unitNm) {
    Polygon polygon;
    readPolygon(at, unitNm, polygon);
    paint(polygon, turn);
}

void ShapeReader::paint(const Polygon& polygon, const Turn& turn) {
    const Turn laid = turn.after(polygon.own);
    switch (polygon.fill.kind) {
        case FillKind::Fill: m_canvas.fill(polygon.region, laid); break;
        case FillKind::Void: m_canvas.clear([&] { m_canvas.fill(polygon.region, laid); }); break;
        case FillKind::Hatch: hatch(m_canvas.sketchOf(polygon.region, laid), polygon.fill); break;
        case FillKind::Hollow: break;
    }
    if (polygon.line.width > 0.0 || polygon.fill.kind == FillKind::Hollow) {
        const auto strokeClosed = [&](const Path& path) {
            Path closed = path;
            if (!path.empty() && path.front().point != path.back().point) {
                closed.push_back({path.front().point, {}, EdgeKind::Line});
            }
            m_canvas.stroke(closed, laid, polygon.line);
        };
        strokeClosed(polygon.region.outline);
        std::ranges::for_each(polygon.region.cutouts, strokeClosed);
    }
}

void ShapeReader::hatch(const ShapeSketch& area, const FillStyle& fill) {
    HatchStyle style;
    style.lines = {{{fill.angle1, fill.pitch1}, {fill.angle2, fill.pitch2}}};
    style.width = fill.lineWidth;
    const Hatch hatched = hatchOf(area, style);
    if (!hatched.problem.empty()) {
        m_reading.report(Severity::Warning, m_canvas.ink().line, hatched.problem);
    }
    if (!hatched.shape.isEmpty()) {
        m_canvas.addRegion(hatched.shape);
    }
}

void ShapeReader::drawText(XmlCursor& at, const Turn& turn, double unitNm) {
    const std::string text = textOf(at.value("textString"));
    Turn own;
    Box box;
    const std::uint32_t line = at.line();
    forEachChild(at, [&] {
        if (at.name() == "BoundingBox") {
            box.include(m_reading.rounded(
                {m_reading.length(at, "lowerLeftX", unitNm), m_reading.length(at, "lowerLeftY", unitNm)}, line));
            box.include(m_reading.rounded(
                {m_reading.length(at, "upperRightX", unitNm), m_reading.length(at, "upperRightY", unitNm)}, line));
        } else if (!readTurn(m_reading, at, unitNm, own) && at.name() != "FontRef" && !at.name().starts_with("Color")) {
            m_reading.reportUnknown(at);
        }
    });
    const std::size_t count = formats::codePoints(text).size();
    if (count == 0 || box.height() <= 0 || box.width() <= 0) {
        return m_reading.report(Severity::Warning, line, "a text without characters or bounding box draws nothing");
    }
    m_reading.report(Severity::Info, line, "texts are drawn within their boxes with a plain font");
    const auto advance = static_cast<Nm>(box.width() / static_cast<std::int64_t>(count));
    const formats::TextLayout layout =
        formats::layOut({text, advance, static_cast<Nm>(box.height()), 1.0}, formats::standInFont());
    const Turn laid = turn.after(own);
    for (const formats::TextStroke& stroke : layout.strokes) {
        const Path path = {{{box.min.x + stroke.a.x, box.min.y + stroke.a.y}, {}, EdgeKind::Line},
                           {{box.min.x + stroke.b.x, box.min.y + stroke.b.y}, {}, EdgeKind::Line}};
        m_canvas.stroke(path, laid, {static_cast<double>(box.height()) * kTextPen, LineEnd::Round});
    }
}

ShapeSketch ShapeReader::sketch(XmlCursor& at, const Turn& turn, double unitNm) {
    const std::string_view name = at.name();
    if (name == "Polygon" || name == "Contour" || name == "Outline" || name == "Profile") {
        Polygon polygon;
        readPolygon(at, unitNm, polygon);
        return m_canvas.sketchOf(polygon.region, turn.after(polygon.own));
    }
    XmlCursor inside = at;
    double unit = unitNm;
    if (name == "StandardPrimitiveRef") {
        const DictionaryEntry* const entry = m_dictionaries.standard(at.value("id"));
        if (entry == nullptr) {
            return {};
        }
        inside = m_reading.at(entry->section);
        inside.next();
        inside.next();
        unit = entry->unitNm;
        if (inside.name() == "Contour") {
            return sketch(inside, turn, unit);
        }
    }
    ShapeSketch placed;
    if (isPrimitive(inside.name())) {
        const PadShape shape = primitiveShape(inside, unit * turn.scale);
        Turn own;
        forEachChild(inside, [&] { readTurn(m_reading, inside, unit, own); });
        const Turn laid = turn.after(own);
        placed.append(formats::outlineOf(shape),
                      {m_reading.rounded(laid.origin, at.line()), normalDegrees(-laid.ccwDeg), laid.isMirrored});
    }
    return placed;
}

}  // namespace model::ipc2581
