#pragma once

#include "model/formats/odb/steps/step.h"

namespace model::odb {

/// Tools whose sizes are in another unit than their file states: KiCad 10 writes mm where the format has µm, and KiCad
/// 9 µm. Where no hole of a layer has the size of a tool as stated, but all holes have in mil, µm, inches or mm, the
/// tools are read anew in that unit, which is reported. Holes that are areas or user symbols do not count.
void fitToolUnits(const JobContext& job, Steps& steps);

}  // namespace model::odb
