#include "model/base/parallel.h"

#include <tbb/global_control.h>
#include <tbb/parallel_for.h>

namespace base {

void parallelFor(std::size_t count, const std::function<void(std::size_t)>& task) {
    // Grain 1: our tasks are whole layers or whole areas, far above the cost of a steal.
    tbb::parallel_for(tbb::blocked_range<std::size_t>(0, count, 1), [&](const tbb::blocked_range<std::size_t>& range) {
        for (std::size_t i = range.begin(); i != range.end(); ++i) {
            task(i);
        }
    });
}

ThreadLimit::ThreadLimit(int threads)
    : m_control(threads > 0 ? new tbb::global_control(tbb::global_control::max_allowed_parallelism,
                                                      static_cast<std::size_t>(threads))
                            : nullptr) {}

ThreadLimit::~ThreadLimit() {
    delete static_cast<tbb::global_control*>(m_control);
}

}  // namespace base
