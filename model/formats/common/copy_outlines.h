#pragma once

#include "model/board/document.h"
#include "model/geometry/discretise.h"

namespace model::formats {

/// What a panel leaves to the copies it holds: `region` of the document minus the outlines of its copies, which have
/// substrates and planes of their own. A copy without an outline lies on the panel's; then its holes are cut, and so
/// are the copies it holds. Needs the document's instances only, so it works on one that is being built.
[[nodiscard]] PolygonSet withoutCopies(const Document& document, const PolygonSet& region, const Discretisation& how);

}  // namespace model::formats
