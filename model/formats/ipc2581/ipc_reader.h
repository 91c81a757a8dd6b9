#pragma once

#include <filesystem>
#include <memory>
#include <string_view>
#include <vector>

#include "model/base/progress.h"
#include "model/base/result.h"
#include "model/base/stopwatch.h"
#include "model/formats/common/archive.h"
#include "model/formats/common/form_part.h"
#include "model/formats/common/read_options.h"
#include "model/formats/drawing/drawn_job.h"

/// IPC-2581, revisions A, B and C: one XML file that says all about a board. Read as writers write it, not as the
/// schema has it: sections in any order, references to nothing, pads in Sets or in PadStacks.
namespace model::ipc2581 {

/// Do these first bytes of a text look like IPC-2581?
[[nodiscard]] bool looksLikeIpc2581(std::string_view head);
/// Such files of an archive or folder, packed or not, each with its revision and what wrote it, the newest revision
/// first.
[[nodiscard]] std::vector<formats::FormPart> filesIn(const formats::Archive& archive);

/// What the text says, the step wanted by the options first, else the first one that draws anything itself. `path` is
/// the file's name for messages. Errors: BadInput (no XML, another encoding than UTF-8, a DOCTYPE, no CadData),
/// BadUsage (no such step), Cancelled.
[[nodiscard]] base::Result<formats::DrawnJob> parseJob(std::string_view text, const std::filesystem::path& path,
                                                       const formats::ReadOptions& options, base::Progress& progress);

/// The document of the text, or of the first such file of the archive. Errors: as parseJob; BadInput when the archive
/// has none.
[[nodiscard]] base::Result<std::shared_ptr<const Document>> readJob(
    std::string_view text, const std::filesystem::path& path, const formats::ReadOptions& options,
    const Diagnostics& unpacking, base::Progress& progress, const base::Stopwatch& reading);
[[nodiscard]] base::Result<std::shared_ptr<const Document>> readJob(
    const formats::Archive& archive, const std::filesystem::path& path, const formats::ReadOptions& options,
    const Diagnostics& unpacking, base::Progress& progress, const base::Stopwatch& reading);

}  // namespace model::ipc2581
