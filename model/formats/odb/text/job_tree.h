#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "model/formats/common/file_tree.h"

namespace model::odb {

/// The job inside an archive: the folder that holds both `matrix/` and `steps/`, at whatever depth (odb-notes,
/// Container). The shallowest one wins: jobs may carry copies of others in their user folder. Errors: BadInput when no
/// folder of the archive is a job.
[[nodiscard]] base::Result<formats::FileTree> findJob(const formats::Archive& archive);

/// Does the file lie in one of the folders that make up a job, whichever of the archive? What lies beside those is none
/// of its files.
[[nodiscard]] bool isOfJob(const formats::Archive& archive, std::string_view path);

/// Folders of further jobs that lie beside that one, in lower case; not those in it.
[[nodiscard]] std::vector<std::string> otherJobs(const formats::Archive& archive);

}  // namespace model::odb
