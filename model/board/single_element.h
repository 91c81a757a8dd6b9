#pragma once

#include <cstddef>
#include <memory>

#include "model/board/document.h"

namespace model {

/// A document of one element, row 0, on a layer like its own at the same heights: for a picture of it, or to hand it
/// to somebody. The board's extent is its box. Net, symbol and attributes stay behind. Of areas, contours smaller than
/// `detail` (nm) are left out, and nodes of straight edges that are nearer than it to the one before them: for pictures
/// whose pixels are larger.
[[nodiscard]] std::shared_ptr<const Document> elementAlone(const Document& document, ElementId element, Nm detail = 0);

/// Nodes its outline or its middle line is stored with; 2 for a line, 1 for a circle. What drawing it costs goes by it.
[[nodiscard]] std::size_t nodeCountOf(const Document& document, ElementId element);

}  // namespace model
