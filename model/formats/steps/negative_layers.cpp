#include "model/formats/steps/negative_layers.h"

#include <string>

#include "model/base/parallel.h"
#include "model/formats/common/board_outline.h"
#include "model/formats/common/painting.h"
#include "model/solids/shells/area_shell.h"

namespace model::formats {

namespace {

/// Where a job names no nets, what nets the pieces have follows later, from the copper.
std::string summaryText(const InverseSummary& summary, bool hasNets) {
    return " is negative: shown is the board's outline minus its features" +
           (hasNets
                ? "; " + std::to_string(summary.pieces - summary.withoutNet) + " of " + std::to_string(summary.pieces) +
                      " pieces have a net, that of the plated holes and pads in them"
                : std::string()) +
           (summary.isExact ? "" : "; arcs are straight edges within 1 µm, as they could not be kept");
}

ShapeId outlineOf(const DocumentBuilder& builder, LayerId layer) {
    const ShapeId own = builder.soFar().layer(layer).profile;
    return own.isValid() ? own : builder.soFar().profile;
}

Inverse inverseOf(const DocumentBuilder& builder, const NegativeLayer& layer) {
    const Document& board = builder.soFar();
    const RegionBoolean base = withoutCopies(board, areaOutlines(board.shapes, outlineOf(builder, layer.layer)));
    const std::vector<NetVote> votes = votesOn(board, layer.layer, layer.painted->soFar());
    Inverse inverse = inverseOf(base.regions, layer.painted->soFar(), layer.negatives, votes);
    inverse.summary.isExact = inverse.summary.isExact && base.isExact;
    return inverse;
}

void report(Diagnostics& diagnostics, const NegativeLayer& layer, const std::string& name,
            const InverseSummary& summary, bool hasNets) {
    diagnostics.report(Severity::Info, layer.file, layer.line, name + summaryText(summary, hasNets));
    if (summary.withSeveralNets > 0) {
        diagnostics.report(Severity::Warning, layer.file, layer.line,
                           name + ": in " + std::to_string(summary.withSeveralNets) +
                               " pieces lie holes of several nets; the most frequent one was taken");
    }
}

}  // namespace

bool addNegativeLayers(DocumentBuilder& builder, std::span<const NegativeLayer> layers, StepProgress& progress) {
    std::vector<Inverse> inverses(layers.size());
    base::parallelFor(layers.size(), [&](std::size_t i) {
        if (!progress.isCancelled() && outlineOf(builder, layers[i].layer).isValid()) {
            inverses[i] = inverseOf(builder, layers[i]);
        }
        progress.layerDone();
    });
    if (progress.isCancelled()) {
        return false;
    }
    for (std::size_t i = 0; i < layers.size(); ++i) {
        const std::string name = "layer " + builder.layer(layers[i].layer).name;
        builder.beginLayer(layers[i].layer);
        if (outlineOf(builder, layers[i].layer).isValid()) {
            addInverse(builder, inverses[i]);
            report(builder.diagnostics(), layers[i], name, inverses[i].summary, !builder.soFar().nets.empty());
        } else {
            builder.diagnostics().report(Severity::Error, layers[i].file, layers[i].line,
                                         name + " is negative, but the board has no outline; it stays empty");
        }
    }
    return true;
}

}  // namespace model::formats
