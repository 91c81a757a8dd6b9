#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <fstream>
#include <functional>
#include <iterator>
#include <string>
#include <vector>

/// What benchmarks of readers share: PROGRAM FILE [REPEATS], MB per second of processor time, which other programs on
/// the machine change little.
namespace bench {

struct Reading {
    std::string text;
    int repeats = 7;
};

/// The file that the arguments name. Ends the program with 1 where they are wrong, with 2 where it cannot be read.
inline Reading readingOf(const char* program, int argc, char** argv) {
    if (argc < 2) {
        std::fprintf(stderr, "usage: %s FILE [REPEATS]\n", program);
        std::exit(1);
    }
    std::ifstream file(argv[1], std::ios::binary);
    Reading reading{{std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()}};
    if (reading.text.empty()) {
        std::fprintf(stderr, "%s: %s cannot be read or is empty\n", program, argv[1]);
        std::exit(2);
    }
    reading.repeats = std::max(argc > 2 ? std::atoi(argv[2]) : reading.repeats, 1);
    return reading;
}

/// Prints the best and the median rate of `work`, which returns how much it found; returns the median.
inline double measure(const char* what, const Reading& reading, const std::function<std::size_t()>& work) {
    const double megabytes = static_cast<double>(reading.text.size()) / 1e6;
    std::vector<double> rates;
    std::size_t count = 0;
    for (int i = 0; i < reading.repeats; ++i) {
        const std::clock_t start = std::clock();
        count = work();
        const double taken = static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
        rates.push_back(megabytes / std::max(taken, 1e-6));
    }
    std::ranges::sort(rates);
    const double median = rates[rates.size() / 2];
    std::printf("%s: %.1f MB, %zu: best %.0f MB/s, median %.0f MB/s\n", what, megabytes, count, rates.back(), median);
    return median;
}

}  // namespace bench
