// How fast the exact outlines of all elements of a board are made: shells_bench BOARD [STEP]. Prints, by kind of
// element, how many there are, their regions and edges, those with a problem, and elements per second of one processor;
// then the copper of all nets, merged by net and layer.

#include <array>
#include <cstdio>
#include <ctime>
#include <map>
#include <vector>

#include "model/formats/registry.h"
#include "model/solids/shells/element_shells.h"
#include "model/solids/shells/merged_shells.h"

namespace {

/// By net and copper layer.
std::vector<std::vector<model::ElementId>> copperOf(const model::Document& document) {
    std::map<std::pair<std::uint32_t, std::uint32_t>, std::vector<model::ElementId>> sorted;
    for (std::uint32_t row = 0; row < document.elements.size(); ++row) {
        const model::LayerId layer = document.elements.layer[row];
        const model::NetId net = document.elements.net[row];
        if (document.layer(layer).isCopper() && net.isValid()) {
            sorted[{layer.row(), net.row()}].push_back(model::ElementId{row});
        }
    }
    std::vector<std::vector<model::ElementId>> copper;
    for (auto& [key, elements] : sorted) {
        copper.push_back(std::move(elements));
    }
    return copper;
}

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

/// The copper of every net on every layer as few solids.
void measureMerged(const model::Document& document) {
    std::size_t elements = 0;
    std::size_t shells = 0;
    std::size_t edges = 0;
    std::size_t apart = 0;
    const std::clock_t start = std::clock();
    for (const std::vector<model::ElementId>& copper : copperOf(document)) {
        const model::MergedShells merged = model::mergedShells(document, copper);
        elements += copper.size();
        shells += merged.shells.size();
        apart += merged.apart;
        for (const model::Shell& shell : merged.shells) {
            edges += shell.outline.edges.size();
        }
    }
    std::printf("merged   %7zu, %7zu regions, %8zu edges, %4zu apart, %.3f s\n", elements, shells, edges, apart,
                static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC);
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
    measureMerged(**board);
    return 0;
}
