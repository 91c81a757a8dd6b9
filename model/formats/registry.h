#pragma once

#include <filesystem>
#include <memory>

#include "model/base/progress.h"
#include "model/base/result.h"
#include "model/board/document.h"
#include "model/formats/common/read_options.h"

namespace model {

/// Opens a board of any known format: an ODB++ job (folder, .tgz, .tar.gz, .tar, .zip) or the paper's text format.
/// Errors: BadInput with the reason in plain words when the input is missing, is no board or cannot be unpacked;
/// Cancelled. A bad record inside a readable job is no error: it is listed in Document::diagnostics.
[[nodiscard]] base::Result<std::shared_ptr<const Document>> readBoard(const std::filesystem::path& path,
                                                                      const ReadOptions& options,
                                                                      base::Progress& progress);

}  // namespace model
