#include "model/formats/steps/negative_layers.h"

#include <algorithm>
#include <iterator>
#include <string>

#include "model/base/parallel.h"
#include "model/formats/common/board_outline.h"
#include "model/formats/common/painting.h"
#include "model/geometry/loops/edge_loops.h"
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

/// What the copies clear on the layer outside of their outlines.
std::vector<EdgeLoops> clearedAroundCopies(const Document& board, LayerId layer) {
    std::vector<EdgeLoops> cleared;
    for (const StepInstance& instance : board.instances) {
        const Document& step = *board.steps[instance.step];
        const ShapeId around = step.layer(board.layerOfCopy(layer, instance.isFlipped)).clearedAround;
        if (around.isValid()) {
            std::ranges::transform(areaOutlines(step.shapes, around), std::back_inserter(cleared),
                                   [&](const EdgeLoops& region) { return placed(region, instance.placement); });
        }
    }
    return cleared;
}

/// A negative layer without features.
RegionBoolean baseOf(const DocumentBuilder& builder, LayerId layer) {
    const Document& board = builder.soFar();
    RegionBoolean base = withoutCopies(board, areaOutlines(board.shapes, outlineOf(builder, layer)));
    const std::vector<EdgeLoops> cleared = clearedAroundCopies(board, layer);
    if (!cleared.empty()) {
        const bool wasExact = base.isExact;
        base = differenceOf(base.regions, cleared);
        base.isExact = base.isExact && wasExact;
    }
    return base;
}

/// What is made of a negative layer.
struct Filled {
    Inverse inverse;
    RegionBoolean around;  ///< cleared outside of the step's outline
};

/// What of `cleared` lies outside of the step's outline, or all of it where there is none.
RegionBoolean outsideOf(const DocumentBuilder& builder, LayerId layer, RegionBoolean cleared) {
    const ShapeId outline = outlineOf(builder, layer);
    if (!outline.isValid() || cleared.regions.empty()) {
        return cleared;
    }
    RegionBoolean outside = differenceOf(cleared.regions, areaOutlines(builder.soFar().shapes, outline));
    outside.isExact = outside.isExact && cleared.isExact;
    return outside;
}

/// The layer stays empty, so all that is left of it is what copies clear beyond this step.
Filled handedOn(const DocumentBuilder& builder, const NegativeLayer& layer, StepRole role) {
    Filled made;
    if (role == StepRole::Copied) {
        made.around = outsideOf(builder, layer.layer, {clearedAroundCopies(builder.soFar(), layer.layer), true});
    }
    return made;
}

Filled filled(const DocumentBuilder& builder, const NegativeLayer& layer, StepRole role) {
    const Document& board = builder.soFar();
    const Document& painted = layer.painted->soFar();
    const RegionBoolean base = baseOf(builder, layer.layer);
    Filled made;
    RegionBoolean visible = visibleOf(painted, layer.negatives);
    made.inverse = inverseOf(base.regions, visible, painted, votesOn(board, layer.layer, painted));
    if (role == StepRole::Copied) {
        visible.append({clearedAroundCopies(board, layer.layer), true});  // may reach beyond this step, too
        made.around = outsideOf(builder, layer.layer, std::move(visible));
    }
    made.inverse.summary.isExact = made.inverse.summary.isExact && base.isExact && made.around.isExact;
    return made;
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

void add(DocumentBuilder& builder, const NegativeLayer& layer, const Filled& made) {
    const std::string name = "layer " + builder.layer(layer.layer).name;
    builder.beginLayer(layer.layer);
    addInverse(builder, made.inverse);
    if (!made.around.regions.empty()) {
        builder.layer(layer.layer).clearedAround = builder.addShape(sketchOf(made.around.regions));
    }
    if (layer.painted == nullptr) {
        if (!made.around.isExact) {
            builder.diagnostics().report(Severity::Info, layer.file, layer.line,
                                         name +
                                             ": what copies clear around them has straight edges within 1 µm, as its "
                                             "arcs could not be kept");
        }
        return;
    }
    if (outlineOf(builder, layer.layer).isValid()) {
        report(builder.diagnostics(), layer, name, made.inverse.summary, !builder.soFar().nets.empty());
    } else {
        builder.diagnostics().report(Severity::Error, layer.file, layer.line,
                                     name + " is negative, but the board has no outline; it stays empty");
    }
}

}  // namespace

bool addNegativeLayers(DocumentBuilder& builder, std::span<const NegativeLayer> layers, StepRole role,
                       StepProgress& progress) {
    std::vector<Filled> made(layers.size());
    base::parallelFor(layers.size(), [&](std::size_t i) {
        if (!progress.isCancelled() && layers[i].painted == nullptr) {
            made[i] = handedOn(builder, layers[i], role);
        } else if (!progress.isCancelled() && outlineOf(builder, layers[i].layer).isValid()) {
            made[i] = filled(builder, layers[i], role);
        }
        progress.layerDone();
    });
    if (progress.isCancelled()) {
        return false;
    }
    for (std::size_t i = 0; i < layers.size(); ++i) {
        add(builder, layers[i], made[i]);
    }
    return true;
}

}  // namespace model::formats
