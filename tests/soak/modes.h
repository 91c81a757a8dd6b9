#pragma once

#include <cstdint>
#include <filesystem>
#include <vector>

namespace soak {

struct Options {
    std::vector<std::filesystem::path> boards;  ///< at least one
    std::uint64_t seed = 1;
    double seconds = 0.0;      ///< of random use; 0: as long as the steps last
    std::size_t count = 0;     ///< steps, cancels or cycles; 0: as long as the time lasts
    bool withFaults = false;   ///< devices are lost and run out of memory
    double mostStallMs = 0.0;  ///< a longer one is a failure; 0: they are reported
};

/// Each makes a window, uses it, writes what it saw to stdout, and says whether all was well. What was not is on
/// stderr. Random use: actions drawn from the table, see actions.h.
[[nodiscard]] bool useAtRandom(const Options& options);
/// Loads, exports, checks and searches are stopped at random moments: nothing is left of them, and all is as before.
[[nodiscard]] bool cancelAtRandom(const Options& options);
/// Boards and windows are opened and closed: nothing grows.
[[nodiscard]] bool openAndClose(const Options& options);

}  // namespace soak
