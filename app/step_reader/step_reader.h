#pragma once

#include <filesystem>
#include <memory>

#include "app/verify/step_file.h"

namespace app {

/// What the module offers, under its plain name. OpenCASCADE is twenty libraries, which take longer to load than most
/// boards take to read; so the program loads them where a STEP file is to be read, and not whenever it starts.
extern "C" void readStepFile(const std::filesystem::path& path, bool isStrict,
                             base::Result<std::unique_ptr<StepFile>>& result);

}  // namespace app
