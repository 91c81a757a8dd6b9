#pragma once

#include <array>
#include <atomic>
#include <cstddef>
#include <string_view>

namespace soak {

/// The last actions, for whoever wants to know what led to a failure. From `watchFailures` on they are written to
/// stderr when the program is ended by a signal (a crash, an abort of a sanitizer, of Qt or of the validation layer, a
/// limit of time). One for the process; written by one thread.
class ActionLog {
public:
    static constexpr std::size_t kKept = 50;

    static ActionLog& instance();

    /// `replay`: the command that does the same again.
    void watchFailures(std::string_view replay);
    /// Long texts are cut.
    void add(std::string_view action);
    /// The one under way; empty before the first.
    [[nodiscard]] std::string_view current() const;
    /// Writes all that is kept, the oldest first. Safe in signal handlers.
    void print() const;

private:
    static constexpr std::size_t kMostChars = 160;
    using Line = std::array<char, kMostChars>;

    std::array<Line, kKept> m_lines{};
    Line m_replay{};
    std::atomic<std::size_t> m_count = 0;
};

}  // namespace soak
