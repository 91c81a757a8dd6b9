#pragma once

#include <optional>

#include "model/board/document_builder.h"
#include "model/formats/odb/features/features.h"

namespace model::odb {

/// The outline a `profile` file draws: all polygons of its surfaces. Nothing when it has none.
[[nodiscard]] std::optional<ShapeSketch> profileOf(const FeatureFile& file);

/// Is this the outline of that board? One job's profile is a 3 × 2 mm box for a 90 mm board. It is believed
/// when at least half of the copper elements built so far have their middle inside its box, grown by a millimetre;
/// copies of other steps count with all their copper; without any copper it always is.
[[nodiscard]] bool fitsCopper(const ShapeSketch& profile, const Document& soFar);

/// The box around all copper, as a stand-in for a missing or wrong profile. Nothing without copper.
[[nodiscard]] std::optional<ShapeSketch> profileFromCopper(const Document& soFar);

}  // namespace model::odb
