// How fast the exact outlines of all elements of a board are made: shells_bench BOARD [STEP]. Prints, by kind of
// element, how many there are, their regions and edges, those with a problem, and elements per second of one processor.

#include <array>
#include <cstdio>
#include <ctime>

#include "model/formats/registry.h"
#include "model/solids/shells/element_shells.h"

namespace {

struct Sum {
    std::size_t elements = 0;
    std::size_t regions = 0;
    std::size_t edges = 0;
    std::size_t problems = 0;
    double seconds = 0.0;
};

void measure(const model::Document& document, model::ElementKind kind, Sum& sum) {
    const std::clock_t start = std::clock();
    for (std::uint32_t row = 0; row < document.elements.size(); ++row) {
        if (document.elements.kind[row] != kind) {
            continue;
        }
        const model::ElementOutlines outlines = model::outlinesOf(document, model::ElementId{row});
        ++sum.elements;
        sum.regions += outlines.regions.size();
        sum.problems += outlines.problem.empty() ? 0 : 1;
        for (const model::EdgeLoops& region : outlines.regions) {
            sum.edges += region.edges.size();
        }
    }
    sum.seconds = static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
}

}  // namespace

int main(int argc, char** argv) {
    if (argc < 2) {
        std::fprintf(stderr, "usage: shells_bench BOARD [STEP]\n");
        return 1;
    }
    base::Progress progress;
    const auto board = model::readBoard(argv[1], {argc > 2 ? argv[2] : ""}, progress);
    if (!board) {
        std::fprintf(stderr, "shells_bench: %s cannot be read\n", argv[1]);
        return 2;
    }
    constexpr std::array<const char*, model::kElementKindCount> kNames{"lines", "arcs", "circles", "trails", "areas"};
    for (std::size_t kind = 0; kind < kNames.size(); ++kind) {
        Sum sum;
        measure(**board, static_cast<model::ElementKind>(kind), sum);
        std::printf("%-8s %7zu, %7zu regions, %8zu edges, %4zu with a problem, %.3f s, %.0f per second\n", kNames[kind],
                    sum.elements, sum.regions, sum.edges, sum.problems, sum.seconds,
                    static_cast<double>(sum.elements) / (sum.seconds > 0.0 ? sum.seconds : 1e-6));
    }
    return 0;
}
