// How fast boards of KiCad are read: kicad_bench FILE.kicad_pcb [REPEATS]. Prints MB per second of processor time,
// which other programs on the machine change little, best and median of the repeats: of the text alone, cut into items
// and trees, and of all until the job is drawn.

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <fstream>
#include <functional>
#include <iterator>
#include <string>
#include <vector>

#include "model/formats/kicad/board_drawing.h"
#include "model/formats/kicad/text/tree.h"

namespace {

void measure(const char* what, const std::string& text, int repeats, const std::function<std::size_t()>& work) {
    std::vector<double> rates;
    std::size_t count = 0;
    for (int i = 0; i < repeats; ++i) {
        const std::clock_t start = std::clock();
        count = work();
        const double taken = static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
        rates.push_back(static_cast<double>(text.size()) / 1e6 / std::max(taken, 1e-6));
    }
    std::ranges::sort(rates);
    std::printf("%s: %.1f MB, %zu: best %.0f MB/s, median %.0f MB/s\n", what, static_cast<double>(text.size()) / 1e6,
                count, rates.back(), rates[rates.size() / 2]);
}

std::size_t itemsOf(const std::string& text) {
    model::Diagnostics diagnostics;
    model::kicad::BoardItems items(text, "board", diagnostics);
    model::kicad::Item item;
    std::size_t count = 0;
    while (items.next(item)) {
        ++count;
    }
    return count;
}

std::size_t featuresOf(const std::string& text) {
    base::Progress progress;
    const auto job = model::kicad::drawBoard(text, "board", {}, progress);
    std::size_t count = 0;
    if (job) {
        for (const auto& features : job->steps[0].features) {
            count += features.size();
        }
    }
    return count;
}

}  // namespace

int main(int argc, char** argv) {
    if (argc < 2) {
        std::fprintf(stderr, "usage: kicad_bench BOARD [REPEATS]\n");
        return 1;
    }
    std::ifstream file(argv[1], std::ios::binary);
    const std::string text{std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
    if (text.empty()) {
        std::fprintf(stderr, "kicad_bench: %s cannot be read or is empty\n", argv[1]);
        return 2;
    }
    const int repeats = std::max(argc > 2 ? std::atoi(argv[2]) : 7, 1);
    measure("items", text, repeats, [&] { return itemsOf(text); });
    measure("features", text, repeats, [&] { return featuresOf(text); });
    return 0;
}
