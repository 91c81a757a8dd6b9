#pragma once

#include <memory>
#include <vector>

#include "model/base/progress.h"
#include "model/base/result.h"
#include "model/board/copies.h"
#include "model/index/element_index.h"
#include "model/index/figure_cache.h"
#include "model/index/pin_finder.h"

namespace model {

/// Where the elements of a board are, copies of steps included, and whose pins they are. Made once per document and
/// frozen with it.
struct BoardIndex {
    std::shared_ptr<const Document> board;
    StepTree tree;
    std::vector<ElementIndex> elements;                                      ///< per step of the tree
    std::vector<Box> extents;                                                ///< per step, of its own elements
    std::vector<PinFinder> pins;                                             ///< per step
    std::shared_ptr<FigureCache> figures = std::make_shared<FigureCache>();  ///< the same for all heights

    [[nodiscard]] const Document& stepOf(std::uint32_t copy) const { return *tree.steps[tree.copies[copy].step]; }
    /// In the coordinates of its step, a row of `tree.steps`.
    [[nodiscard]] std::shared_ptr<const FigureTable> figuresOf(std::uint32_t step, ElementId element) const {
        return figures->of(tree, step, element);
    }
    [[nodiscard]] const PinFinder& pinsOf(std::uint32_t copy) const { return pins[tree.copies[copy].step]; }
};

/// A copy whose own elements may lie in a box of the board.
struct CopyInBox {
    std::uint32_t copy = 0;
    Box extent;  ///< of its own elements, on the board
    Box box;     ///< around that box, in the coordinates of the step
};

/// Rising. Those that lie elsewhere cost a comparison each.
[[nodiscard]] std::vector<CopyInBox> copiesIn(const BoardIndex& index, const Box& box);

/// Errors: Cancelled.
[[nodiscard]] base::Result<std::shared_ptr<const BoardIndex>> indexBoard(std::shared_ptr<const Document> board,
                                                                         base::Progress& progress);

/// The same for a board that differs in heights only (model::restack); next to no cost.
[[nodiscard]] std::shared_ptr<const BoardIndex> withHeights(const BoardIndex& index,
                                                            std::shared_ptr<const Document> board);

}  // namespace model
