#pragma once

#include <filesystem>
#include <memory>

#include "app/verify/step_file.h"

namespace app {

/// What the module offers, under its plain name. OpenCASCADE is twenty libraries, which take longer to load than most
/// boards take to read; so the program loads them where a STEP file is to be read, and not whenever it starts. With an
/// empty folder to write settings into, `strictIn`, it reads strictly (StepFile::read); no path: it does not.
extern "C" void readStepFile(const std::filesystem::path& path, const std::filesystem::path& strictIn,
                             const base::Progress& progress, base::Result<std::unique_ptr<StepFile>>& result);

}  // namespace app
