#pragma once

#include <functional>

#include "ui/workspace/actions.h"

class QMainWindow;

namespace ui {

/// Puts every panel into a dock of its own, where one table says: on which side, behind which other one, under which
/// name the window's state knows it. The panels' toggles become the actions that show and hide them. `panelOf` answers
/// the panel of a toggle.
void addDocks(QMainWindow& window, ActionSet& actions, const std::function<QWidget*(ActionId toggle)>& panelOf);

}  // namespace ui
