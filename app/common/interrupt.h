#pragma once

#include "model/base/progress.h"

namespace app {

/// While it lives, the signals that ask a program to end (SIGINT, SIGTERM, SIGHUP) cancel the work instead, so that it
/// leaves no half file. Those that whoever started the program wants ignored (nohup) stay ignored. One at a time.
class Interrupt {
public:
    explicit Interrupt(base::Progress& progress);
    ~Interrupt();
    Interrupt(const Interrupt&) = delete;
    Interrupt& operator=(const Interrupt&) = delete;
};

/// To be asked last: where such a signal came and the work failed for it, the program ends by that signal, so that
/// shells, make and build servers know (a shell shows 128 and the signal's number). Returns `code` otherwise.
[[nodiscard]] int endAsInterrupted(int code);

}  // namespace app
