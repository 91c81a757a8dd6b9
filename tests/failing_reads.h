#pragma once

#include <cstddef>

/// A disk that can no longer be read: reads of regular files, by this program and its C++ and archive libraries, that
/// end in EIO. Reads of the C library for itself are not among them.
class FailingReads {
public:
    /// While it lives, on all threads: the `nth` read from its making fails, 1 being the next, and with `isLasting` all
    /// after it; none with 0.
    explicit FailingReads(std::size_t nth, bool isLasting = true);
    ~FailingReads();
    FailingReads(const FailingReads&) = delete;
    FailingReads& operator=(const FailingReads&) = delete;
    /// Reads of regular files so far, those that failed among them.
    [[nodiscard]] std::size_t reads() const;
};
