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

/// The exponent of cost ~ elements^exponent by least squares over several boards; 0 for fewer than two different sizes
/// or a cost of 0.
[[nodiscard]] double growthExponent(const std::vector<std::pair<double, double>>& elementsAndCost);

}  // namespace app
