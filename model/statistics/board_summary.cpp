#include "model/statistics/board_summary.h"

#include <algorithm>

#include "model/board/copies.h"

namespace model {

BoardSummary summaryOf(const Document& board, std::span<const DrillRow> drills) {
    BoardSummary summary{.width = board.board.width(),
                         .height = board.board.height(),
                         .isSizeAssumed = !board.profile.isValid() || board.profileSource == Source::Assumed,
                         .thickness = board.boardThickness,
                         .hasCopies = !board.instances.empty()};
    summary.copperLayers = static_cast<std::size_t>(std::ranges::count_if(board.layers, &Layer::isBoardCopper));
    const StepTree tree = unfoldCopies(board);
    for (const StepCopy& copy : tree.copies) {
        summary.nets += tree.steps[copy.step]->nets.size();
        summary.components += tree.steps[copy.step]->components.size();
    }
    for (const DrillRow& row : drills) {
        summary.holes += row.count;
    }
    return summary;
}

}  // namespace model
