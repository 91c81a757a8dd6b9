#pragma once

#include <filesystem>
#include <vector>

#include "model/base/result.h"
#include "model/formats/common/read_options.h"
#include "model/formats/gerber/board_groups.h"
#include "model/formats/gerber/job_files.h"

namespace model::gerber {

/// The files of a job once it is settled what each of them draws, and which board it belongs to.
struct AssignedFiles {
    std::vector<ReadFile> files;     ///< all of the job, also those that are ignored
    std::vector<BoardFiles> boards;  ///< at least one
    Diagnostics diagnostics;         ///< of the layer map
};

/// Takes what attributes, job files, comments, names and content say, and over that what a layer map says: the one of
/// the options, else the one beside `path`, if there is one. Errors: BadInput when there is no image and no drill file,
/// or when the map of the options cannot be read.
[[nodiscard]] base::Result<AssignedFiles> assignFiles(std::vector<ReadFile> files, const std::filesystem::path& path,
                                                      const formats::ReadOptions& options);
/// The same without any layer map.
[[nodiscard]] base::Result<AssignedFiles> assignWithoutMap(std::vector<ReadFile> files,
                                                           const std::filesystem::path& path);

}  // namespace model::gerber
