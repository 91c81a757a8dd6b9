#pragma once

#include <QString>

class QWidget;

namespace ui {

/// All keys and mouse gestures as rich text, made from the action table.
[[nodiscard]] QString keysSheetText();

/// Both are modeless: the window stays usable.
void showKeysSheet(QWidget& parent);
void showAbout(QWidget& parent);

}  // namespace ui
