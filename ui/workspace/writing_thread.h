#pragma once

#include <QObject>
#include <condition_variable>
#include <deque>
#include <functional>
#include <mutex>
#include <thread>

#include "model/base/result.h"

namespace ui {

/// Writes the files that take no time but that of the disk (sessions, settings, tables), one after another in the order
/// in which that was asked for, on a thread of its own: a disk that has much to do can take a second for each, and the
/// window does not wait for it. What takes longer and can be stopped is done by a Background.
class WritingThread : public QObject {
    Q_OBJECT

public:
    /// Runs on the thread. Out of memory is an error of its own.
    using Write = std::function<base::Status()>;
    /// Called where this lives.
    using Ended = std::function<void(const base::Status&)>;

    explicit WritingThread(QObject* parent = nullptr);
    /// Writes what is left; nothing is reported.
    ~WritingThread() override;

    /// What was asked for with the same `key` and is not begun yet is not written any more, and not reported: it is of
    /// an older state. Null keeps all. What `ended` refers to lives as long as this.
    void add(const void* key, Write write, Ended ended);
    /// Waits until all is written, and reports it. False: something that was not reported before could not be written.
    bool finish();
    /// Reports at once what has ended, which the event loop does otherwise. False: as of finish.
    bool report();
    /// Waits until all is written, on another thread than the one where this lives.
    void await();

private:
    struct Task {
        const void* key = nullptr;
        Write write;
        Ended ended;
    };
    struct Outcome {
        Ended ended;
        base::Status status;
    };

    void run(const std::stop_token& stop);

    std::mutex m_mutex;  ///< over what follows
    std::condition_variable_any m_changed;
    std::deque<Task> m_waiting;
    bool m_isWriting = false;
    std::deque<Outcome> m_outcomes;  ///< not reported yet
    std::jthread m_thread;           ///< last, so that it ends before what it uses
};

}  // namespace ui
