#pragma once

#include <span>
#include <string_view>
#include <vector>

#include "model/base/progress.h"
#include "model/formats/ipc2581/feature_reader.h"
#include "model/formats/ipc2581/stackup_reader.h"

namespace model::ipc2581 {

/// A StepRepeat, its step by name.
struct SourceRepeat {
    std::string_view step;
    PointD first;
    PointD pitch;
    int columns = 1;
    int rows = 1;
    double ccwDeg = 0.0;
    bool isMirrored = false;
    std::uint32_t line = 0;
};

/// A step with its features by row of the LayerList; copies and zones are still as the file names them.
struct SourceStep {
    std::string_view name;
    formats::DrawnStep drawn;
    PointD datum;
    std::vector<SourceRepeat> repeats;
    bool drawsItself = false;
};

/// What the steps of a file have in common.
struct StepSurroundings {
    Reading& reading;
    const Dictionaries& dictionaries;
    const Specs& specs;
    LayerList& layers;
    const Stackups& stackups;
    const Bom& bom;
    base::Progress& progress;
};

/// Reads the sections of a step in the order in which they need each other, whatever order they are written in.
/// Cancelled: what was read so far.
[[nodiscard]] SourceStep readStep(const StepSurroundings& file, std::string_view name,
                                  std::span<const XmlSection> sections);

}  // namespace model::ipc2581
