#pragma once

#include <filesystem>
#include <memory>
#include <string_view>

#include "model/base/progress.h"
#include "model/base/result.h"
#include "model/board/document.h"

/// The text format of the paper's published models (t1.txt): layers of lines and shapes in mil, with their heights; and
/// a record of ours for NURBS edges of shapes (docs/paper-format.md).
namespace model::paper {

/// Does the text begin like a model of the paper?
[[nodiscard]] bool looksLikeModel(std::string_view head);

/// Reads a model. Elements are classed as in the paper's Table 3: a LINE record of one segment is a Line or an Arc, of
/// several a Trail; a SHAPE of two circles is a Circle; every other SHAPE an Area. Each group of one height and
/// thickness becomes a layer. The file names no nets, no outline and no units (they are mil). Errors: BadInput when the
/// text holds no layer; Cancelled. Records that break the grammar are listed in the diagnostics and left out.
[[nodiscard]] base::Result<std::shared_ptr<const Document>> readModel(std::string_view text,
                                                                      const std::filesystem::path& path,
                                                                      base::Progress& progress);

}  // namespace model::paper
