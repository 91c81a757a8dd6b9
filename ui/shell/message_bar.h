#pragma once

#include <QElapsedTimer>
#include <QFrame>
#include <QTimer>

class QLabel;

namespace ui {

/// A line above the canvas that says what went wrong and stays until it is closed or something succeeds. Never in the
/// way of work.
class MessageBar : public QFrame {
    Q_OBJECT

public:
    /// Errors of one mishap come within this time.
    static constexpr int kTogetherMs = 1000;

    explicit MessageBar(QWidget* parent = nullptr);

    /// Takes the place of an earlier error; those that come together are shown below each other, each once.
    void showError(const QString& text);
    /// Something succeeded: an error from before it is over, one that came with it is not.
    void endEarlierError();
    /// Closes it; false where nothing was shown.
    bool end();

private:
    QLabel* m_label;
    QTimer m_isNew;  ///< runs until what was going on when the error came is done
    QElapsedTimer m_sinceLast;
};

}  // namespace ui
