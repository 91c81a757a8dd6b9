#pragma once

#include <filesystem>
#include <memory>

#include "model/base/progress.h"
#include "model/base/result.h"
#include "model/board/document.h"
#include "model/formats/common/read_options.h"

/// ODB++ v7 and v8 jobs. What the readers rely on beyond the format's description is in docs/odb-notes.md, cited here
/// as "odb-notes" with the section.
namespace model::odb {

class Archive;

/// A cheap look at the name and the first bytes: a folder, or a file that is an archive or is named like one. It does
/// not say that the job is sound.
[[nodiscard]] bool looksLikeJob(const std::filesystem::path& path);

/// Reads the step of a job that `options` names. Errors: BadInput when the path is missing, is no archive, ends early,
/// is too large or holds no job; BadUsage when the step does not exist (the text lists those that do); Cancelled.
/// Everything else is in Document::diagnostics.
[[nodiscard]] base::Result<std::shared_ptr<const Document>> readJob(const std::filesystem::path& path,
                                                                    const ReadOptions& options,
                                                                    base::Progress& progress);

/// The same for a job that is already unpacked. `name` stands in messages and, without its ending, for a job that does
/// not name itself; `diagnostics` is what the unpacking had to say.
[[nodiscard]] base::Result<std::shared_ptr<const Document>> readJob(const Archive& archive,
                                                                    const std::filesystem::path& name,
                                                                    const ReadOptions& options,
                                                                    const Diagnostics& diagnostics,
                                                                    base::Progress& progress);

}  // namespace model::odb
