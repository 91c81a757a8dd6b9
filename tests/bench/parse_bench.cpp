// How fast the text of a features file is parsed: parse_bench FILE [REPEATS]. FILE is an unpacked features file; the
// largest of the test boards is layer f.fab of jetson-agx-thor-baseboard. Prints MB per second of processor time, which
// other programs on the machine change little; best and median of the repeats.

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

#include "model/formats/odb/features/features.h"

int main(int argc, char** argv) {
    if (argc < 2) {
        std::fprintf(stderr, "usage: parse_bench FEATURES_FILE [REPEATS]\n");
        return 1;
    }
    std::ifstream file(argv[1], std::ios::binary);
    const std::string text{std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
    if (text.empty()) {
        std::fprintf(stderr, "parse_bench: %s cannot be read or is empty\n", argv[1]);
        return 2;
    }
    const int repeats = std::max(argc > 2 ? std::atoi(argv[2]) : 7, 1);
    std::vector<double> rates;
    std::size_t features = 0;
    for (int i = 0; i < repeats; ++i) {
        const std::clock_t start = std::clock();
        model::Diagnostics diagnostics;
        features = model::odb::parseFeatures(text, argv[1], model::odb::Unit::Inch, diagnostics).features.size();
        const double taken = static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
        rates.push_back(static_cast<double>(text.size()) / 1e6 / std::max(taken, 1e-6));
    }
    std::ranges::sort(rates);
    std::printf("%.1f MB, %zu features: best %.0f MB/s, median %.0f MB/s\n", static_cast<double>(text.size()) / 1e6,
                features, rates.back(), rates[rates.size() / 2]);
    return 0;
}
