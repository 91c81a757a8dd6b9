#pragma once

#include "model/board/document_builder.h"
#include "model/formats/odb/layer_table.h"
#include "model/formats/odb/steps/step.h"

namespace model::odb {

/// Finds what on the board the messages about lines of a step's files speak of, once the step's elements are built: the
/// element that came out of the record (of several the first), or else the location the record names. Messages about
/// records that name no location, or lines that are no record, stay without.
void locateMessages(DocumentBuilder& builder, const LayerTable& layers, const StepData& step);

}  // namespace model::odb
