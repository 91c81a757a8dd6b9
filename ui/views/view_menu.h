#pragma once

namespace ui {

struct FeatureContext;

/// The menu of a right click in the views. On an element: what lies there, and what can be done with its net, its part,
/// its layer and the selection; the click selects it first, as a left click does, unless it is chosen already, so that
/// all commands are for the selection. Beside the board: what shows all of it again.
void addViewMenu(FeatureContext& context);

}  // namespace ui
