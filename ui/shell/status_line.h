#pragma once

#include "model/board/document.h"
#include "render/scene/view_settings.h"
#include "ui/shell/load_bar.h"

class QComboBox;
class QLabel;
class QStatusBar;

namespace ui {

/// The widgets of the status bar: progress of a load, the step shown, the device, the time of the last frame.
class StatusLine : public QObject {
    Q_OBJECT

public:
    explicit StatusLine(QStatusBar& bar);

    [[nodiscard]] LoadBar& loadBar() { return *m_loadBar; }
    /// Offers the job's steps when there are several, with the one shown chosen.
    void showSteps(const model::JobInfo& job);
    void showDevice(const QString& name) { m_device = name; }
    void showFrame(const render::FrameStats& stats);
    /// Where the cursor is on the board; empty when it is not.
    void showPosition(const QString& text);
    [[nodiscard]] QString positionText() const;
    [[nodiscard]] QString frameText() const;
    [[nodiscard]] QComboBox& stepBox() { return *m_steps; }

signals:
    /// The user chose another step.
    void stepChosen(const QString& step);

private:
    LoadBar* m_loadBar;
    QLabel* m_stepLabel;
    QComboBox* m_steps;
    QLabel* m_position;
    QLabel* m_frame;
    QString m_device;
};

}  // namespace ui
