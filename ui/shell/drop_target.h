#pragma once

#include <QObject>
#include <QStringList>

namespace ui {

/// Lets boards be dropped on whatever it is installed on as an event filter, a widget or a native window.
class DropTarget : public QObject {
    Q_OBJECT

public:
    using QObject::QObject;
    bool eventFilter(QObject* watched, QEvent* event) override;

signals:
    /// Local files and folders, at least one.
    void dropped(const QStringList& paths);
};

}  // namespace ui
