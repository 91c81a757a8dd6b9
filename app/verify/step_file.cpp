#include "app/verify/step_file.h"

#include <dlfcn.h>

#include <optional>
#include <string>

#include "app/common/beside_program.h"
#include "app/common/temporary_folder.h"

namespace app {
namespace {

using Read = void (*)(const std::filesystem::path&, const std::filesystem::path&, const base::Progress&,
                      base::Result<std::unique_ptr<StepFile>>&);

/// What the module offers.
struct Reader {
    Read read = nullptr;
};

/// The module stays loaded until the program ends.
base::Result<Reader> loadedReader() {
    const std::filesystem::path module = besideProgram(COPPERSCOPE_MODULES "/step_reader.so");
    void* const loaded = ::dlopen(module.c_str(), RTLD_NOW | RTLD_LOCAL);
    const auto reads = loaded != nullptr ? reinterpret_cast<Read>(::dlsym(loaded, "readStepFile")) : nullptr;
    if (reads == nullptr) {
        return base::Error{base::ErrorCode::DeviceFailed,  // as a graphics device that is not there
                           std::string("STEP files cannot be read here: ") + ::dlerror() +
                               " (builds need OpenCASCADE for it; Debian: libocct-data-exchange-dev)"};
    }
    return Reader{reads};
}

}  // namespace

base::Status StepFile::checkReader() {
    const base::Result<Reader> reader = loadedReader();
    return reader ? base::Status(base::Done{}) : base::Status(reader.error());
}

base::Result<std::unique_ptr<StepFile>> StepFile::read(const std::filesystem::path& path, bool isStrict,
                                                       base::Progress& progress) {
    progress.beginPhase("Reading solids");
    ASSIGN_OR_RETURN(const Reader reader, loadedReader());
    std::optional<TemporaryFolder> strictIn;
    if (isStrict) {
        ASSIGN_OR_RETURN(TemporaryFolder folder, TemporaryFolder::make());
        strictIn.emplace(std::move(folder));
    }
    base::Result<std::unique_ptr<StepFile>> result(nullptr);
    reader.read(path, strictIn ? strictIn->path() : std::filesystem::path(), progress, result);
    return result;
}

}  // namespace app
