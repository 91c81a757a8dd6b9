#include "model/board/copies.h"

#include <algorithm>
#include <unordered_map>

#include "model/board/board_heights.h"

namespace model {

namespace {

/// Walks the tree and keeps the row of each document.
class Unfolder {
public:
    void collect(const Document& document) {
        const auto row = static_cast<std::uint32_t>(m_tree.steps.size());
        if (!m_rows.try_emplace(&document, row).second) {
            return;
        }
        m_tree.steps.push_back(&document);
        for (const auto& step : document.steps) {
            collect(*step);
        }
    }

    void place(const Document& document, const StepCopy& own) {
        m_tree.copies.push_back(own);
        for (const StepInstance& instance : document.instances) {
            const Document& step = *document.steps[instance.step];
            place(step,
                  {m_rows.at(&step), own.placement.after(instance.placement), own.isFlipped != instance.isFlipped});
        }
    }

    StepTree take() { return std::move(m_tree); }

private:
    StepTree m_tree;
    std::unordered_map<const Document*, std::uint32_t> m_rows;
};

}  // namespace

bool isMirroredInCopy(const Document& step, LayerId layer, bool isFlipped) {
    return isFlipped && !step.layer(layer).opposite.isValid();
}

ZRange heightsInCopy(const Document& step, LayerId layer, bool isFlipped) {
    const Layer& on = step.layer(step.layerOfCopy(layer, isFlipped));
    const ZRange z{on.z, on.z + on.thickness};
    if (!isMirroredInCopy(step, layer, isFlipped)) {
        return z;
    }
    const ZRange board = boardHeights(step);
    const Nm faces = board.bottom + board.top;
    return {faces - z.top, faces - z.bottom};
}

ZRange heightsInCopy(const Document& step, LayerId from, LayerId to, bool isFlipped) {
    const ZRange a = heightsInCopy(step, from, isFlipped);
    const ZRange b = heightsInCopy(step, to, isFlipped);
    return {std::min(a.bottom, b.bottom), std::max(a.top, b.top)};
}

ZRange heightsInCopy(const Document& step, ElementId element, bool isFlipped) {
    const LayerId layer = step.elements.layer[element.row()];
    const ZRange z = heightsInCopy(step, layer, isFlipped);
    const Body* body = step.bodyOf(element);
    return body != nullptr ? body->heightsIn(z, growsDownInCopy(step, layer, isFlipped)) : z;
}

bool growsDownInCopy(const Document& step, LayerId layer, bool isFlipped) {
    return (step.layer(layer).side == LayerSide::Bottom) != isFlipped;
}

StepTree unfoldCopies(const Document& board) {
    Unfolder unfolder;
    unfolder.collect(board);
    unfolder.place(board, {});
    return unfolder.take();
}

std::vector<const Document*> distinctSteps(const Document& board) {
    Unfolder unfolder;
    unfolder.collect(board);
    return unfolder.take().steps;
}

}  // namespace model
