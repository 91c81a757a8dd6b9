#pragma once

#include "model/board/document_builder.h"
#include "model/formats/odb/elements/net_links.h"
#include "model/formats/odb/layer_table.h"
#include "model/solids/bodies.h"

namespace model::odb {

/// Brings packages, components and pins of a step into its document, and ties the pads of pins to them.
///
/// Where package coordinates land is decided by the pins: the records of a job say where each pin lies on the board,
/// and the mirror flag is not reliable (odb-notes, Nets and parts). Per side, the placement with or without mirror that
/// puts more pins within 1 µm of their record holds for all components of that side. Components whose pins fit neither
/// are reported; their pins lie where the records say.
void addParts(DocumentBuilder& builder, const Matrix& matrix, const LayerTable& layers, const StepData& step,
              const NetLinks& nets);

/// The tallest bodies of the components of all steps.
[[nodiscard]] TallestBodies tallestParts(const Matrix& matrix, const LayerTable& layers, const Steps& steps,
                                         const Document& document);

/// Brings groups of features (FGR records) into the document, once all its elements are there.
void addGroups(DocumentBuilder& builder, const Matrix& matrix, const LayerTable& layers, const StepData& step);

}  // namespace model::odb
