#pragma once

#include <atomic>
#include <mutex>
#include <string>
#include <string_view>

namespace base {

/// How far a long operation is, in the user's words, and the way to stop it. One side works and reports, any other
/// thread reads and may cancel; all members are safe to call from any thread. Work asks `isCancelled()` at least every
/// few milliseconds and then returns ErrorCode::Cancelled.
class Progress {
public:
    /// Begins a phase, for example "Reading layers"; the fraction goes back to 0.
    void beginPhase(std::string_view phase) {
        const std::scoped_lock lock(m_mutex);
        m_phase = phase;
        m_fraction = 0.0F;
    }
    /// `fraction` of the current phase, 0 to 1.
    void setFraction(float fraction) { m_fraction = fraction; }
    void cancel() { m_cancelled = true; }

    [[nodiscard]] std::string phase() const {
        const std::scoped_lock lock(m_mutex);
        return m_phase;
    }
    [[nodiscard]] float fraction() const { return m_fraction; }
    [[nodiscard]] bool isCancelled() const { return m_cancelled; }

private:
    mutable std::mutex m_mutex;
    std::string m_phase;
    std::atomic<float> m_fraction{0.0F};
    std::atomic<bool> m_cancelled{false};
};

}  // namespace base
