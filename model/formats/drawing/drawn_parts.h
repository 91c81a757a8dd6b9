#pragma once

#include "model/board/document_builder.h"
#include "model/formats/drawing/drawn_nets.h"
#include "model/formats/drawing/layer_rows.h"
#include "model/solids/bodies.h"

namespace model::formats {

/// Brings packages, components and pins of a step into its document, in the step's order. Components that do not say
/// whether they are mirrored are as those of their side fit best: mirrored if that puts more pins of the side within
/// 1 µm of where the job says they are (in doubt the bottom is). Components whose pins do not fit are reported; their
/// pins lie where the job says.
void addParts(DocumentBuilder& builder, const DrawnStep& step, const DrawnNets& nets);

/// The tallest bodies of the components of all steps; `document` has the layers.
[[nodiscard]] TallestBodies tallestParts(const DrawnJob& job, const Document& document);

/// Brings groups of features into the document, once all its elements are there.
void addGroups(DocumentBuilder& builder, const LayerRows& layers, const DrawnStep& step);

}  // namespace model::formats
