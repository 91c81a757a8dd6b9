#pragma once

#include "model/formats/odb/steps/step.h"

namespace model::odb {

/// Some writers list holes twice: Altium writes the vias of an IPC-4761 type (DRILL_TYPE_1B, what is to be tented) as a
/// layer of drills, though they are on the drill layer of their span, too. A drill layer all of whose holes another one
/// of its span has becomes a drawing, so that they are drilled once; each is reported. To be called once all is read.
void setRepeatedDrillsAside(Matrix& matrix, const Steps& steps, Diagnostics& diagnostics);

}  // namespace model::odb
