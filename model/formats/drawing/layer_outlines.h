#pragma once

#include <vector>

#include "model/board/document_builder.h"
#include "model/formats/drawing/drawn_job.h"

/// Where layers exist: all over the board, within an outline of their own, or in some of the board's zones.
namespace model::formats {

class LayerRows;

/// Layer::outlineGroup for every row of DrawnJob::layers, from what all steps say.
[[nodiscard]] std::vector<std::uint32_t> outlineGroups(const DrawnJob& job);

/// Adds the zones of a step to its document and gives layers their outlines: their own, in steps that hold no copies,
/// or else, of layers that some but not all zones have, what those zones cover together. To be called once the board
/// has its profile.
void addOutlines(DocumentBuilder& builder, const DrawnJob& job, const LayerRows& layers, const DrawnStep& step);

}  // namespace model::formats
