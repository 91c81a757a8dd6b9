#pragma once

#include <filesystem>
#include <memory>
#include <vector>

#include "model/base/progress.h"
#include "model/base/result.h"
#include "model/base/stopwatch.h"
#include "model/board/document.h"
#include "model/formats/common/form_part.h"
#include "model/formats/common/read_options.h"

namespace model::formats {
class Archive;
}

/// ODB++ v7 and v8 jobs. What the readers rely on beyond the format's description is in docs/odb-notes.md, cited here
/// as "odb-notes" with the section.
namespace model::odb {

/// The job in the archive, if there is one (a folder with matrix/matrix and steps/), with what its matrix says.
[[nodiscard]] std::vector<formats::FormPart> jobsIn(const formats::Archive& archive);

/// Reads the step of a job that `options` names. `name` stands in messages and, without its ending, for a job that does
/// not name itself; `diagnostics` is what the unpacking had to say; `reading` runs since it began. Errors: BadInput
/// when the archive holds no job; BadUsage when the step does not exist (the text lists those that do); Cancelled.
/// Everything else is in Document::diagnostics.
[[nodiscard]] base::Result<std::shared_ptr<const Document>> readJob(
    const formats::Archive& archive, const std::filesystem::path& name, const formats::ReadOptions& options,
    const Diagnostics& diagnostics, base::Progress& progress, const base::Stopwatch& reading = {});

}  // namespace model::odb
