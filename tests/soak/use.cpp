#include <QElapsedTimer>
#include <QPointer>
#include <cstdio>

#include "tests/soak/action_log.h"
#include "tests/soak/actions.h"
#include "tests/soak/loop_watch.h"
#include "tests/soak/modes.h"
#include "tests/soak/resources.h"

namespace soak {

namespace {

/// What the window said went wrong. In random use some does: names that no net has, thicknesses that are none.
class Errors {
public:
    void listenTo(const ui::Workspace& workspace) {
        QObject::connect(&workspace, &ui::Workspace::errorReported, &workspace, [this](const QString& text) {
            ++m_counts[text.toStdString()];
            ActionLog::instance().add("  the window reports: " + text.toStdString());
        });
    }
    void print() const {
        for (const auto& [text, count] : m_counts) {
            std::printf("reported %zu times: %s\n", count, text.c_str());
        }
    }

private:
    std::map<std::string, std::size_t> m_counts;
};

class RandomUse {
public:
    explicit RandomUse(const Options& options) : m_options(options), m_dice(options.seed), m_driver(options.boards) {
        m_watch.setLimit(options.mostStallMs > 0.0 ? options.mostStallMs : 250.0);
    }

    bool run() {
        const Resources before = resourcesNow(m_driver.context().device());
        QElapsedTimer clock;
        clock.start();
        while (isGoingOn(clock)) {
            step();
        }
        const bool isEnded = m_driver.settle(kEndOfWorkMs);
        m_driver.restart();
        const bool isDown = m_driver.awaitThreads(before.threads + kThreadsOfQt);
        print(static_cast<double>(clock.elapsed()) / 1e3);
        return check(isEnded, "work that does not end") && check(isDown, "threads that do not end") &&
               check(m_driver.unfinishedFiles().empty(), "unfinished files are left") &&
               check(m_driver.context().validationErrors() == 0, "the validation layer complained") &&
               check(m_options.mostStallMs <= 0.0 || m_watch.all().overLimit == 0, "the window stalled");
    }

private:
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
    static constexpr int kEndOfWorkMs = 600'000;  // a PDF of a large board takes minutes
#else
    static constexpr int kEndOfWorkMs = 60'000;
#endif
    static constexpr std::size_t kThreadsOfQt = 16;  // which it keeps: pools, the display's

    [[nodiscard]] bool isGoingOn(const QElapsedTimer& clock) const {
        const bool isInTime =
            m_options.seconds <= 0.0 || static_cast<double>(clock.elapsed()) < m_options.seconds * 1e3;
        return isInTime && (m_options.count == 0 || m_steps < m_options.count);
    }

    /// What is drawn does not depend on what the window did before.
    void step() {
        Dice dice(m_dice.next());
        const Action& action = drawAction(dice, m_options.withFaults);
        ActionLog::instance().add(std::string(action.name) + " (step " + std::to_string(m_steps++) + boardName() + ")");
        if (m_window != &m_driver.window()) {
            m_window = &m_driver.window();
            m_errors.listenTo(m_window->workspace());
        }
        Dice answers(dice.next());
        m_driver.answerAll(answers);
        if (m_driver.hasBoard() || !action.needsBoard) {
            ++m_done[action.name];
            action.run(m_driver, dice);
        }
    }

    /// ", board.tgz"; empty before the first board.
    [[nodiscard]] std::string boardName() {
        const ui::LoadedBoard* board = m_driver.window().workspace().board();
        return board != nullptr ? ", " + board->request.path.filename().string() : "";
    }

    void print(double seconds) const {
        std::printf("random use: %zu steps in %.0f s, seed %llu\n", m_steps, seconds,
                    static_cast<unsigned long long>(m_options.seed));
        for (const auto& [name, count] : m_done) {
            const auto stalls = m_watch.stalls().find(name);
            const LoopWatch::Stalls own = stalls == m_watch.stalls().end() ? LoopWatch::Stalls{} : stalls->second;
            std::printf("  %-12s %6zu times, longest without an answer %7.1f ms, %zu over the limit\n", name.c_str(),
                        count, own.longestMs, own.overLimit);
        }
        m_errors.print();
        std::printf("longest without an answer: %.1f ms, %zu over the limit\n", m_watch.all().longestMs,
                    m_watch.all().overLimit);
        std::printf("longest end of a window that was closed: %.1f ms\n", m_watch.longestEndMs());
    }

    static bool check(bool isWell, const char* otherwise) {
        if (!isWell) {
            std::fprintf(stderr, "soak: %s\n", otherwise);
            ActionLog::instance().print();
        }
        return isWell;
    }

    const Options& m_options;
    Dice m_dice;
    Driver m_driver;
    LoopWatch m_watch;
    Errors m_errors;
    QPointer<TestWindow> m_window;  ///< whose errors are listened to
    std::size_t m_steps = 0;
    std::map<std::string, std::size_t> m_done;
};

}  // namespace

bool useAtRandom(const Options& options) {
    return RandomUse(options).run();
}

}  // namespace soak
