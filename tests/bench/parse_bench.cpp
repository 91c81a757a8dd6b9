// How fast the text of a features file is parsed: parse_bench FILE [REPEATS]. FILE is an unpacked features file; the
// largest of the test boards is layer f.fab of jetson-agx-thor-baseboard. Prints MB per second of processor time, which
// other programs on the machine change little; best and median of the repeats.

#include "model/formats/odb/features/features.h"
#include "tests/bench/reading_rate.h"

int main(int argc, char** argv) {
    const bench::Reading reading = bench::readingOf("parse_bench", argc, argv);
    bench::measure("features", reading, [&] {
        model::Diagnostics diagnostics;
        return model::odb::parseFeatures(reading.text, argv[1], model::odb::Unit::Inch, diagnostics).features.size();
    });
    return 0;
}
