#pragma once

#include <cstddef>

/// The memory that a test program takes with operator new, counted, and refused where a test says so. What C libraries
/// take, and memory with an alignment of its own, is not among it.
namespace counted {

struct Memory {
    std::size_t allocations = 0;  ///< since the program began
    std::size_t live = 0;         ///< bytes that are taken now
    std::size_t peak = 0;         ///< the most since `resetPeak`
};
[[nodiscard]] Memory memory();
/// The most begins anew with what is taken now.
void resetPeak();

/// Refuses memory (std::bad_alloc) while it lives, on all threads: to the `nth` request from its making, 1 being the
/// next, and with `isLasting` to all after it. Requests by polyclipping are granted: it frees twice what it was about
/// to use when one fails (Clipper::ProcessIntersectList of 6.4.2), and ends the program.
class Refusal {
public:
    Refusal(std::size_t nth, bool isLasting);
    ~Refusal();
    Refusal(const Refusal&) = delete;
    Refusal& operator=(const Refusal&) = delete;
    /// Something was refused.
    [[nodiscard]] bool hasRefused() const;
};

}  // namespace counted
