#include "app/verify/step_file.h"

#include <dlfcn.h>

#include <string>

#include "app/common/beside_program.h"

namespace app {
namespace {

using Read = void (*)(const std::filesystem::path&, bool, base::Result<std::unique_ptr<StepFile>>&);

}  // namespace

base::Result<std::unique_ptr<StepFile>> StepFile::read(const std::filesystem::path& path, bool isStrict) {
    const std::filesystem::path module = besideProgram(COPPERSCOPE_MODULES "/step_reader.so");
    void* const loaded = ::dlopen(module.c_str(), RTLD_NOW | RTLD_LOCAL);  // until the program ends
    const auto reads = loaded != nullptr ? reinterpret_cast<Read>(::dlsym(loaded, "readStepFile")) : nullptr;
    if (reads == nullptr) {
        return base::Error{base::ErrorCode::BadUsage,
                           std::string("STEP files cannot be read here: ") + ::dlerror() +
                               " (builds need OpenCASCADE for it; Debian: libocct-data-exchange-dev)"};
    }
    base::Result<std::unique_ptr<StepFile>> result(nullptr);
    reads(path, isStrict, result);
    return result;
}

}  // namespace app
