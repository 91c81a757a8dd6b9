#include "app/common/interrupt.h"

#include <array>
#include <atomic>
#include <csignal>

#include "app/common/exit_code.h"

namespace app {

namespace {

constexpr std::array kSignals{SIGINT, SIGTERM, SIGHUP};

std::atomic<base::Progress*> s_progress{nullptr};
volatile std::sig_atomic_t s_signal = 0;  // the first that came
std::array<struct sigaction, kSignals.size()> s_before{};

void onSignal(int signal) {
    if (s_signal == 0) {
        s_signal = signal;
    }
    if (base::Progress* progress = s_progress.load()) {
        progress->cancel();
    }
}

bool isIgnored(const struct sigaction& action) {
    return (action.sa_flags & SA_SIGINFO) == 0 && action.sa_handler == SIG_IGN;
}

}  // namespace

Interrupt::Interrupt(base::Progress& progress) {
    s_progress = &progress;
    struct sigaction ours {};
    ours.sa_handler = onSignal;
    ours.sa_flags = SA_RESTART;
    for (std::size_t i = 0; i < kSignals.size(); ++i) {
        ::sigaction(kSignals[i], nullptr, &s_before[i]);
        if (!isIgnored(s_before[i])) {
            ::sigaction(kSignals[i], &ours, nullptr);
        }
    }
}

Interrupt::~Interrupt() {
    for (std::size_t i = 0; i < kSignals.size(); ++i) {
        ::sigaction(kSignals[i], &s_before[i], nullptr);
    }
    s_progress = nullptr;
}

int endAsInterrupted(int code) {
    if (code == kFailed && s_signal != 0) {
        std::signal(s_signal, SIG_DFL);
        std::raise(s_signal);
    }
    return code;
}

}  // namespace app
