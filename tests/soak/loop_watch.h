#pragma once

#include <pthread.h>

#include <QObject>
#include <atomic>
#include <map>
#include <string>
#include <thread>

namespace soak {

/// How long the event loop of this thread needs to answer. A thread of its own sends it an event, again and again, and
/// takes the time until it comes; the time in which the loop's thread wanted to run and the machine had no core for it
/// is left out, where the kernel tells. Once its window is closed nobody waits for what is freed then: that is taken
/// apart. A loop that does not answer for `kHungMs` is hung: the last actions are written and the program aborts.
class LoopWatch : public QObject {
    Q_OBJECT

public:
    static constexpr int kHungMs = 120'000;

    LoopWatch();
    ~LoopWatch() override;

    struct Stalls {
        double longestMs = 0.0;
        std::size_t overLimit = 0;
    };
    /// What is more than this counts in Stalls::overLimit, and is said on stderr, with what the loop's thread was doing
    /// when it was.
    void setLimit(double ms) { m_limitMs = ms; }
    /// By what was being done (the first word of ActionLog::current).
    [[nodiscard]] const std::map<std::string, Stalls>& stalls() const { return m_stalls; }
    [[nodiscard]] Stalls all() const;
    /// The longest that a window took to end once it was gone from the screen.
    [[nodiscard]] double longestEndMs() const { return m_longestEndMs; }

protected:
    bool event(QEvent* event) override;

private:
    void watch(const std::stop_token& stop);

    int m_thread;      ///< of the loop
    pthread_t m_loop;  ///< likewise
    std::atomic<double> m_limitMs = 250.0;
    std::map<std::string, Stalls> m_stalls;
    double m_longestEndMs = 0.0;
    std::atomic<std::int64_t> m_sentNs = 0;  ///< 0: answered
    std::atomic<std::int64_t> m_waitedNs = 0;
    std::jthread m_watcher;
};

}  // namespace soak
