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

void PackageOutlines::report(std::uint32_t number, std::string_view text) {
    m_diagnostics.report(Severity::Warning, m_path, number, text);
}

bool PackageOutlines::record(std::string_view line, std::uint32_t number, std::int64_t nmPerUnit, ShapeSketch* into) {
    const std::string_view kind = line.substr(0, line.find_first_of(" \t;"));
    const bool isSimple = kind == "RC" || kind == "CR" || kind == "SQ";
    if (!isSimple && !isPolygonRecord(kind)) {
        return false;
    }
    if (into == nullptr) {
        report(number, "an outline that belongs to no package was left out");
    } else if (isSimple) {
        simple(kind, Fields(line.substr(kind.size())), number, nmPerUnit, *into);
    } else {
        polygon(kind, line, number, nmPerUnit, *into);
    }
    return true;
}

/// Islands and their holes lie between CT and CE; a polygon outside of them is an island of its own.
void PackageOutlines::polygon(std::string_view kind, std::string_view line, std::uint32_t number,
                              std::int64_t nmPerUnit, ShapeSketch& into) {
    if (kind == "CT" || (kind == "OB" && !m_isInContour)) {
        m_contour = {};
        m_parser.beginSurface(number);
        m_isInContour = kind == "CT";
    }
    if (kind[0] == 'O') {
        m_parser.record(line, number, nmPerUnit);
    }
    if (kind == "CE" ? m_isInContour : kind == "OE" && !m_isInContour) {
        endContour(number, into);
        m_isInContour = false;
    }
}

void PackageOutlines::simple(std::string_view kind, Fields fields, std::uint32_t number, std::int64_t nmPerUnit,
                             ShapeSketch& into) {
    const Point at = fields.point(nmPerUnit);
    const std::int64_t width = fields.length(nmPerUnit);
    const std::int64_t height = kind == "RC" ? fields.length(nmPerUnit) : width;
    const std::int64_t x = at.x;
    const std::int64_t y = at.y;
    const bool isCorner = kind == "RC";
    const bool fits = isInRange(x + width) && isInRange(y + height) && isInRange(x - width) && isInRange(y - height);
    if (fields.failed() || !fits || width <= 0 || height <= 0) {
        return report(number, "an outline that cannot be read or has no size was left out");
    }
    if (kind == "CR") {
        into.addCircle(at, static_cast<Nm>(width), false);
    } else {
        addBox(into, isCorner ? x : x - width, isCorner ? y : y - width, x + width, y + height);
    }
}

void PackageOutlines::endContour(std::uint32_t number, ShapeSketch& into) {
    const std::uint32_t row = m_parser.endSurface(number);
    for (const Contour& contour : m_contour.contoursOf(ShapeId{row})) {
        into.beginContour(contour.isHole && !into.isEmpty());
        for (const PathNode& node : m_contour.nodesOf(contour)) {
            into.addNode(node);
        }
    }
}

}  // namespace model::odb
