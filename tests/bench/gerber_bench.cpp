// How fast Gerber images, drills and netlists are read: gerber_bench FILE [REPEATS]. Prints MB per second of processor
// time, which other programs on the machine change little, best and median of the repeats: of the text alone, cut into
// words and numbers, and of all until the image is there.

#include <cstdint>
#include <cstdio>
#include <string>

#include "model/formats/gerber/job_files.h"
#include "tests/bench/reading_rate.h"

namespace {

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
    const bench::Reading reading = bench::readingOf("gerber_bench", argc, argv);
    const double raw = bench::measure("words", reading, [&] { return wordsOf(reading.text); });
    const double all = bench::measure("objects", reading, [&] { return objectsOf(reading.text, argv[1]); });
    std::printf("%.1f times the time of the text alone\n", raw / all);
    return 0;
}
