#pragma once

#include <optional>
#include <string_view>
#include <vector>

#include "model/board/document_builder.h"
#include "model/geometry/loops/region_booleans.h"

namespace model::formats {

/// Is this the outline of that board? One job's outline is a 3 × 2 mm box for a 90 mm board. It is believed
/// when at least half of the copper elements built so far have their middle inside its box, grown by a millimetre;
/// copies of other steps count with all their copper; without any copper it always is.
[[nodiscard]] bool fitsCopper(const ShapeSketch& outline, const Document& soFar);

/// The box around all copper, as a stand-in for a missing or wrong outline. Nothing without copper.
[[nodiscard]] std::optional<ShapeSketch> outlineOfCopper(const Document& soFar);

/// Makes `sketch` the board's outline if it fits the copper, else the box around the copper, which is reported with
/// `file`; `whyNone` says why there is none in the job.
void setOutline(DocumentBuilder& builder, std::optional<ShapeSketch> sketch, std::string_view whyNone,
                std::string_view file);

/// What a panel leaves to the copies it holds: `region` of the document minus the outlines of its copies, which have
/// substrates and planes of their own. A copy without an outline lies on the panel's; then its holes are cut, and so
/// are the copies it holds. Needs the document's instances only, so it works on one that is being built.
[[nodiscard]] RegionBoolean withoutCopies(const Document& document, std::vector<EdgeLoops> region);

}  // namespace model::formats
