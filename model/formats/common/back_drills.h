#pragma once

#include "model/board/document_builder.h"

namespace model::formats {

/// Finds the plated holes that a wider NPTH is drilled over (LayerUse::Backdrill, LayerUse::DualDiameter) and cuts
/// their plating back to the copper layers it leaves: Document::platedSpans. A drill takes the plating from all copper
/// of its span, both ends included, if it covers the hole. To be called once, when all holes are there.
///
/// Reported with the drilled hole: what it takes, and what keeps its plating because the drill does not cover it or
/// begins and ends inside of it.
void cutPlating(DocumentBuilder& builder);

}  // namespace model::formats
