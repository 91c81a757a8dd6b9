// tri_bench [--huge] [--repeats N] [--json FILE] [SET...]: all triangulators over the generated sets in one run. Prints
// a table; fails if the triangulators disagree or the verifier finds a fault.
#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <string>
#include <thread>
#include <vector>

#include "tri/bench/run.h"

namespace {

struct Arguments {
    bool withHuge = false;
    int repeats = 3;
    std::string jsonPath;
    std::vector<std::string> sets;
};

Arguments parse(int argc, char** argv) {
    Arguments arguments;
    for (int i = 1; i < argc; ++i) {
        const std::string word = argv[i];
        if (word == "--huge") {
            arguments.withHuge = true;
        } else if (word == "--repeats" && i + 1 < argc) {
            arguments.repeats = std::max(1, std::atoi(argv[++i]));
        } else if (word == "--json" && i + 1 < argc) {
            arguments.jsonPath = argv[++i];
        } else {
            arguments.sets.push_back(word);
        }
    }
    return arguments;
}

bool areAllEqual(const std::vector<tri::bench::SetReport>& reports) {
    return std::ranges::all_of(reports, [](const tri::bench::SetReport& report) {
        return std::ranges::all_of(report.runs, [&](const tri::bench::Run& run) {
            return run.isVerified && run.hash == report.runs.front().hash;
        });
    });
}

}  // namespace

int main(int argc, char** argv) {
    const Arguments arguments = parse(argc, argv);
    tri::bench::Options options;
    options.repeats = arguments.repeats;
    std::vector<tri::bench::SetReport> reports;
    for (const tri::bench::Set& set : tri::bench::standardSets(arguments.withHuge)) {
        if (arguments.sets.empty() || std::ranges::find(arguments.sets, set.name) != arguments.sets.end()) {
            reports.push_back(tri::bench::measure(set, options));
        }
    }
    std::fputs(tri::bench::toTable(reports).c_str(), stdout);
    if (!arguments.jsonPath.empty()) {
        const std::string device = std::to_string(std::thread::hardware_concurrency()) + " processor cores";
        std::ofstream(arguments.jsonPath) << tri::bench::toJson(reports, device, "");
    }
    return areAllEqual(reports) ? 0 : 1;
}
