#pragma once

#include <string>
#include <vector>

#include "model/formats/common/file_tree.h"

namespace model::odb {

/// The job inside an archive: the folder that holds both `matrix/` and `steps/`, at whatever depth (odb-notes,
/// Container). The shallowest one wins: jobs may carry copies of others in their user folder. Errors: BadInput when no
/// folder of the archive is a job.
[[nodiscard]] base::Result<formats::FileTree> findJob(const formats::Archive& archive);

/// Folders of further jobs that lie beside that one, in lower case; not those in it.
[[nodiscard]] std::vector<std::string> otherJobs(const formats::Archive& archive);

}  // namespace model::odb
