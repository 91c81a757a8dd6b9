#pragma once

#include <map>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "model/board/diagnostics.h"

namespace model::kicad {

/// What a project beside a board (.kicad_pro, from KiCad 6 on) says that a document holds.
struct Project {
    std::map<std::string, std::string, std::less<>> variables;   ///< of texts
    std::map<std::string, std::string, std::less<>> classOfNet;  ///< names as people read them
    std::vector<std::pair<std::string, std::string>>
        classPatterns;  ///< pattern with * and ?, class; the first one holds

    /// The net class of a net, its name as boards write it; "Default" where none is assigned.
    [[nodiscard]] std::string classOf(std::string_view net) const;
};

/// Reads a project file; what is no JSON is reported and gives nothing.
[[nodiscard]] Project readProject(std::string_view text, std::string_view file, Diagnostics& diagnostics);

}  // namespace model::kicad
