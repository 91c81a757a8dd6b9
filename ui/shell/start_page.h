#pragma once

#include <QWidget>

namespace ui {

class ActionSet;

/// What is in the middle of the window before a board is open: how to open one.
class StartPage : public QWidget {
    Q_OBJECT

public:
    explicit StartPage(const ActionSet& actions, QWidget* parent = nullptr);
};

}  // namespace ui
