#include "model/formats/kicad/back_drills.h"

#include <cstdint>

#include "model/formats/kicad/text/values.h"

namespace model::kicad {

using formats::kNoRow;

void drawBackDrills(Canvas& canvas, const Item& item, const Origin& origin, PointD at) {
    for (const char* head : {"backdrill", "tertiary_drill"}) {
        const Item drill = item.find(head);
        if (!drill.isThere()) {
            continue;
        }
        const BoardLayers& layers = canvas.layers();
        const double width = length(drill, "size");
        const Item names = drill.find("layers");
        const std::int32_t from = layers.row(names.word(1));
        const std::int32_t to = layers.row(names.word(2));
        if (width <= 0.0 || !layers.isCopper(from) || !layers.isCopper(to)) {
            canvas.report(Severity::Warning, drill.line(),
                          "a back-drill has no size or lacks its layers; the whole hole is shown plated");
            continue;
        }
        Origin drilled = origin;
        drilled.line = drill.line();
        drilled.plating = Plating::NonPlated;
        drilled.pin = kNoRow;
        const std::int32_t row = canvas.layers().backDrills(from, to, canvas.job());
        canvas.drawPad(row, drilled, canvas.pen(width), at, 0.0);
    }
}

}  // namespace model::kicad
