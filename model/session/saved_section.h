#pragma once

#include <string>
#include <vector>

#include "model/base/point.h"

namespace model::session {

/// The line of a section that the user saved. In a session file:
///
///     {"name": "Section 1", "step": "pcb", "line_nm": [[0, 0], [1000000, 0]]}
struct SavedSection {
    std::string name;
    std::string step;                ///< the one it was drawn in
    std::vector<base::PointD> line;  ///< two corners at least, nm of the board
    bool operator==(const SavedSection&) const = default;
};

}  // namespace model::session
