#include "model/section/layer_ranges.h"

#include <algorithm>
#include <cmath>

#include "model/board/local_stack.h"
#include "model/geometry/region.h"
#include "model/section/line_cut.h"

namespace model {

namespace {

Intervals joined(Intervals a, const Intervals& b) {
    a.insert(a.end(), b.begin(), b.end());
    return united(std::move(a));
}

}  // namespace

LayerOutlines::LayerOutlines(const BoardIndex& index) : m_index(index) {
    const std::vector<const Document*>& steps = index.tree.steps;
    for (std::size_t row = 0; row < index.board->layers.size(); ++row) {
        const auto isBounded = [row](const Document* step) { return step->layers[row].profile.isValid(); };
        if (std::ranges::any_of(steps, isBounded)) {
            m_rows.push_back(row);
        }
    }
    for (std::size_t step = 0; step < steps.size() && !m_rows.empty(); ++step) {
        addShape(step, steps[step]->profile);
        for (const std::size_t row : m_rows) {
            addShape(step, steps[step]->layers[row].profile);
        }
    }
}

void LayerOutlines::addShape(std::size_t step, ShapeId shape) {
    if (shape.isValid() && !m_shapes.contains({step, shape})) {
        m_shapes[{step, shape}] = discretise(m_index.tree.steps[step]->shapes, shape, kBooleanChords);
    }
}

const PolygonSet& LayerOutlines::outline(std::size_t step, ShapeId shape) const {
    return m_shapes.at({step, shape});
}

LayerRanges LayerOutlines::between(PointD a, PointD b) const {
    LayerRanges ranges;
    const CutLine line = CutLine::through(a, b);
    const double length = std::hypot(b.x - a.x, b.y - a.y);
    // A copy says what is within its outline, whatever holds it.
    for (const StepCopy& copy : m_rows.empty() ? std::span<const StepCopy>() : std::span(m_index.tree.copies)) {
        const Document& step = *m_index.tree.steps[copy.step];
        const CutLine own = line.seenFrom(copy.placement);
        const auto cut = [&](ShapeId shape) {
            return shape.isValid() ? clipped(cutPolygons(outline(copy.step, shape), own), 0.0, length)
                                   : Intervals{{0.0, length}};
        };
        const Intervals within = cut(step.profile);
        for (const std::size_t row : m_rows) {
            Intervals& range = ranges[step.layerOfCopy(LayerId{row}, copy.isFlipped)];
            const Layer& layer = step.layer(LayerId{row});
            range = subtracted(range, within);
            if (layer.profile.isValid() || !isLaidOn(layer)) {
                range = joined(range, layer.profile.isValid() ? cut(layer.profile) : within);
            }
        }
    }
    return ranges;
}

}  // namespace model
