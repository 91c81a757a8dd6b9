#include "ui/workspace/writing_thread.h"

#include <algorithm>
#include <new>
#include <utility>

namespace ui {

namespace {

base::Status written(const WritingThread::Write& write) {
    try {
        return write();
    } catch (const std::bad_alloc&) {
        return base::Error{base::ErrorCode::OutputFailed,
                           WritingThread::tr("There is not enough memory to write a file").toStdString()};
    }
}

}  // namespace

WritingThread::WritingThread(QObject* parent)
    : QObject(parent), m_thread([this](const std::stop_token& stop) { run(stop); }) {}

WritingThread::~WritingThread() {
    await();
}

void WritingThread::add(const void* key, Write write, Ended ended) {
    const std::scoped_lock lock(m_mutex);
    std::erase_if(m_waiting, [key](const Task& task) { return key != nullptr && task.key == key; });
    m_waiting.push_back({key, std::move(write), std::move(ended)});
    m_changed.notify_all();
}

bool WritingThread::finish() {
    await();
    return report();
}

bool WritingThread::report() {
    bool areWritten = true;
    std::deque<Outcome> outcomes;
    {
        const std::scoped_lock lock(m_mutex);
        std::swap(outcomes, m_outcomes);
    }
    for (const Outcome& outcome : outcomes) {
        areWritten = areWritten && outcome.status.ok();
        outcome.ended(outcome.status);
    }
    return areWritten;
}

void WritingThread::await() {
    std::unique_lock lock(m_mutex);
    m_changed.wait(lock, [this] { return m_waiting.empty() && !m_isWriting; });
}

void WritingThread::run(const std::stop_token& stop) {
    std::unique_lock lock(m_mutex);
    while (m_changed.wait(lock, stop, [this] { return !m_waiting.empty(); })) {
        Task task = std::move(m_waiting.front());
        m_waiting.pop_front();
        m_isWriting = true;
        lock.unlock();
        base::Status status = written(task.write);
        task.write = {};  // what it holds goes here, not where this lives
        lock.lock();
        m_isWriting = false;
        m_outcomes.push_back({std::move(task.ended), std::move(status)});
        QMetaObject::invokeMethod(this, &WritingThread::report, Qt::QueuedConnection);
        m_changed.notify_all();
    }
}

}  // namespace ui
