#pragma once

#include <QFrame>

class QLabel;

namespace ui {

/// A line above the canvas that says what went wrong and stays until it is closed or something succeeds. Never in the
/// way of work.
class MessageBar : public QFrame {
    Q_OBJECT

public:
    explicit MessageBar(QWidget* parent = nullptr);

    void showError(const QString& text);

private:
    QLabel* m_label;
};

}  // namespace ui
