#include "model/formats/odb/components/package_outlines.h"

#include <array>

namespace model::odb {

namespace {

void addBox(ShapeSketch& into, std::int64_t x0, std::int64_t y0, std::int64_t x1, std::int64_t y1) {
    const auto nm = [](std::int64_t value) { return static_cast<Nm>(value); };
    into.addPolygon(std::array<Point, 4>{{{nm(x0), nm(y0)}, {nm(x1), nm(y0)}, {nm(x1), nm(y1)}, {nm(x0), nm(y1)}}},
                    false);
}

bool isInRange(std::int64_t value) {
    return value >= -base::kMaxCoordinate && value <= base::kMaxCoordinate;
}

bool isPolygonRecord(std::string_view kind) {
    return kind == "CT" || kind == "OB" || kind == "OS" || kind == "OC" || kind == "OE" || kind == "CE";
}

}  // namespace

bool PackageOutlines::record(std::string_view line, ShapeSketch* into) {
    const std::string_view kind = line.substr(0, line.find_first_of(" \t;"));
    const bool isSimple = kind == "RC" || kind == "CR" || kind == "SQ";
    if (!isSimple && !isPolygonRecord(kind)) {
        return false;
    }
    if (into == nullptr) {
        m_at.report(Severity::Warning, "an outline that belongs to no package was left out");
    } else if (isSimple) {
        simple(kind, Fields(line.substr(kind.size())), *into);
    } else {
        polygon(kind, line, *into);
    }
    return true;
}

/// Islands and their holes lie between CT and CE; a polygon outside of them is an island of its own.
void PackageOutlines::polygon(std::string_view kind, std::string_view line, ShapeSketch& into) {
    if (kind == "CT" || (kind == "OB" && !m_isInContour)) {
        m_contour = {};
        m_parser.beginSurface();
        m_isInContour = kind == "CT";
    }
    if (kind[0] == 'O') {
        m_parser.record(line);
    }
    if (kind == "CE" ? m_isInContour : kind == "OE" && !m_isInContour) {
        endContour(into);
        m_isInContour = false;
    }
}

void PackageOutlines::simple(std::string_view kind, Fields fields, ShapeSketch& into) {
    const Point at = fields.point(m_at.nm);
    const std::int64_t width = fields.length(m_at.nm);
    const std::int64_t height = kind == "RC" ? fields.length(m_at.nm) : width;
    const std::int64_t x = at.x;
    const std::int64_t y = at.y;
    const bool isCorner = kind == "RC";
    const bool fits = isInRange(x + width) && isInRange(y + height) && isInRange(x - width) && isInRange(y - height);
    if (fields.failed() || !fits || width <= 0 || height <= 0) {
        return m_at.report(Severity::Warning, "an outline that cannot be read or has no size was left out");
    }
    if (kind == "CR") {
        into.addCircle(at, static_cast<Nm>(width), false);
    } else {
        addBox(into, isCorner ? x : x - width, isCorner ? y : y - width, x + width, y + height);
    }
}

void PackageOutlines::endContour(ShapeSketch& into) {
    const std::uint32_t row = m_parser.endSurface();
    for (const Contour& contour : m_contour.contoursOf(ShapeId{row})) {
        into.beginContour(contour.isHole && !into.isEmpty());
        into.addNodes(m_contour.nodesOf(contour));
    }
}

}  // namespace model::odb
