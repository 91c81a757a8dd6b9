#include "model/index/board_index.h"

#include <algorithm>
#include <cmath>

#include "model/base/parallel.h"
#include "model/geometry/edges.h"

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

Nm clamped(double nm) {
    return static_cast<Nm>(std::lround(std::clamp<double>(nm, -base::kMaxCoordinate, base::kMaxCoordinate)));
}

/// In the coordinates of what is placed so; a nanometre larger for rounding.
Box unplaced(const Box& box, const Placement& placement) {
    Box own;
    for (const Point corner : {box.min, Point{box.max.x, box.min.y}, box.max, Point{box.min.x, box.max.y}}) {
        const PointD at = model::unplaced(base::toDouble(corner), placement);
        own.include(Point{clamped(at.x), clamped(at.y)});
    }
    return own.grownBy(1);
}

}  // namespace

std::vector<CopyInBox> copiesIn(const BoardIndex& index, const Box& box) {
    std::vector<CopyInBox> copies;
    for (std::uint32_t copy = 0; copy < index.tree.copies.size(); ++copy) {
        const StepCopy& placed = index.tree.copies[copy];
        const Box& own = index.extents[placed.step];
        const Box extent = own.isEmpty() ? own : placed.placement.boxOf(own).grownBy(1);
        if (!own.isEmpty() && extent.meets(box)) {
            copies.push_back({copy, extent, unplaced(box, placed.placement)});
        }
    }
    return copies;
}

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
