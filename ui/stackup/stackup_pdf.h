#pragma once

#include <string>

#include "model/base/length_writer.h"
#include "model/base/result.h"
#include "model/board/document.h"

namespace ui {

/// The sheet of the stackup (model/export/stackup_sheet.h) as a PDF of one A4 page, lengthwise or across as it fits.
/// `write` says lengths. Errors: BadUsage for boards without a stackup.
[[nodiscard]] base::Result<std::string> stackupPdf(const model::Document& document, bool isExaggerated,
                                                   const model::LengthWriter& write);

}  // namespace ui
