#pragma once

#include "model/export/stackup_sheet.h"

class QPainter;

namespace ui {

/// A text of a drawing, black, `size` high in the painter's units. Fonts have whole sizes: letters are drawn large and
/// made smaller.
void paintSheetText(QPainter& painter, const model::SheetText& text, double size);

}  // namespace ui
