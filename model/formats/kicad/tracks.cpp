#include "model/formats/kicad/tracks.h"

#include <algorithm>
#include <optional>

#include "model/formats/kicad/graphics.h"
#include "model/formats/kicad/text/values.h"

namespace model::kicad {

void drawTrack(Canvas& canvas, const Item& track) {
    const std::optional<PointD> start = point(track, "start");
    const std::optional<PointD> end = point(track, "end");
    const std::optional<PointD> middle = point(track, "mid");
    const double width = length(track, "width");
    if (!start || !end || width <= 0.0) {
        canvas.report(Severity::Warning, track.line(), "a track lacks ends or width; it was left out");
        return;
    }
    const std::optional<Point> to = canvas.onGrid(*end, track.line());
    const std::optional<Point> from = canvas.onGrid(*start, track.line());
    const std::optional<PathNode> arc = middle ? arcThrough(canvas, track.line(), *start, *middle, *end) : std::nullopt;
    if (!to || !from || (middle && !arc)) {
        return;
    }
    const PathNode node = arc ? *arc : PathNode{*from, {}, EdgeKind::Line};
    Origin origin;
    origin.line = track.line();
    origin.net = canvas.netOf(track);
    origin.subnet = SubnetKind::Trace;
    for (const std::int32_t row : canvas.rowsOf(track)) {
        const bool isCopper = canvas.layers().isCopper(row);
        const double margin = length(track, "solder_mask_margin", canvas.settings().maskMargin);
        canvas.drawEdge(row, origin, node, *to, isCopper ? width : std::max(0.0, width + 2.0 * margin));
    }
}

}  // namespace model::kicad
