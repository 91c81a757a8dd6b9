#include <malloc.h>

#include <algorithm>
#include <cstdio>
#include <vector>

#include "tests/soak/action_log.h"
#include "tests/soak/driver.h"
#include "tests/soak/modes.h"
#include "tests/soak/resources.h"

namespace soak {

namespace {

/// A cycle may leave this much; what is kept once (lists of fonts, of recent boards) is spread over few cycles.
constexpr double kHeapBytesPerCycle = 16e3;
/// What is mapped and not given back is megabytes, and pages of the heap come and go on a busy machine.
constexpr double kResidentBytesPerCycle = 250e3;
constexpr std::size_t kLeastCycles = 8;

/// The middle of the slopes between all pairs (Theil and Sen): a cycle that happened to end with more or less than the
/// others, as on a machine with other work, does not tilt it.
template <class Value>
double growthPerCycle(const std::vector<Resources>& cycles, const Value& valueOf) {
    std::vector<double> slopes;
    for (std::size_t to = 1; to < cycles.size(); ++to) {
        for (std::size_t from = 0; from < to; ++from) {
            const double rise = static_cast<double>(valueOf(cycles[to])) - static_cast<double>(valueOf(cycles[from]));
            slopes.push_back(rise / static_cast<double>(to - from));
        }
    }
    const auto middle = slopes.begin() + static_cast<std::ptrdiff_t>(slopes.size() / 2);
    std::ranges::nth_element(slopes, middle);
    return *middle;
}

std::string deviceName(Driver& driver) {
    return driver.context().device().caps().name;
}

class Cycles {
public:
    explicit Cycles(const Options& options) : m_options(options), m_driver(options.boards) {}

    bool run() {
        for (std::size_t i = 0; i < std::max(m_options.count, kLeastCycles); ++i) {
            if (!cycle(i)) {
                std::fprintf(stderr, "soak: a board was not opened\n");
                return false;
            }
            m_all.push_back(resourcesNow(m_driver.context().device()));
        }
        const std::size_t warm = m_all.size() / 4;
        m_kept.assign(m_all.begin() + static_cast<std::ptrdiff_t>(warm), m_all.end());
        return print();
    }

private:
    /// A window, in it every board after the other, and the window is closed.
    bool cycle(std::size_t number) {
        ActionLog::instance().add("cycle " + std::to_string(number));
        for (std::size_t board = 0; board < m_driver.boards().size(); ++board) {
            m_driver.open(board);
            if (!m_driver.settle() || !m_driver.hasBoard()) {
                return false;
            }
        }
        m_driver.restart();
        const bool isAtRest = m_driver.settle();
        m_driver.context().device().waitIdle();  // else what was dropped is freed with the next frames
        return isAtRest;
    }

    bool print() {
        const double heap = growthPerCycle(m_kept, [](const Resources& now) { return now.heapBytes; });
        const double resident = growthPerCycle(m_kept, [](const Resources& now) { return now.residentBytes; });
        const auto most = std::ranges::max_element(m_all, {}, &Resources::deviceBytes);
        const auto device = static_cast<double>(most->deviceBytes);
        const double handles = growthPerCycle(m_kept, [](const Resources& now) { return now.handles; });
        const double threads = growthPerCycle(m_kept, [](const Resources& now) { return now.threads; });
        std::printf("cycles: %zu of %zu boards on %s\n", m_all.size(), m_options.boards.size(),
                    deviceName(m_driver).c_str());
        std::printf("first: %s\nwarm: %s\nlast: %s\n", textOf(m_all.front()).c_str(), textOf(m_kept.front()).c_str(),
                    textOf(m_all.back()).c_str());
        std::printf(
            "growth per cycle: %.1f kB resident, %.1f kB heap, %.3f handles, %.3f threads; device: %.1f kB left at "
            "most\n",
            resident / 1e3, heap / 1e3, handles, threads, device / 1e3);
        return isAtMost("the heap grows", heap, kHeapBytesPerCycle) &&
               isAtMost("memory grows", resident, kResidentBytesPerCycle) &&
               isAtMost("device memory is left", device, 0.0) && isAtMost("handles are left open", handles, 0.01) &&
               isAtMost("threads are left", threads, 0.01);
    }

    static bool isAtMost(const char* otherwise, double value, double limit) {
        if (value > limit) {
            std::fprintf(stderr, "soak: %s\n", otherwise);
        }
        return value <= limit;
    }

    const Options& m_options;
    Driver m_driver;
    std::vector<Resources> m_all;
    std::vector<Resources> m_kept;  ///< after the first quarter
};

}  // namespace

bool openAndClose(const Options& options) {
    // Each thread has an arena of its own otherwise, and keeps what was freed there: that fills up for hundreds of
    // cycles, and hides what grows.
    (void)::mallopt(M_ARENA_MAX, 1);
    return Cycles(options).run();
}

}  // namespace soak
