#pragma once

#include <QToolButton>

namespace ui {

/// The flat button of an action, as panels have them; belongs to no one yet.
[[nodiscard]] QToolButton* toolButton(QAction& action);

}  // namespace ui
