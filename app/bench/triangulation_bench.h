#pragma once

#include <string>
#include <vector>

#include "app/common/exit_code.h"
#include "model/formats/registry.h"

namespace app {

struct TriangulationBenchArguments {
    std::vector<std::string> boards;
    model::ReadOptions reading{};  ///< of the boards
    bool asJson = false;
    std::vector<std::string> triangulators;  ///< empty: all there are
    std::vector<int> threads = {1, 0};       ///< 0: all cores
    int repeats = 3;
    std::vector<std::string> sets;  ///< empty: all; "none": only the boards
    bool withHuge = false;
    bool hasStages = false;  ///< times the kernels of the device by themselves too
};

/// `copperscope bench --triangulation [BOARD...]`: every triangulator over the areas of the boards and over generated
/// sets, in one run; a table or JSON on stdout. Returns OutputFailed's if triangulators disagree or the
/// verifier finds a fault.
[[nodiscard]] Outcome runTriangulationBench(const TriangulationBenchArguments& arguments);

}  // namespace app
