#pragma once

#include <string>
#include <variant>
#include <vector>

#include "app/bench/bench_command.h"
#include "app/bench/triangulation_bench.h"
#include "app/commands/clearance_command.h"
#include "app/commands/generate_command.h"
#include "app/commands/info_command.h"
#include "app/commands/measure_command.h"
#include "app/commands/render_command.h"
#include "app/commands/section_command.h"

namespace app {

struct WorkbenchArguments {
    std::string path;  ///< empty: the bundled sample
    std::string step;
    std::vector<std::string> thicknesses;  ///< as BoardArguments, and so the rest
    bool noSession = false;
    bool inferNets = false;
};

/// The process should end at once with this code: help was printed, or the arguments make no sense (and were
/// explained).
struct Quit {
    int code = 0;
};

using Command = std::variant<WorkbenchArguments, InfoArguments, RenderArguments, GenerateArguments, BenchArguments,
                             TriangulationBenchArguments, ClearanceArguments, SectionArguments, MeasureArguments, Quit>;

/// Understands the command line of docs/command-line.md.
[[nodiscard]] Command parseCommandLine(int argc, char** argv);

}  // namespace app
