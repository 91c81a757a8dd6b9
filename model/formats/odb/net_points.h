#pragma once

#include "model/board/document_builder.h"
#include "model/formats/odb/step/step.h"

namespace model::odb {

/// Brings the points of the step's netlists into its document and compares them with the nets of eda/data, once
/// elements and components are there.
///
/// A netlist may count from another origin than everything else (odb-notes, Nets and parts): when less than half of its
/// points lie on a pad or hole of their net, the shift that most points agree on is added, and reported. Names that
/// eda/data does not know, and points that lie on no pad or hole of their net, are reported with their number.
void addNetPoints(DocumentBuilder& builder, const StepData& step);

}  // namespace model::odb
