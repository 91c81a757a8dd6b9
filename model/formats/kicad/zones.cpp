#include "model/formats/kicad/zones.h"

#include <cstdint>
#include <vector>

#include "model/formats/kicad/graphics.h"
#include "model/formats/kicad/shapes/regions.h"
#include "model/formats/kicad/text/values.h"
#include "model/geometry/outlines.h"

namespace model::kicad {

namespace {

/// How much a stored fill lacks all around.
double inflationOf(Canvas& canvas, const Item& zone) {
    const Item thickness = zone.find("filled_areas_thickness");
    const bool isStroked = thickness.isThere() ? thickness.word(1) != "no" : canvas.settings().hasStrokedFills();
    return isStroked ? length(zone, "min_thickness") / 2.0 : 0.0;
}

std::vector<std::int32_t> rowsOf(Canvas& canvas, const Item& fill, const Item& zone) {
    return canvas.rowsOf(fill.find("layer").isThere() ? fill : zone);
}

void drawFill(Canvas& canvas, const Item& fill, const Item& zone, Origin origin, double inflation) {
    origin.line = fill.line();
    const std::vector<PathNode> nodes = pathOf(canvas, fill.find("pts"), {});
    if (nodes.size() < 3) {
        canvas.report(Severity::Info, fill.line(), "a filled polygon has fewer than three points; it was left out");
        return;
    }
    ShapeSketch region;
    addPath(region, nodes, false);
    if (inflation > 0.0) {
        region = grown(region, inflation);
    }
    for (const std::int32_t row : rowsOf(canvas, fill, zone)) {
        canvas.drawRegion(row, origin, region);
    }
}

/// KiCad 4 and 5 could fill with tracks.
void drawSegments(Canvas& canvas, const Item& segments, const Item& zone, Origin origin) {
    origin.line = segments.line();
    const double width = length(zone, "min_thickness");
    for (const Item segment : segments) {
        const std::vector<PathNode> nodes =
            segment.head() == "pts" ? pathOf(canvas, segment, {}) : std::vector<PathNode>();
        for (std::size_t i = 0; i + 1 < nodes.size(); ++i) {
            for (const std::int32_t row : rowsOf(canvas, segments, zone)) {
                canvas.drawEdge(row, origin, nodes[i], nodes[i + 1].point, width);
            }
        }
    }
}

void reportUnfilled(Canvas& canvas, std::uint32_t line) {
    canvas.report(Severity::Warning, line, "a zone is not filled in the file; its copper is missing");
}

}  // namespace

void drawZone(Canvas& canvas, const Item& zone) {
    if (zone.find("keepout").isThere()) {
        canvas.report(Severity::Info, zone.line(), "a rule area (keepout) draws nothing");
        return;
    }
    Origin origin;
    origin.line = zone.line();
    origin.net = canvas.netOf(zone);
    if (origin.net == formats::kNoRow) {
        origin.net = canvas.netNamed(zone.find("net_name").text(1));
    }
    origin.subnet = SubnetKind::Plane;
    const std::string name = zone.find("name").text(1);
    if (!name.empty()) {
        origin.attributes = canvas.attributes({{"zone", name}});
    }
    const double inflation = inflationOf(canvas, zone);
    bool isFilled = false;
    for (const Item item : zone) {
        if (item.head() == "filled_polygon") {
            drawFill(canvas, item, zone, origin, inflation);
            isFilled = true;
        } else if (item.head() == "fill_segments") {
            drawSegments(canvas, item, zone, origin);
            isFilled = true;
        }
    }
    if (isFilled) {
        canvas.zoneFills().hasAny = true;
    } else if (zone.find("fill").hasWord("yes")) {
        canvas.zoneFills().emptyOnes.push_back(zone.line());
    } else {
        reportUnfilled(canvas, zone.line());
    }
}

void reportEmptyFills(Canvas& canvas) {
    for (const std::uint32_t line : canvas.zoneFills().emptyOnes) {
        if (canvas.zoneFills().hasAny) {
            canvas.report(Severity::Info, line, "a zone is filled with nothing: it has no copper");
        } else {
            reportUnfilled(canvas, line);
        }
    }
}

}  // namespace model::kicad
