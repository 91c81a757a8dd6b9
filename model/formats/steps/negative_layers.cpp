#include "model/formats/steps/negative_layers.h"

#include <string>

#include "model/formats/common/board_outline.h"
#include "model/formats/common/painting.h"
#include "model/geometry/region.h"

namespace model::formats {

namespace {

std::string summaryText(const InverseSummary& summary) {
    return " is negative: shown is the board's outline minus its features; " +
           std::to_string(summary.pieces - summary.withoutNet) + " of " + std::to_string(summary.pieces) +
           " pieces have a net, that of the plated holes and pads in them";
}

}  // namespace

void addNegativeLayer(DocumentBuilder& builder, LayerId layer, const Document& painted,
                      std::span<const std::uint8_t> negatives, std::string_view file, std::uint32_t line) {
    const std::string name = "layer " + builder.layer(layer).name;
    const ShapeId own = builder.layer(layer).profile;
    const ShapeId profile = own.isValid() ? own : builder.soFar().profile;
    if (!profile.isValid()) {
        return builder.diagnostics().report(Severity::Error, file, line,
                                            name + " is negative, but the board has no outline; it stays empty");
    }
    const PolygonSet outline = discretise(builder.shapes(), profile, kBooleanChords);
    const std::vector<NetVote> votes = votesOn(builder.soFar(), layer, painted);
    const InverseSummary summary =
        addInverse(builder, withoutCopies(builder.soFar(), outline, kBooleanChords), painted, negatives, votes);
    builder.diagnostics().report(Severity::Info, file, line, name + summaryText(summary));
    if (summary.withSeveralNets > 0) {
        builder.diagnostics().report(Severity::Warning, file, line,
                                     name + ": in " + std::to_string(summary.withSeveralNets) +
                                         " pieces lie holes of several nets; the most frequent one was taken");
    }
}

}  // namespace model::formats
