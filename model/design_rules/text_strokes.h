#pragma once

#include <vector>

#include "model/board/document.h"

namespace model {

/// By element: is it a stroke of a text, as the job says by attribute or group?
[[nodiscard]] std::vector<bool> textStrokesOf(const Document& document);

}  // namespace model
