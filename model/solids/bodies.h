#pragma once

#include "model/board/document_builder.h"
#include "model/packages/body_plan.h"

/// Bodies of components: the prism around each component that stands on the board. What they look like in detail is in
/// model/packages.
namespace model {

/// Heights of the tallest bodies on either side; 0 where there is no component.
struct TallestBodies {
    Nm top = 0;
    Nm bottom = 0;
    bool isAlone = true;  ///< of a job without other steps
};

/// Adds a synthetic layer (LayerType::ComponentBody) for each side with a height, and on it the bodies of the
/// document's components (Document::bodies), to be called when all other layers are complete. They stand on the
/// outermost of copper and solder mask. On a rigid-flex board parts in a zone that lacks the outer layers are on a
/// layer of their own (body_floors.h), whose Layer::spanTop names what they stand on; one is left out where the
/// document is alone and nothing stands there. Outlines and the heights that the job does not state follow from the
/// package (BodyPlan). Components that are not populated have no body, nor have those that only are copper or a hole,
/// and those without a height whose outline covers much of the board, or other components. What is assumed or left out
/// is reported, once per cause.
///
/// Layers of the two sides are each other's Layer::opposite.
///
/// All steps of a panel have the same rows: `tallest` is that of all of them.
void addBodies(DocumentBuilder& builder, const TallestBodies& tallest);

/// Gives layers of bodies that are there already the heights that follow from what the layers of the job now have.
void placeBodies(Document& document);

}  // namespace model
