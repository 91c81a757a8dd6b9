#pragma once

#include <atomic>
#include <thread>

#include "model/base/progress.h"

namespace app {

/// Shows a Progress on stderr while it lives, once the work has taken a second; silent when stderr is no terminal.
class ConsoleProgress {
public:
    ConsoleProgress();
    ~ConsoleProgress();
    ConsoleProgress(const ConsoleProgress&) = delete;
    ConsoleProgress& operator=(const ConsoleProgress&) = delete;

    [[nodiscard]] base::Progress& progress() { return m_progress; }

private:
    void show();

    base::Progress m_progress;
    std::atomic<bool> m_isDone{false};
    std::thread m_printer;
};

}  // namespace app
