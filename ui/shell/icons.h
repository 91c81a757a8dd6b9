#pragma once

#include <QIcon>

namespace ui {

enum class ActionId;

/// A line drawing for a command that is on the toolbar, in the colour of the current palette; a null icon for the
/// others.
[[nodiscard]] QIcon iconOf(ActionId id);

}  // namespace ui
