#pragma once

#include <filesystem>
#include <memory>
#include <string_view>
#include <vector>

#include "model/base/progress.h"
#include "model/base/result.h"
#include "model/base/stopwatch.h"
#include "model/board/document.h"
#include "model/formats/common/archive.h"
#include "model/formats/common/form_part.h"
#include "model/formats/common/read_options.h"

/// Gerber jobs: images (X1 to X3), Excellon and XNC drills, IPC-D-356 netlists, job files and pick-and-place files, as
/// a folder, an archive or a single file.
namespace model::gerber {

/// The job in the archive, if files are named like those of one and there are images or drills by their content, with
/// how many there are.
[[nodiscard]] std::vector<formats::FormPart> jobsIn(const formats::Archive& archive);
/// Does a file begin like an image, drills or a job file?
[[nodiscard]] bool looksLikeFile(std::string_view head, const std::filesystem::path& path);

/// Reads the board of a job that `options.step` names, or else the one with most copper layers. `name` stands in
/// messages. Nets are those of the images (X2), else a netlist's, else they follow from the copper alone. Errors:
/// BadInput when there is nothing to draw; BadUsage when there is no such board (the text lists those there are);
/// Cancelled. Everything else is in Document::diagnostics.
[[nodiscard]] base::Result<std::shared_ptr<const Document>> readJob(
    const formats::Archive& archive, const std::filesystem::path& name, const formats::ReadOptions& options,
    const Diagnostics& diagnostics, base::Progress& progress, const base::Stopwatch& reading = {});
/// The same for a file alone; for a job file all files beside it.
[[nodiscard]] base::Result<std::shared_ptr<const Document>> readFileAlone(const std::filesystem::path& path,
                                                                          const formats::ReadOptions& options,
                                                                          base::Progress& progress,
                                                                          const base::Stopwatch& reading = {});

}  // namespace model::gerber
