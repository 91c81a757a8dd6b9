#pragma once

#include "model/document_builder.h"

namespace model {

/// Adds the synthetic layer "board" of type Body: the laminate, that is the profile minus all drilled and routed holes,
/// from the upper face of the lowest to the lower face of the highest copper layer. To be called after all other
/// layers; does nothing without a profile. Holes are cut with 5 µm chords (paper "AreaShape with holes").
void addBody(DocumentBuilder& builder);

}  // namespace model
