#pragma once

#include <span>
#include <string>

#include "model/clearance/stackup_clearance.h"
#include "model/export/clearance_export.h"

namespace model {

/// Distances between nets through the stackup, as text for people, as JSON {"through_stackup": [{"distance_um",
/// "planar_um", "height_um", "layers", "nets", "copies", "sides", "from_mm", "to_mm"}]} or as CSV. Copies are rows of
/// StepTree::copies; 0 is the board itself.
[[nodiscard]] std::string stackupClearanceReport(const Document& board, std::span<const StackupClearance> clearances,
                                                 ReportFormat format);

}  // namespace model
