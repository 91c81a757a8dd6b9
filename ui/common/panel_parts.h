#pragma once

#include <QAction>
#include <QBoxLayout>
#include <QLineEdit>
#include <QMenu>
#include <QToolBar>
#include <QToolButton>

/// What panels are put together from, alike in all of them. The parts belong to no one yet.
namespace ui {

class SortedRows;

/// A command that only its panel has; `name` is for whoever looks for its button.
template <class Run>
[[nodiscard]] QAction* command(QWidget& panel, const char* name, const QString& text, const QString& tip,
                               const Run& run) {
    auto* action = new QAction(text, &panel);
    action->setObjectName(QLatin1String(name));
    action->setToolTip(tip);
    QObject::connect(action, &QAction::triggered, &panel, run);
    return action;
}
/// The flat button of an action, named as that is.
[[nodiscard]] QToolButton* toolButton(QAction& action);
/// Buttons side by side; what is added next is at the right.
[[nodiscard]] QHBoxLayout* buttonRow(std::initializer_list<QAction*> actions);
/// The same, but what has no room folds into a menu: the buttons do not widen the window.
[[nodiscard]] QToolBar* toolBar(std::initializer_list<QAction*> actions);
/// A line to filter by. Esc empties it, then leaves it.
[[nodiscard]] QLineEdit* filterEdit(const QString& hint);
/// The same, which filters rows by words.
[[nodiscard]] QLineEdit* filterEdit(SortedRows& rows, const QString& hint);
/// A panel of controls above a table or drawing.
[[nodiscard]] QWidget* panelOf(QLayout* controls, QWidget* below, int margin = 2);
/// Also deletes the menus that were added to it by their titles, which QMenu::clear leaves.
void clearMenu(QMenu& menu);
/// The layout of a panel, one above the other with little room between.
QVBoxLayout* columnIn(QWidget& panel, int margin = 2);

}  // namespace ui
