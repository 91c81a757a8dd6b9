#include "model/solids/shells/trail_shell.h"

#include "model/solids/shells/arc_shell.h"
#include "model/solids/shells/line_shell.h"

namespace model {

std::vector<EdgeLoops> trackOutlines(const Document& document, const TrailGeometry& trail) {
    const std::span<const PathNode> nodes = document.nodesOf(trail);
    const std::span<const Nm> widths = document.widthsOf(trail);
    std::vector<EdgeLoops> tracks;
    for (std::size_t i = 0; i < widths.size(); ++i) {
        const Point next = nodes[i + 1].point;
        std::optional<EdgeLoops> outline = nodes[i].edge == EdgeKind::Line
                                               ? lineOutline({nodes[i].point, next, widths[i], trail.innerWidth}, false)
                                               : arcOutline({nodes[i], next, widths[i], trail.innerWidth});
        if (outline && outline->loopCount() > 0) {
            tracks.push_back(std::move(*outline));
        }
    }
    return tracks;
}

}  // namespace model
