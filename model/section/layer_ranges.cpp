#include "model/section/layer_ranges.h"

#include <algorithm>
#include <cmath>

#include "model/geometry/region.h"
#include "model/section/line_cut.h"
#include "model/section/local_stack.h"

namespace model {

namespace {

bool isBounded(const StepTree& tree, std::size_t row) {
    return std::ranges::any_of(tree.steps, [row](const Document* step) {
        return row < step->layers.size() && step->layers[row].profile.isValid();
    });
}

Intervals cutShape(const Document& step, ShapeId shape, const CutLine& line, double length) {
    return shape.isValid() ? clipped(cutPolygons(discretise(step.shapes, shape, kBooleanChords), line), 0.0, length)
                           : Intervals{{0.0, length}};
}

Intervals both(Intervals a, const Intervals& b) {
    a.insert(a.end(), b.begin(), b.end());
    return united(std::move(a));
}

}  // namespace

LayerRanges layerRangesOf(const BoardIndex& index, PointD a, PointD b) {
    LayerRanges ranges;
    const CutLine line = CutLine::through(a, b);
    const double length = std::hypot(b.x - a.x, b.y - a.y);
    for (std::size_t row = 0; row < index.board->layers.size(); ++row) {
        if (!isBounded(index.tree, row)) {
            continue;
        }
        // A copy says what is within its outline, whatever holds it.
        for (const StepCopy& copy : index.tree.copies) {
            const Document& step = *index.tree.steps[copy.step];
            const CutLine own = line.seenFrom(copy.placement);
            Intervals& range = ranges[step.layerOfCopy(LayerId{row}, copy.isFlipped)];
            const Intervals within = cutShape(step, step.profile, own, length);
            const ShapeId profile = step.layer(LayerId{row}).profile;
            const bool isUnsaid = !profile.isValid() && isLaidOn(step.layer(LayerId{row}));
            range = subtracted(range, within);
            if (!isUnsaid) {
                range = both(range, profile.isValid() ? cutShape(step, profile, own, length) : within);
            }
        }
    }
    return ranges;
}

}  // namespace model
