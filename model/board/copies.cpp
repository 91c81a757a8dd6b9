#include "model/board/copies.h"

#include <unordered_map>

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
