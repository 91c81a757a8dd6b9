#include <string>

#include "contours.h"
#include "curves.h"
#include "model/export/solids/step_export.h"
#include "model/formats/paper/paper_reader.h"
#include "regions.h"
#include "targets.h"

namespace fuzz {

namespace {

/// The text of a model of the paper as solids, in all ways they can be written; what is written goes nowhere.
void stepSolids(std::string_view input) {
    base::Progress progress;
    const auto read = model::paper::readModel(input, "input", progress);
    if (!read) {
        return;
    }
    for (const bool isPlain : {true, false}) {
        model::SolidChoice choice;
        choice.hasFittedArcs = !isPlain;
        choice.isMerged = !isPlain;
        choice.isOnePart = !isPlain;
        if (const auto plan = model::planSolids(**read, choice, progress)) {
            model::StepOptions options;
            options.isWrittenOut = !isPlain;
            options.hasPolylines = !isPlain;
            options.limits = isPlain ? model::RegionLimits{} : model::RegionLimits{8, 2};
            static_cast<void>(model::estimateStep(*plan, options, progress));
            static_cast<void>(model::exportStep(*plan, options, "/dev/null", progress));
        }
    }
}

}  // namespace

std::span<const Target> geometryTargets() {
    static const std::vector<Target> kTargets = {
        {"contours", contours},
        {"curves", curves},
        {"regions", regions},
        {"step_solids", stepSolids},
    };
    return kTargets;
}

}  // namespace fuzz
