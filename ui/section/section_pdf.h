#pragma once

#include <QString>
#include <string>

#include "model/export/section_sheet.h"

namespace ui {

/// The sheet of a section as a PDF of one page that is as large as the sheet, so that it prints true to scale.
[[nodiscard]] std::string sectionPdf(const model::SectionSheet& sheet, const QString& title);

}  // namespace ui
