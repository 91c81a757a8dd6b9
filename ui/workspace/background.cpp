#include "ui/workspace/background.h"

#include <atomic>
#include <thread>
#include <utility>

#include "model/base/background.h"

namespace ui {

namespace {

constexpr int kPollMs = 40;

}  // namespace

struct Background::Job {
    base::Progress progress;
    std::atomic<bool> isDone = false;
    std::jthread thread;  ///< last, so that it is joined before what it uses goes
};

Background::Background(QObject* parent) : QObject(parent) {
    m_timer.setInterval(kPollMs);
    connect(&m_timer, &QTimer::timeout, this, &Background::poll);
}

Background::~Background() {
    retire();
}

void Background::start(Work work, const char* phase) {
    cancel();
    m_current = std::make_unique<Job>();
    Job& job = *m_current;
    job.progress.beginPhase(phase);
    job.thread = std::jthread([this, &job, run = std::move(work)] {
        base::becomeBackground();  // the window's thread is answered first
        run(job.progress);
        job.isDone = true;
        QMetaObject::invokeMethod(this, &Background::poll, Qt::QueuedConnection);  // at once, not at the next turn
    });
    m_timer.start();
    emit started();
}

void Background::cancel() {
    if (m_current) {
        retire();
        emit cancelled();
    }
}

void Background::retire() {
    if (m_current) {
        m_current->progress.cancel();
        m_retiring.push_back(std::move(m_current));
    }
}

void Background::poll() {
    std::erase_if(m_retiring, [](const auto& job) { return job->isDone.load(); });
    if (m_current && m_current->isDone) {
        m_current.reset();
        emit finished();
    } else if (m_current) {
        const base::Progress& progress = m_current->progress;
        emit progressed(QString::fromStdString(progress.phase()), static_cast<double>(progress.fraction()));
    }
    if (!m_current && m_retiring.empty()) {
        m_timer.stop();
    }
}

}  // namespace ui
