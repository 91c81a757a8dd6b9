#include "ui/shell/status_line.h"

#include <QComboBox>
#include <QLabel>
#include <QStatusBar>

#include "ui/common/texts.h"
#include "ui/views/frame_display.h"

namespace ui {

StatusLine::StatusLine(QStatusBar& bar)
    : QObject(&bar),
      m_loadBar(new LoadBar),
      m_stepLabel(new QLabel(tr("Step"))),
      m_steps(new QComboBox),
      m_position(new QLabel),
      m_frame(new QLabel) {
    m_steps->setToolTip(tr("The part of the job that is shown"));
    m_steps->setSizeAdjustPolicy(QComboBox::AdjustToContents);
    m_stepLabel->setBuddy(m_steps);
    m_frame->setToolTip(tr("Device, how it draws, and the time of the last frame"));
    m_position->setToolTip(tr("Position of the pointer in the coordinates of the job (Q changes the unit)"));
    for (QWidget* widget :
         {static_cast<QWidget*>(m_position), static_cast<QWidget*>(m_loadBar), static_cast<QWidget*>(m_stepLabel),
          static_cast<QWidget*>(m_steps), static_cast<QWidget*>(m_frame)}) {
        bar.addPermanentWidget(widget);
    }
    m_stepLabel->hide();
    m_steps->hide();
    connect(m_steps, &QComboBox::textActivated, this, &StatusLine::stepChosen);
}

void StatusLine::showSteps(const model::JobInfo& job) {
    m_steps->clear();
    m_steps->addItems(textsOf(job.steps));
    m_steps->setCurrentText(QString::fromStdString(job.step));
    const bool hasChoice = job.steps.size() > 1;
    m_stepLabel->setVisible(hasChoice);
    m_steps->setVisible(hasChoice);
}

void StatusLine::showFrame(const render::FrameStats& stats) {
    const double ms = stats.gpuMs > 0.0 ? stats.gpuMs : stats.cpuMs;
    m_frame->setText(QStringLiteral("%1 · %2 · %3 ms").arg(m_device, backendText(stats.backend)).arg(ms, 0, 'f', 1));
}

void StatusLine::showPosition(const QString& text) {
    m_position->setText(text.isEmpty() ? text : text + QStringLiteral("   "));  // apart from the device beside it
}

QString StatusLine::positionText() const {
    return m_position->text();
}

QString StatusLine::frameText() const {
    return m_frame->text();
}

}  // namespace ui
