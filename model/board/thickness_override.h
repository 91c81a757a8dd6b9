#pragma once

#include <string_view>

#include "model/base/result.h"
#include "model/board/document.h"

namespace model {

/// "LAYER=LENGTH" for a row of the stackup, in any case. Layer names may hold "=": the last one counts. Errors:
/// BadUsage for what is no thickness (model/base/thickness_units.h), and when there is no such row (the text lists
/// those that are there).
[[nodiscard]] base::Result<ThicknessOverride> parseOverride(std::string_view text, const Stackup& stackup);

}  // namespace model
