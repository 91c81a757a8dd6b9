#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <vector>

namespace base {

/// Calls `task(i)` for every i in [0, count) on all cores and returns when all are done. Tasks are handed out in rising
/// order, so put the largest first. A task writes only to its own slot: results do not depend on the number of threads.
/// What a task throws comes out, of several the first; std::bad_alloc also where a thread finds no room for its stack.
void parallelFor(std::size_t count, const std::function<void(std::size_t)>& task);

/// Rows in falling order of size, equal ones as they were: the order to hand them out in.
[[nodiscard]] std::vector<std::uint32_t> largestFirst(std::size_t count,
                                                      const std::function<std::size_t(std::size_t)>& sizeOf);

/// Limits every parallelFor below it to `threads` while it lives (0 = all cores). For tests that compare 1 and N
/// threads.
class ThreadLimit {
public:
    explicit ThreadLimit(int threads);
    ~ThreadLimit();
    ThreadLimit(const ThreadLimit&) = delete;
    ThreadLimit& operator=(const ThreadLimit&) = delete;

private:
    void* m_control;
};

}  // namespace base
