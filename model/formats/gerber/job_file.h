#pragma once

#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "model/board/diagnostics.h"
#include "model/board/document.h"

namespace model::gerber {

/// A row of the stackup of a job file, from the top.
struct JobStackRow {
    std::string type;  ///< Copper, Dielectric, SolderMask, Legend …
    std::string name;
    std::optional<double> thicknessNm;
    Material material;  ///< of masks and legends with their colour behind: "Liquid Ink, Green"
};

/// What a Gerber job file (.gbrjob) says: JSON, or Gerber syntax in its oldest form.
struct JobFileFacts {
    std::string name;       ///< of the project
    std::string generator;  ///< "KiCad Pcbnew 9.0.8"
    std::optional<double> boardNm;
    std::map<std::string, std::string, std::less<>> functions;  ///< by name of the file, lower case, without folders
    std::map<std::string, std::string, std::less<>> polarities;
    std::vector<JobStackRow> stackup;
};

[[nodiscard]] bool looksLikeJobFile(std::string_view text);
[[nodiscard]] JobFileFacts parseJobFile(std::string_view text, std::string_view path, Diagnostics& diagnostics);

}  // namespace model::gerber
