#include "ui/shell/keyboard.h"

#include <QAbstractButton>
#include <QAbstractItemView>
#include <QAbstractSlider>
#include <QApplication>
#include <QComboBox>
#include <QDockWidget>
#include <QKeyEvent>
#include <QTimer>
#include <QWindow>
#include <algorithm>
#include <utility>

#include "ui/workspace/key_presets.h"

namespace ui {

namespace {

/// Keys that lists, buttons and fields work with.
constexpr Qt::Key kPanelKeys[] = {Qt::Key_Space, Qt::Key_Return, Qt::Key_Enter,    Qt::Key_Home,
                                  Qt::Key_End,   Qt::Key_PageUp, Qt::Key_PageDown, Qt::Key_F2};

bool isPanelKey(const QKeyEvent& event) {
    const bool isPlain = (event.modifiers() & (Qt::ControlModifier | Qt::AltModifier | Qt::MetaModifier)) == 0;
    return isPlain && std::ranges::find(kPanelKeys, event.key()) != std::end(kPanelKeys);
}

/// Outside panels: what is pressed, chosen from or moved with such keys.
bool isControl(const QWidget* widget) {
    return qobject_cast<const QAbstractButton*>(widget) != nullptr ||
           qobject_cast<const QComboBox*>(widget) != nullptr || qobject_cast<const QAbstractSlider*>(widget) != nullptr;
}

bool canTakeKeys(const QWidget& widget) {
    return (widget.focusPolicy() & Qt::TabFocus) != 0 && widget.isEnabled() && widget.isVisible();
}

/// What had the keyboard in a panel last, or else its table, or else what Tab reaches first.
QWidget* innerFocus(QWidget& panel) {
    if (QWidget* last = panel.focusWidget(); last != nullptr && canTakeKeys(*last)) {
        return last;
    }
    if (auto* table = panel.findChild<QAbstractItemView*>(); table != nullptr && canTakeKeys(*table)) {
        return table;
    }
    for (QWidget* next = panel.nextInFocusChain(); next != &panel; next = next->nextInFocusChain()) {
        if (panel.isAncestorOf(next) && canTakeKeys(*next)) {
            return next;
        }
    }
    return &panel;
}

}  // namespace

Keyboard::Keyboard(QMainWindow& window, ActionSet& actions, BoardViews& views)
    : QObject(&window), m_actions(actions), m_views(views), m_docks(window.findChildren<QDockWidget*>()) {
    connect(&actions[ActionId::NextPanel], &QAction::triggered, this, [this] { step(1); });
    connect(&actions[ActionId::PreviousPanel], &QAction::triggered, this, [this] { step(-1); });
    for (QDockWidget* dock : m_docks) {
        dock->installEventFilter(this);
    }
    window.installEventFilter(this);
}

void Keyboard::setPreset(KeyPreset preset) {
    m_actions.setKeys(preset);
    for (BoardView* view : m_views.both()) {
        view->controller().setHabits(mouseHabitsOf(preset));
    }
}

QList<QWidget*> Keyboard::stops() const {
    QList<QWidget*> stops;
    for (BoardView* view : m_views.both()) {
        if (view->isVisible()) {
            stops += view;
        }
    }
    for (QDockWidget* dock : m_docks) {
        if (!dock->isHidden()) {
            stops += dock;
        }
    }
    return stops;
}

QWidget* Keyboard::current() const {
    for (BoardView* view : m_views.both()) {
        if (QGuiApplication::focusWindow() == &view->canvas()) {
            return view;
        }
    }
    const QWidget* focus = QApplication::focusWidget();
    for (QWidget* stop : stops()) {
        if (focus != nullptr && (stop == focus || stop->isAncestorOf(focus))) {
            return stop;
        }
    }
    return nullptr;
}

void Keyboard::step(int by) {
    const QList<QWidget*> all = stops();
    if (all.isEmpty()) {
        return;  // the start page alone
    }
    const qsizetype at = all.indexOf(current());
    const qsizetype next = at < 0 ? 0 : (at + by + all.size()) % all.size();
    goTo(all[next]);
}

void Keyboard::goTo(QWidget* stop) {
    auto* dock = qobject_cast<QDockWidget*>(stop);
    m_visited = dock;
    if (dock != nullptr) {
        dock->raise();
        dock->activateWindow();  // takes the keyboard from the window of a canvas
        innerFocus(*dock->widget())->setFocus(Qt::ShortcutFocusReason);
        return;
    }
    auto& view = static_cast<BoardView&>(*stop);
    m_views.setActive(view);
    view.takeKeyboard();
}

bool Keyboard::returnToView() {
    if (m_visited == nullptr || current() != m_visited || !m_views.isVisible()) {
        return false;
    }
    goTo(&m_views.active());
    return true;
}

/// The desktop may move the keyboard while the dialog goes: the view takes it after that.
void Keyboard::onDialog(bool isOpen) {
    if (isOpen) {
        const auto& both = m_views.both();
        const auto* const had = std::ranges::find_if(both, &BoardView::hasKeyboard);
        m_interrupted = had != both.end() ? *had : nullptr;
        return;
    }
    QTimer::singleShot(0, this, [this] {
        BoardView* view = std::exchange(m_interrupted, nullptr);
        if (view != nullptr && view->isVisible() && QApplication::activeModalWidget() == nullptr) {
            view->window()->activateWindow();
            view->takeKeyboard();
        }
    });
}

bool Keyboard::eventFilter(QObject* watched, QEvent* event) {
    const bool isOpen = event->type() == QEvent::WindowBlocked;
    if (watched == parent() && (isOpen || event->type() == QEvent::WindowUnblocked)) {
        onDialog(isOpen);
        return false;
    }
    const bool isTaken = qobject_cast<QDockWidget*>(watched) != nullptr || isControl(QApplication::focusWidget());
    if (isTaken && event->type() == QEvent::ShortcutOverride && isPanelKey(static_cast<QKeyEvent&>(*event))) {
        event->accept();
        return true;
    }
    return QObject::eventFilter(watched, event);
}

}  // namespace ui
