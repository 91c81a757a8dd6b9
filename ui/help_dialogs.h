#pragma once

#include <QString>

#include "ui/actions.h"

class QWidget;

namespace ui {

/// All keys and mouse gestures as rich text, made from the action table.
[[nodiscard]] QString keysSheetText(KeyPreset keys);

/// Both are modeless: the window stays usable.
void showKeysSheet(QWidget& parent, KeyPreset keys);
void showAbout(QWidget& parent);

}  // namespace ui
