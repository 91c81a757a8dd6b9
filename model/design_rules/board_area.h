#pragma once

#include <vector>

#include "model/board/document.h"
#include "model/geometry/box_index.h"

namespace model {

/// Where a board is: within its outline, not in a cut-out (Document::profile, which must be valid).
class BoardArea {
public:
    /// Curves are chords of at most this height, nm: so near to the edge a point may be on the other side.
    static constexpr double kUnsure = 2000.0;

    explicit BoardArea(const Document& document);

    [[nodiscard]] bool holds(PointD p) const;

private:
    struct Side {
        PointD from;
        PointD to;
    };

    std::vector<Side> m_sides;
    Box m_extent;
    BoxIndex m_index;  ///< by side
};

}  // namespace model
