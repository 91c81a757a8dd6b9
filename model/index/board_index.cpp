#include "model/index/board_index.h"

#include "model/base/parallel.h"

namespace model {

namespace {

constexpr std::size_t kPiece = 4096;  // elements per task

std::vector<Box> boxesOf(const Document& document, const base::Progress& progress) {
    const std::size_t count = document.elements.size();
    std::vector<Box> boxes(count);
    base::parallelFor((count + kPiece - 1) / kPiece, [&](std::size_t piece) {
        for (std::size_t row = piece * kPiece; row < std::min(count, (piece + 1) * kPiece); ++row) {
            if (!progress.isCancelled()) {
                boxes[row] = document.boxOf(ElementId{row});
            }
        }
    });
    return boxes;
}

}  // namespace

base::Result<std::shared_ptr<const BoardIndex>> indexBoard(std::shared_ptr<const Document> board,
                                                           base::Progress& progress) {
    progress.beginPhase("Indexing elements");
    BoardIndex index;
    index.tree = unfoldCopies(*board);
    index.board = std::move(board);
    for (const Document* step : index.tree.steps) {
        const std::vector<Box> boxes = boxesOf(*step, progress);
        if (progress.isCancelled()) {
            return base::Error{base::ErrorCode::Cancelled, "Cancelled"};
        }
        index.elements.emplace_back(*step, boxes);
        Box& extent = index.extents.emplace_back();
        for (const Box& box : boxes) {
            extent.include(box);
        }
        index.pins.emplace_back(*step);
        progress.setFraction(static_cast<float>(index.elements.size()) / static_cast<float>(index.tree.steps.size()));
    }
    return std::make_shared<const BoardIndex>(std::move(index));
}

std::shared_ptr<const BoardIndex> withHeights(const BoardIndex& index, std::shared_ptr<const Document> board) {
    BoardIndex raised = index;
    raised.tree = unfoldCopies(*board);
    raised.board = std::move(board);
    for (std::size_t step = 0; step < raised.pins.size(); ++step) {
        raised.pins[step] = PinFinder(std::move(raised.pins[step]), *raised.tree.steps[step]);
    }
    return std::make_shared<const BoardIndex>(std::move(raised));
}

}  // namespace model
