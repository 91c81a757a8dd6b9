// A libFuzzer program for the target that COPPERSCOPE_FUZZ_TARGET names, of a group; scripts/fuzz.sh runs all of them.

#include <cstddef>
#include <cstdint>

#include "model/base/assert.h"
#include "targets.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    static const fuzz::Target* const target = fuzz::findTarget(fuzz::COPPERSCOPE_FUZZ_GROUP(), COPPERSCOPE_FUZZ_TARGET);
    ASSERT(target != nullptr);
    target->run({reinterpret_cast<const char*>(data), size});
    return 0;
}
