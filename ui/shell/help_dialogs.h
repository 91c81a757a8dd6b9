#pragma once

#include <QString>

#include "ui/workspace/actions.h"

class QWidget;

namespace ui {

/// All keys and mouse gestures as rich text, made from the action table.
[[nodiscard]] QString keyListText(KeyPreset keys);

/// Both are modeless: the window stays usable.
void showKeyList(QWidget& parent, KeyPreset keys);
void showAbout(QWidget& parent);

}  // namespace ui
