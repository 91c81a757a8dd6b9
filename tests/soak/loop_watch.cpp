#include "tests/soak/loop_watch.h"

#include <execinfo.h>
#include <pthread.h>
#include <unistd.h>

#include <QEvent>
#include <QGuiApplication>
#include <QWindow>
#include <algorithm>
#include <chrono>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <fstream>

#include "tests/soak/action_log.h"
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
#include <sanitizer/common_interface_defs.h>
#endif

namespace soak {

namespace {

constexpr std::chrono::milliseconds kEvery{5};

std::int64_t nowNs() {
    return std::chrono::steady_clock::now().time_since_epoch().count();
}

/// How long this thread of ours has waited for a core since it began; 0 where the kernel does not tell.
std::int64_t waitedForCoreNs(int thread) {
    std::ifstream file("/proc/self/task/" + std::to_string(thread) + "/schedstat");
    std::int64_t ran = 0;
    std::int64_t waited = 0;
    return file >> ran >> waited ? waited : 0;
}

/// Says on stderr what the thread that takes the signal is doing.
void printStack(int) {
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
    __sanitizer_print_stack_trace();
#else
    void* frames[64];
    ::backtrace_symbols_fd(frames, ::backtrace(frames, 64), STDERR_FILENO);
#endif
}

bool isAnyWindowSeen() {
    return std::ranges::any_of(QGuiApplication::topLevelWindows(), &QWindow::isVisible);
}

std::string firstWord(std::string_view text) {
    return std::string(text.substr(0, text.find(' ')));
}

}  // namespace

LoopWatch::LoopWatch()
    : m_thread(::gettid()), m_loop(::pthread_self()), m_watcher([this](const std::stop_token& stop) { watch(stop); }) {
    std::signal(SIGUSR2, printStack);
}

LoopWatch::~LoopWatch() {
    m_watcher.request_stop();
    m_watcher.join();
    QCoreApplication::removePostedEvents(this);
}

void LoopWatch::watch(const std::stop_token& stop) {
    bool isStackPrinted = false;
    for (; !stop.stop_requested(); std::this_thread::sleep_for(kEvery)) {
        const std::int64_t sent = m_sentNs;
        if (sent == 0) {
            isStackPrinted = false;
            m_waitedNs = waitedForCoreNs(m_thread);
            m_sentNs = nowNs();
            QCoreApplication::postEvent(this, new QEvent(QEvent::User), Qt::HighEventPriority);
        } else if (nowNs() - sent > std::int64_t{kHungMs} * 1'000'000) {
            ActionLog::instance().add("hung: the window does not answer any more");
            std::abort();
        } else if (!isStackPrinted && static_cast<double>(nowNs() - sent) / 1e6 > m_limitMs) {
            isStackPrinted = true;
            (void)::pthread_kill(m_loop, SIGUSR2);
        }
    }
}

bool LoopWatch::event(QEvent* event) {
    if (event->type() != QEvent::User) {
        return QObject::event(event);
    }
    const std::int64_t withoutCore = waitedForCoreNs(m_thread) - m_waitedNs;
    const double ms = static_cast<double>(std::max<std::int64_t>(0, nowNs() - m_sentNs - withoutCore)) / 1e6;
    m_sentNs = 0;
    if (!isAnyWindowSeen()) {
        m_longestEndMs = std::max(m_longestEndMs, ms);
        return true;
    }
    const std::string doing(ActionLog::instance().current());
    Stalls& stalls = m_stalls[firstWord(doing)];
    stalls.longestMs = std::max(stalls.longestMs, ms);
    if (ms > m_limitMs) {
        ++stalls.overLimit;
        std::fprintf(stderr, "soak: %.0f ms without an answer: %s\n", ms, doing.c_str());
    }
    return true;
}

LoopWatch::Stalls LoopWatch::all() const {
    Stalls all;
    for (const auto& [name, stalls] : m_stalls) {
        all.longestMs = std::max(all.longestMs, stalls.longestMs);
        all.overLimit += stalls.overLimit;
    }
    return all;
}

}  // namespace soak
