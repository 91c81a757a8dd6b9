#pragma once

#include <QElapsedTimer>
#include <QWidget>

#include "model/board/document.h"
#include "render/gpu/device.h"
#include "render/scene/view_settings.h"

class QComboBox;
class QLabel;
class QProgressBar;
class QStatusBar;

namespace ui {

/// The widgets of the status bar: progress of work with a button to stop it (hidden while nothing runs), the step
/// shown, the device, the time of the last frame. Texts that do not change are short, so that messages find room.
class StatusLine : public QObject {
    Q_OBJECT

public:
    explicit StatusLine(QStatusBar& bar);

    /// What was just done goes with the first key, click or turn of the wheel once there was time to read it, lest it
    /// speaks of what is no longer so. What is `isStanding` stays.
    void say(const QString& text, bool isStanding);
    void setReadingMs(int ms) { m_readingMs = ms; }
    void beginWork(const QString& name);
    /// `fraction` of the phase, 0 to 1.
    void showProgress(const QString& phase, double fraction);
    void endWork() { m_work->hide(); }
    /// Offers the job's steps when there are several, with the one shown chosen.
    void showSteps(const model::JobInfo& job);
    /// Says of a software device that it is one.
    void showDevice(const render::gpu::Caps& caps);
    void showFrame(const render::FrameStats& stats);
    /// Where the cursor is on the board; empty when it is not.
    void showPosition(const QString& text);

signals:
    void cancelRequested();
    /// The user chose another step.
    void stepChosen(const QString& step);

private:
    bool eventFilter(QObject* object, QEvent* event) override;

    QStatusBar& m_bar;
    int m_readingMs = 5'000;
    QElapsedTimer m_sinceSaid;  ///< invalid while nothing is said that may go
    QString m_workName;
    QWidget* m_work;
    QLabel* m_workText;
    QProgressBar* m_progress;
    QLabel* m_stepLabel;
    QComboBox* m_steps;
    QLabel* m_position;
    QLabel* m_frame;
    QString m_device;
    QString m_shortDevice;  ///< says only that there is no card, where there is none
};

}  // namespace ui
