#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "app/bench/bench_board.h"

namespace app {

struct BenchReport {
    std::string device;
    std::vector<BoardResult> boards;
};

/// Keys are stable; lengths of time in ms, sizes in bytes.
[[nodiscard]] nlohmann::ordered_json benchJson(const BenchReport& report);
/// The same as text.
[[nodiscard]] std::string benchTable(const BenchReport& report);

}  // namespace app
