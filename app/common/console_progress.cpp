#include "app/common/console_progress.h"

#include <unistd.h>

#include <chrono>
#include <cstdio>

namespace app {

ConsoleProgress::ConsoleProgress() {
    if (isatty(STDERR_FILENO) != 0) {
        m_printer = std::thread([this] { show(); });
    }
}

ConsoleProgress::~ConsoleProgress() {
    m_isDone = true;
    if (m_printer.joinable()) {
        m_printer.join();
    }
}

void ConsoleProgress::show() {
    constexpr int kQuietTicks = 10;
    constexpr std::chrono::milliseconds kTick{100};
    bool hasShown = false;
    for (int tick = 0; !m_isDone; ++tick) {
        std::this_thread::sleep_for(kTick);
        if (tick >= kQuietTicks && !m_isDone) {
            std::fprintf(stderr, "\r\033[K%s %3.0f %%", m_progress.phase().c_str(),
                         100.0 * static_cast<double>(m_progress.fraction()));
            hasShown = true;
        }
    }
    if (hasShown) {
        std::fputs("\r\033[K", stderr);
    }
}

}  // namespace app
