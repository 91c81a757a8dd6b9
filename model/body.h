#pragma once

#include "model/document_builder.h"

namespace model {

/// Adds the synthetic layer "board" of type Body: the laminate, that is the profile minus the holes that go all the way
/// through it, from the upper face of the lowest to the lower face of the highest copper layer. Blind and buried holes
/// are not cut: the laminate is one slab. To be called after all other layers; does nothing without a profile. Holes
/// are cut with 5 µm chords (paper "AreaShape with holes").
void addBody(DocumentBuilder& builder);

/// Gives the body, where there is one, the height that the other layers now have.
void placeBody(std::vector<Layer>& layers, Nm boardThickness);

}  // namespace model
