// How fast boards of KiCad are read: kicad_bench FILE.kicad_pcb [REPEATS]. Prints MB per second of processor time,
// which other programs on the machine change little, best and median of the repeats: of the text alone, cut into items
// and trees, and of all until the job is drawn.

#include <cstddef>
#include <string>

#include "model/formats/kicad/board_drawing.h"
#include "model/formats/kicad/text/tree.h"
#include "tests/bench/reading_rate.h"

namespace {

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
    const bench::Reading reading = bench::readingOf("kicad_bench", argc, argv);
    bench::measure("items", reading, [&] { return itemsOf(reading.text); });
    bench::measure("features", reading, [&] { return featuresOf(reading.text); });
    return 0;
}
