#pragma once

#include <QWidget>

class QLabel;
class QProgressBar;
class QToolButton;

namespace ui {

/// Progress of a load in the status bar: what is being done, how far it is, and a button to stop it. Hidden while
/// nothing loads.
class LoadBar : public QWidget {
    Q_OBJECT

public:
    explicit LoadBar(QWidget* parent = nullptr);

    void begin(const QString& name);
    /// `fraction` of the phase, 0 to 1.
    void report(const QString& phase, double fraction);
    [[nodiscard]] QString text() const;

signals:
    void cancelRequested();

private:
    QString m_name;
    QLabel* m_label;
    QProgressBar* m_bar;
    QToolButton* m_cancel;
};

}  // namespace ui
