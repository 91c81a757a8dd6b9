// How fast Gerber images, drills and netlists are read: gerber_bench FILE [REPEATS]. Prints MB per second of processor
// time, which other programs on the machine change little, best and median of the repeats: of the text alone, cut into
// words and numbers, and of all until the image is there.

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <fstream>
#include <functional>
#include <iterator>
#include <string>
#include <vector>

#include "model/formats/gerber/job_files.h"

namespace {

double measure(const char* what, const std::string& text, int repeats, const std::function<std::size_t()>& work) {
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
    return rates[rates.size() / 2];
}

/// The least that any reader does: every character looked at once, digits made numbers, ends of words counted.
std::size_t wordsOf(const std::string& text) {
    std::size_t words = 0;
    std::uint64_t number = 0;
    std::uint64_t sum = 0;
    for (const char c : text) {
        if (c >= '0' && c <= '9') {
            number = number * 10 + static_cast<std::uint64_t>(c - '0');
        } else {
            sum += number;
            number = 0;
            words += c == '*' || c == '\n' ? 1 : 0;
        }
    }
    return words + (sum == 1 ? 1 : 0);
}

std::size_t objectsOf(const std::string& text, const std::string& name) {
    const model::gerber::ReadFile file = model::gerber::readFile(name, model::formats::Bytes::borrow(text));
    return file.image.features.size() + file.netlist.points.size();
}

}  // namespace

int main(int argc, char** argv) {
    if (argc < 2) {
        std::fprintf(stderr, "usage: gerber_bench FILE [REPEATS]\n");
        return 1;
    }
    std::ifstream file(argv[1], std::ios::binary);
    const std::string text{std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
    if (text.empty()) {
        std::fprintf(stderr, "gerber_bench: %s cannot be read or is empty\n", argv[1]);
        return 2;
    }
    const int repeats = std::max(argc > 2 ? std::atoi(argv[2]) : 7, 1);
    const double raw = measure("words", text, repeats, [&] { return wordsOf(text); });
    const double all = measure("objects", text, repeats, [&] { return objectsOf(text, argv[1]); });
    std::printf("%.1f times the time of the text alone\n", raw / all);
    return 0;
}
