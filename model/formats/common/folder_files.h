#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "model/base/progress.h"
#include "model/base/result.h"
#include "model/board/diagnostics.h"

namespace model::formats {

/// A regular file somewhere below a folder.
struct FolderFile {
    std::string path;              ///< below the folder, with slashes
    std::filesystem::path source;  ///< where it is read from
    std::uint64_t size = 0;
};

/// All files below a folder, in the order of their paths; once there are more than `most`, or it is cancelled, those
/// that were found so far. Links are followed. A folder that several names lead to is read once, by its own name if it
/// has one below `folder`; folders that hold `folder` itself are not. What cannot be read, links to nothing, pipes and
/// devices are left out with an error in the diagnostics, a note where their names begin with a dot: those are of
/// programs, not of the job. Errors: BadInput where the folder itself cannot be read.
[[nodiscard]] base::Result<std::vector<FolderFile>> filesBelow(const std::filesystem::path& folder, std::size_t most,
                                                               base::Progress& progress, Diagnostics& diagnostics);

}  // namespace model::formats
