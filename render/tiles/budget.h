#pragma once

#include "model/base/stopwatch.h"

namespace render {

/// How long a piece of work may go on from its making, ms; 0: for ever.
class Budget {
public:
    explicit Budget(double ms) : m_ms(ms) {}
    [[nodiscard]] bool isSpent() const { return m_ms > 0.0 && m_watch.milliseconds() >= m_ms; }

private:
    double m_ms;
    base::Stopwatch m_watch;
};

}  // namespace render
