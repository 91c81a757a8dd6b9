#pragma once

#include "ui/workspace/feature.h"

namespace ui {

class MessageModel;

/// The messages panel: what was skipped, repaired or assumed while the board was opened, what is left out of its rules
/// and exports, and the badge that counts it.
/// A message that is chosen is shown: its element is selected, its layer visible.
void addMessages(FeatureContext& context);

/// Messages with file and line, filtered by words and by severity. A click on one, or Enter, chooses it.
[[nodiscard]] QWidget* makeMessagesPanel(MessageModel& model,
                                         const std::function<void(const model::Diagnostic&)>& choose);

}  // namespace ui
