#pragma once

#include "model/board/document_builder.h"

/// Bodies of components: the outline of the package, as high as the component.
namespace model {

/// Height of a body where the job states none.
inline constexpr Nm kAssumedBody = 1'000'000;
/// A height beyond this is taken for a mistake of the job: the tallest parts soldered to boards are capacitors and
/// heat sinks of some 100 mm.
inline constexpr Nm kMostBody = 150'000'000;

/// The height of a component's body, from what the job states (0 or less: nothing).
[[nodiscard]] constexpr Nm bodyHeight(Nm stated) {
    return stated <= 0 ? kAssumedBody : std::min(stated, kMostBody);
}

/// Heights of the tallest bodies on either side; 0 where there is no component.
struct TallestBodies {
    Nm top = 0;
    Nm bottom = 0;
};

/// Adds a synthetic layer (LayerType::ComponentBody) for each side with a height, and on it the bodies of the
/// document's components (Document::bodies), to be called when all other layers are complete. They stand on the
/// outermost of copper and solder mask. The outline is the package's; where it draws none its stated box, then the box
/// of its pins. Components that are not populated have no body. What is assumed is reported, once per cause.
///
/// All steps of a panel have the same rows: `tallest` is that of all of them.
void addBodies(DocumentBuilder& builder, const TallestBodies& tallest);

/// Gives layers of bodies that are there already the heights that follow from what the layers of the job now have.
void placeBodies(Document& document);

}  // namespace model
