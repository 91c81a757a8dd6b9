#include "model/formats/kicad/post_machining.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <string>
#include <string_view>
#include <vector>

#include "model/formats/kicad/text/values.h"

namespace model::kicad {

namespace {

using formats::kNoRow;

constexpr double kUsualDegrees = 90.0;

/// A copper layer, and how deep its surface lies below the side that is machined.
struct Reached {
    std::int32_t row = kNoRow;
    double depth = 0.0;
};

/// From one side inwards; without a stackup nothing but the outer layer has a depth.
std::vector<Reached> copperFrom(Canvas& canvas, bool isFront) {
    const BoardLayers& layers = canvas.layers();
    const std::vector<std::int32_t>& copper = layers.copper();
    std::vector<Reached> reached;
    double depth = 0.0;
    const std::int32_t step = isFront ? 1 : -1;
    const std::int32_t end = isFront ? copper.back() : copper.front();
    for (std::int32_t row = isFront ? copper.front() : copper.back();; row += step) {
        if (layers.isCopper(row)) {
            reached.push_back({row, depth});
        }
        depth += canvas.job().layers[static_cast<std::size_t>(row)].facts.thicknessNm.value_or(0.0);
        if (row == end || !layers.hasStackup()) {
            return reached;
        }
    }
}

/// The tool that widens a hole.
struct Tool {
    bool isCone = false;
    double size = 0.0;   ///< diameter at the surface
    double depth = 0.0;  ///< 0: as deep as the cone goes
    double slope = 0.0;  ///< of a cone: radius lost with each unit of depth

    /// Its diameter so deep; 0 beyond its end.
    [[nodiscard]] double widthAt(double z) const {
        const bool isBeyond = z > 0.0 && depth > 0.0 && z >= depth;
        return isBeyond ? 0.0 : size - (isCone ? 2.0 * z * slope : 0.0);
    }
};

Tool toolOf(Canvas& canvas, const Item& machining, double drill) {
    Tool tool{machining.word(1) == "countersink", length(machining, "size"), length(machining, "depth"), 0.0};
    const double degrees = number(machining, "angle");
    if (!tool.isCone && tool.depth <= 0.0) {
        canvas.report(Severity::Warning, machining.line(),
                      "a counterbore has no depth; it is shown in the outer copper alone");
        tool.depth = 1.0;
    } else if (tool.isCone && degrees > 0.0 && degrees < 180.0) {
        tool.slope = std::tan(degrees / 2.0 * std::numbers::pi / 180.0);
    } else if (tool.isCone && tool.depth > 0.0) {
        tool.slope = std::max(tool.size - drill, 0.0) / 2.0 / tool.depth;
    } else if (tool.isCone) {
        canvas.report(Severity::Warning, machining.line(), "a countersink has no angle; 90 degrees were taken");
        tool.slope = std::tan(kUsualDegrees / 2.0 * std::numbers::pi / 180.0);
    }
    return tool;
}

void drawMachining(Canvas& canvas, const Item& machining, const Origin& origin, PointD at, double drill, bool isFront) {
    if (drill <= 0.0) {
        return canvas.report(Severity::Warning, machining.line(),
                             "counterbores and countersinks of slots are not shown");
    }
    const Tool tool = toolOf(canvas, machining, drill);
    if (tool.size <= drill) {
        return canvas.report(Severity::Warning, machining.line(),
                             "a counterbore or countersink is no wider than its hole; it was left out");
    }
    Origin drilled = origin;
    drilled.line = machining.line();
    drilled.plating = Plating::NonPlated;
    drilled.pin = kNoRow;
    const std::vector<Reached> copper = copperFrom(canvas, isFront);
    for (const Reached& layer : copper) {
        const double width = tool.widthAt(layer.depth);
        if (width > drill) {
            const std::int32_t row = canvas.layers().wideDrills(copper.front().row, layer.row, canvas.job());
            canvas.drawPad(row, drilled, canvas.pen(width), at, 0.0);
        }
    }
    canvas.report(Severity::Info, machining.line(),
                  "counterbores and countersinks are shown as far as the copper that they reach");
}

}  // namespace

void drawPostMachining(Canvas& canvas, const Item& item, const Origin& origin, PointD at, double drill) {
    for (const bool isFront : {true, false}) {
        const Item machining = item.find(isFront ? "front_post_machining" : "back_post_machining");
        const std::string_view kind = machining.word(1);
        if (kind == "counterbore" || kind == "countersink") {
            drawMachining(canvas, machining, origin, at, drill, isFront);
        } else if (machining.isThere() && kind != "not_post_machined" && kind != "none") {
            canvas.report(Severity::Warning, machining.line(), "a hole is machined in an unknown way; it is not shown");
        }
    }
}

}  // namespace model::kicad
