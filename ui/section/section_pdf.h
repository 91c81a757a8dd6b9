#pragma once

#include <QString>

#include "model/base/result.h"
#include "model/export/section_sheet.h"

namespace ui {

/// Writes the sheet of a section as a PDF of one page that is as large as the sheet, so that it prints true to scale.
/// Errors: OutputFailed.
[[nodiscard]] base::Status writeSectionPdf(const model::SectionSheet& sheet, const QString& title, const QString& path);

}  // namespace ui
