#pragma once

#include <QKeySequence>
#include <QList>
#include <QString>

#include "ui/canvas/camera_controller.h"
#include "ui/workspace/actions.h"

/// Keys and drags as people know them from other programs. A preset names only what differs from the table of actions;
/// a key it uses is taken from the command that has it there.
namespace ui {

/// Every command has a key in every preset, and no two commands of a preset share one or begin alike.
[[nodiscard]] QList<QKeySequence> keysOf(const ActionSpec& spec, KeyPreset preset);
/// "F or Home", with " or " between.
[[nodiscard]] QString keysText(const QList<QKeySequence>& keys, const QString& between);
[[nodiscard]] MouseHabits mouseHabitsOf(KeyPreset preset);

}  // namespace ui
