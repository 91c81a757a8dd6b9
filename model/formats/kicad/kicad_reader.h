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

/// Boards of KiCad 4 to 10: .kicad_pcb, with the .kicad_pro beside it.
namespace model::kicad {

/// The boards among the files, as readBoard prefers them, each with the version that wrote it.
[[nodiscard]] std::vector<formats::FormPart> boardsOf(const formats::Archive& archive);

/// Reads a board from its file; a project of the same name beside it is read too. `before` is what there was to say
/// until then. Errors: BadInput, Cancelled.
[[nodiscard]] base::Result<std::shared_ptr<const Document>> readBoard(const std::filesystem::path& path,
                                                                      const Diagnostics& before,
                                                                      base::Progress& progress,
                                                                      const base::Stopwatch& reading);

/// Reads the board of a project in a folder or an archive: where there are several, the one with a project of the same
/// name, else the first one by name; the others are named in a message. Errors as above.
[[nodiscard]] base::Result<std::shared_ptr<const Document>> readBoard(const formats::Archive& archive,
                                                                      const std::filesystem::path& name,
                                                                      const Diagnostics& unpacking,
                                                                      base::Progress& progress,
                                                                      const base::Stopwatch& reading);

}  // namespace model::kicad
