#include "ui/shell/wheel_guard.h"

#include <QAbstractSpinBox>
#include <QApplication>
#include <QComboBox>
#include <QEvent>
#include <QSlider>

namespace ui {

namespace {

/// The control whose value the wheel over it would change; null for none. Fields in spin boxes are theirs.
QWidget* controlAt(QObject* watched) {
    const auto isControl = [](const QObject* object) {
        return qobject_cast<const QComboBox*>(object) != nullptr ||
               qobject_cast<const QAbstractSpinBox*>(object) != nullptr ||
               qobject_cast<const QSlider*>(object) != nullptr;
    };
    return isControl(watched) ? static_cast<QWidget*>(watched)
           : watched->isWidgetType() && isControl(watched->parent()) && !static_cast<QWidget*>(watched)->isWindow()
               ? static_cast<QWidget*>(watched->parent())
               : nullptr;
}

}  // namespace

WheelGuard::WheelGuard(QObject* parent) : QObject(parent) {
    qApp->installEventFilter(this);
}

bool WheelGuard::eventFilter(QObject* watched, QEvent* event) {
    if (event->type() != QEvent::Wheel && event->type() != QEvent::Polish) {
        return QObject::eventFilter(watched, event);
    }
    QWidget* control = controlAt(watched);
    if (control == nullptr) {
        return QObject::eventFilter(watched, event);
    }
    if (event->type() == QEvent::Polish) {
        if (control->focusPolicy() == Qt::WheelFocus) {  // else the wheel gives it the keyboard first
            control->setFocusPolicy(Qt::StrongFocus);
        }
        return QObject::eventFilter(watched, event);
    }
    const QWidget* focus = QApplication::focusWidget();
    const bool hasKeyboard = focus != nullptr && (control == focus || control->isAncestorOf(focus));
    if (!hasKeyboard) {
        event->ignore();  // it goes on to the parent
    }
    return !hasKeyboard || QObject::eventFilter(watched, event);
}

}  // namespace ui
