#include "tests/places.h"

#include <cstdlib>

namespace locations {

const char* const kSample = COPPERSCOPE_SAMPLE;
const char* const kTestData = COPPERSCOPE_TEST_DATA;
const char* const kBoards = COPPERSCOPE_BOARDS;
const char* const kFuzzCorpus = COPPERSCOPE_FUZZ_CORPUS;
const char* const kProgram = COPPERSCOPE_PROGRAM;

bool isThorough() {
    return std::getenv("COPPERSCOPE_THOROUGH") != nullptr;
}

}  // namespace locations
