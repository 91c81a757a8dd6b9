#include "model/base/parallel.h"

#include <tbb/global_control.h>
#include <tbb/parallel_for.h>

#include <atomic>
#include <new>
#include <stdexcept>

#ifdef COPPERSCOPE_THREAD_SANITIZER
#include <sanitizer/tsan_interface.h>
#endif

namespace base {

namespace {

/// The order that parallel_for guarantees: what the caller did before is seen by every task, what tasks did is seen by
/// the caller after. The thread sanitizer has to be told, because TBB's library is not instrumented; in other builds
/// this is nothing.
class ForkJoin {
public:
#ifdef COPPERSCOPE_THREAD_SANITIZER
    ForkJoin() {
        __tsan_release(&m_fork);
    }
    ~ForkJoin() {
        __tsan_acquire(&m_join);
    }
    void beginTask() {
        __tsan_acquire(&m_fork);
    }
    void endTask() {
        __tsan_release(&m_join);
    }

private:
    char m_fork = 0;
    char m_join = 0;
#else
    void beginTask() {}
    void endTask() {}
#endif
};

}  // namespace

void parallelFor(std::size_t count, const std::function<void(std::size_t)>& task) {
    ForkJoin order;
    std::atomic<bool> hasTaskThrown = false;
    const auto run = [&](const tbb::blocked_range<std::size_t>& range) {
        order.beginTask();
        try {
            for (std::size_t i = range.begin(); i != range.end(); ++i) {
                task(i);
            }
        } catch (...) {
            hasTaskThrown = true;
            throw;
        }
        order.endTask();
    };
    try {
        // Grain 1: our tasks are whole layers or whole areas, far above the cost of a steal.
        tbb::parallel_for(tbb::blocked_range<std::size_t>(0, count, 1), run);
    } catch (const std::runtime_error&) {
        if (hasTaskThrown) {
            throw;
        }
        throw std::bad_alloc();  // TBB found no room for the stack of a thread
    }
}

ThreadLimit::ThreadLimit(int threads)
    : m_control(threads > 0 ? new tbb::global_control(tbb::global_control::max_allowed_parallelism,
                                                      static_cast<std::size_t>(threads))
                            : nullptr) {}

ThreadLimit::~ThreadLimit() {
    delete static_cast<tbb::global_control*>(m_control);
}

}  // namespace base
