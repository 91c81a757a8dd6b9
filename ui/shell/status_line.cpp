#include "ui/shell/status_line.h"

#include <QComboBox>
#include <QCoreApplication>
#include <QEvent>
#include <QHBoxLayout>
#include <QLabel>
#include <QProgressBar>
#include <QStatusBar>
#include <QToolButton>

#include "ui/common/texts.h"
#include "ui/views/frame_display.h"

namespace ui {

StatusLine::StatusLine(QStatusBar& bar)
    : QObject(&bar),
      m_bar(bar),
      m_work(new QWidget),
      m_workText(new QLabel),
      m_progress(new QProgressBar),
      m_stepLabel(new QLabel(tr("Step"))),
      m_steps(new QComboBox),
      m_position(new QLabel),
      m_frame(new QLabel) {
    m_progress->setRange(0, 100);
    m_progress->setFixedWidth(140);
    m_progress->setMaximumHeight(m_work->fontMetrics().height() + 4);
    auto* cancel = new QToolButton;
    cancel->setText(tr("Stop"));
    cancel->setToolTip(tr("Stop this work; the board on the screen stays (Esc)"));
    connect(cancel, &QToolButton::clicked, this, &StatusLine::cancelRequested);
    m_work->setObjectName(QStringLiteral("work"));
    auto* work = new QHBoxLayout(m_work);
    work->setContentsMargins(4, 0, 4, 0);
    for (QWidget* widget : std::initializer_list<QWidget*>{m_workText, m_progress, cancel}) {
        work->addWidget(widget);
    }
    m_steps->setObjectName(QStringLiteral("steps"));
    m_steps->setToolTip(tr("The part of the job that is shown"));
    m_steps->setSizeAdjustPolicy(QComboBox::AdjustToContents);
    m_stepLabel->setBuddy(m_steps);
    m_frame->setObjectName(QStringLiteral("frame"));
    m_position->setObjectName(QStringLiteral("position"));
    m_position->setContentsMargins(m_position->fontMetrics().horizontalAdvance('0'), 0, 0, 0);  // apart from messages
    m_position->setToolTip(tr("Position of the pointer in the coordinates of the job (Q changes the unit)"));
    for (QWidget* widget : std::initializer_list<QWidget*>{m_position, m_work, m_stepLabel, m_steps, m_frame}) {
        bar.addPermanentWidget(widget);
    }
    m_work->hide();
    m_stepLabel->hide();
    m_steps->hide();
    connect(m_steps, &QComboBox::textActivated, this, &StatusLine::stepChosen);
    connect(&bar, &QStatusBar::messageChanged, &bar, &QStatusBar::setToolTip);  // whole, where it is cut
    QCoreApplication::instance()->installEventFilter(this);
}

void StatusLine::say(const QString& text, bool isStanding) {
    m_bar.showMessage(text);
    isStanding ? m_sinceSaid.invalidate() : m_sinceSaid.start();
}

bool StatusLine::eventFilter(QObject* object, QEvent* event) {
    const QEvent::Type type = event->type();
    const bool isAct = type == QEvent::KeyPress || type == QEvent::MouseButtonPress || type == QEvent::Wheel;
    if (isAct && m_sinceSaid.isValid() && m_sinceSaid.hasExpired(m_readingMs)) {
        m_sinceSaid.invalidate();
        m_bar.clearMessage();
    }
    return QObject::eventFilter(object, event);
}

void StatusLine::beginWork(const QString& name) {
    m_workName = name;
    showProgress(tr("Opening"), 0.0);
    m_work->show();
}

void StatusLine::showProgress(const QString& phase, double fraction) {
    m_workText->setText(QStringLiteral("%1: %2").arg(m_workName, phase));
    const int percent = static_cast<int>(fraction * 100.0);
    if (percent != m_progress->value()) {
        // A progress bar paints at once what changed anywhere in the window: that is left to the next event.
        m_progress->setUpdatesEnabled(false);
        m_progress->setValue(percent);
        m_progress->setUpdatesEnabled(true);
    }
}

void StatusLine::showSteps(const model::JobInfo& job) {
    m_steps->clear();
    m_steps->addItems(textsOf(job.steps));
    m_steps->setCurrentText(QString::fromStdString(job.step));
    const bool hasChoice = job.steps.size() > 1;
    m_stepLabel->setVisible(hasChoice);
    m_steps->setVisible(hasChoice);
}

void StatusLine::showDevice(const render::gpu::Caps& caps) {
    m_device = QString::fromStdString(caps.name);
    m_shortDevice = caps.isCpu ? tr("no graphics card") : m_device;
}

void StatusLine::showFrame(const render::FrameStats& stats) {
    const double ms = stats.gpuMs > 0.0 ? stats.gpuMs : stats.cpuMs;
    m_frame->setText(tr("%1 · %2 ms").arg(m_shortDevice).arg(ms, 0, 'f', 1));
    m_frame->setToolTip(tr("%1, %2, and the time of the last frame").arg(m_device, backendText(stats.backend)));
}

void StatusLine::showPosition(const QString& text) {
    m_position->setText(text.isEmpty() ? text : text + QStringLiteral("   "));  // apart from the device beside it
}

}  // namespace ui
