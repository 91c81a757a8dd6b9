#pragma once

#include <QString>

#include "model/base/length_writer.h"
#include "model/base/result.h"
#include "model/board/document.h"

namespace ui {

/// Writes the sheet of the stackup (model/export/stackup_sheet.h) as a PDF of one A4 page, lengthwise or across as it
/// fits. `write` says lengths. Errors: BadUsage for boards without a stackup, OutputFailed.
[[nodiscard]] base::Status writeStackupPdf(const model::Document& document, const QString& path, bool isExaggerated,
                                           const model::LengthWriter& write);

}  // namespace ui
