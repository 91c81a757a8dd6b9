#include "tests/locations.h"

#include <algorithm>
#include <cstdlib>

namespace fs = std::filesystem;

namespace locations {

const char* const kSample = COPPERSCOPE_SAMPLE;
const char* const kTestData = COPPERSCOPE_TEST_DATA;
const char* const kFuzzCorpus = COPPERSCOPE_FUZZ_CORPUS;
const char* const kProgram = COPPERSCOPE_PROGRAM;

fs::path boards() {
    const char* const named = std::getenv("COPPERSCOPE_BOARDS");
    return named != nullptr ? fs::path(named) : fs::path(kTestData) / "boards";
}

std::vector<fs::path> allBoards() {
    std::vector<fs::path> files = {kSample};
    for (const char* folder : {".", "kicad", "kicad/variants"}) {
        if (!fs::exists(boards() / folder)) {
            continue;
        }
        for (const fs::path& path : fs::directory_iterator(boards() / folder)) {
            const bool isJob = path.extension() == ".tgz" || path.extension() == ".zip";
            if (isJob && path.filename() != files.front().filename()) {
                files.push_back(path);
            }
        }
    }
    std::ranges::sort(files, {}, &fs::path::filename);
    return files;
}

std::vector<fs::path> boardsNamed(std::initializer_list<const char*> names) {
    std::vector<fs::path> found;
    for (const char* name : names) {
        if (std::getenv("COPPERSCOPE_BOARDS") != nullptr || fs::exists(boards() / name)) {
            found.push_back(boards() / name);
        }
    }
    return found;
}

bool isThorough() {
    return std::getenv("COPPERSCOPE_THOROUGH") != nullptr;
}

}  // namespace locations
