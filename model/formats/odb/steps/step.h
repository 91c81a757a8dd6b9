#pragma once

#include <array>
#include <string>
#include <vector>

#include "model/formats/odb/components/components.h"
#include "model/formats/odb/components/eda.h"
#include "model/formats/odb/components/netlist.h"
#include "model/formats/odb/features/features.h"
#include "model/formats/odb/features/tools.h"
#include "model/formats/odb/stackup/matrix.h"
#include "model/formats/odb/stackup/zones.h"
#include "model/formats/odb/steps/step_header.h"
#include "model/formats/odb/text/attribute_types.h"
#include "model/formats/odb/text/job_tree.h"

namespace model::odb {

/// A file as parsed by one task, with what the task had to say.
template <class T>
struct Parsed {
    T value;
    std::string path;  ///< empty when the job has no such file
    Diagnostics diagnostics;

    [[nodiscard]] bool isPresent() const { return !path.empty(); }
};

/// What a step says about one row of the matrix.
struct StepLayer {
    Parsed<FeatureFile> features;
    Parsed<FeatureFile> profile;  ///< where the layer exists (rigid-flex)
    Parsed<std::vector<DrillTool>> tools;
    Parsed<std::vector<PlacedComponent>> components;
    Parsed<LayerFacts> facts;
};

/// All files of one step that we read.
struct StepData {
    std::string name;
    std::string folder;  ///< "steps/<name>"
    Parsed<StepHeader> header;
    Parsed<FeatureFile> profile;
    Parsed<ZoneFile> zones;
    Parsed<EdaData> eda;
    std::array<Parsed<formats::Netlist>, 3> netlists;  ///< by NetlistKind
    std::vector<StepLayer> layers;                     ///< by row of Matrix::layers
};

/// The chosen step, first, and all steps its STEP-REPEAT blocks bring in.
using Steps = std::vector<StepData>;

/// Row of the step of that name (case does not matter); the number of steps if there is none.
[[nodiscard]] std::size_t findStep(const Steps& steps, std::string_view name);

/// What every parser needs to know about the job.
struct JobContext {
    const formats::FileTree& tree;
    const Matrix& matrix;
    Unit defaultUnit = Unit::Inch;
    const AttributeTypes* attributeTypes = nullptr;
};

/// Rows of `steps` needed for `name`: reads the step headers, not the layers. Steps that are missing or contain
/// themselves are reported and left out of the copies.
[[nodiscard]] Steps collectSteps(const JobContext& job, const std::string& name, Diagnostics& diagnostics);

/// Parses all files of the steps, in parallel. False when cancelled.
[[nodiscard]] bool readSteps(const JobContext& job, Steps& steps, base::Progress& progress);

}  // namespace model::odb
