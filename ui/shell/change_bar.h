#pragma once

#include <QFrame>

namespace ui {

/// A quiet line above the canvas: the files of the board changed on the disk, and what is to be done.
class ChangeBar : public QFrame {
    Q_OBJECT

public:
    explicit ChangeBar(QWidget* parent = nullptr);

signals:
    void reloadRequested();
};

}  // namespace ui
