#pragma once

#include <vector>

#include "model/board/document.h"

namespace app {

/// What is milled away of a board beyond its outline, for sections (model::SectionRequest::milled).
struct MilledElements {
    std::vector<model::ElementId> elements;  ///< whole or in part, rising
    bool isOutlineDoubtful = false;          ///< model::MilledBoard: nothing is milled
};
[[nodiscard]] MilledElements milledElementsOf(const model::Document& board);

}  // namespace app
