#pragma once

#include <QMainWindow>

#include "ui/views/board_views.h"
#include "ui/workspace/actions.h"

class QDockWidget;

namespace ui {

/// How the window is used with keys: the key preset (and with it the use of the mouse), and which view or panel they
/// go to. Shown views and panels take turns, views first; a panel that lies behind another one comes to the front. A
/// dialog that ends gives them back to the view that had them before.
class Keyboard : public QObject {
    Q_OBJECT

public:
    Keyboard(QMainWindow& window, ActionSet& actions, BoardViews& views);

    void setPreset(KeyPreset preset);
    /// Moves from a panel that was reached with keys to the view in use; false when none has the keyboard.
    bool returnToView();

protected:
    /// Leaves keys that move within panels and bars, or press their buttons, to them, whatever command has them.
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    void step(int by);
    [[nodiscard]] QList<QWidget*> stops() const;
    /// Where the keyboard is: one of `stops`, or none of them.
    [[nodiscard]] QWidget* current() const;
    void goTo(QWidget* stop);
    void onDialog(bool isOpen);

    ActionSet& m_actions;
    BoardViews& m_views;
    BoardView* m_interrupted = nullptr;  ///< the view that had the keyboard when a dialog opened
    QWidget* m_visited = nullptr;        ///< the panel that was reached with keys
    QList<QDockWidget*> m_docks;         ///< in the order they were made, which raising one would change among siblings
};

}  // namespace ui
