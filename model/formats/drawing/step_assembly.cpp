#include "model/formats/drawing/step_assembly.h"

#include <algorithm>

#include "model/board/holes.h"
#include "model/board/stackup_checks.h"
#include "model/formats/common/back_drills.h"
#include "model/formats/common/board_outline.h"
#include "model/formats/common/painting.h"
#include "model/formats/drawing/drawn_elements.h"
#include "model/formats/drawing/drawn_parts.h"
#include "model/formats/drawing/layer_outlines.h"
#include "model/formats/drawing/message_places.h"
#include "model/formats/steps/negative_layers.h"
#include "model/solids/solids.h"

namespace model::formats {

namespace {

bool hasNegatives(std::span<const DrawnFeature> features) {
    return std::ranges::any_of(features, &DrawnFeature::isNegative);
}

PinLocations pinsOf(const DrawnStep& step) {
    std::vector<Point> pins;
    for (const DrawnComponent& component : step.components) {
        for (const DrawnPin& pin : component.pins) {
            pins.push_back(pin.position);
        }
    }
    return PinLocations(std::move(pins));
}

class StepAssembly {
public:
    StepAssembly(const AssemblyParts& parts, std::size_t step, DocumentBuilder& builder)
        : m_parts(parts),
          m_step(parts.job.steps[step]),
          m_isShown(step == 0),
          m_builder(builder),
          m_copies(builder, parts.plans[step], parts.documents, m_step.copiesFile,
                   [&parts](std::size_t copied, LayerId layer) {
                       return hasNegatives(featuresOf(parts.job.steps[copied], parts.layers.rowOf(layer)));
                   }),
          m_nets(builder, m_step),
          m_pins(pinsOf(m_step)) {}

    bool run() {
        m_copies.add();
        addParts(m_builder, m_step, m_nets);
        if (!addLayers(false)) {
            return false;
        }
        addProfile();
        addOutlines(m_builder, m_parts.job, m_parts.layers, m_step);
        if (m_isShown) {
            reportStackup(m_builder.soFar(), m_builder.diagnostics());
        }
        if (!addLayers(true)) {
            return false;
        }
        cutPlating(m_builder);
        addTools();
        addGroups(m_builder, m_parts.layers, m_step);
        addNetlists();
        locateMessages(m_builder, m_step);
        if (!addSolids(m_builder, m_parts.progress.inner())) {
            return false;
        }
        addBodies(m_builder, tallestParts(m_parts.job, m_builder.soFar()));
        return true;
    }

private:
    /// All layers whose polarity is `isNegative`; negative ones need the profile and the holes, so they come last.
    bool addLayers(bool isNegative) {
        for (const std::size_t row : m_parts.layers.order()) {
            if (m_parts.progress.isCancelled()) {
                return false;
            }
            if (m_parts.job.layers[row].isNegative == isNegative) {
                addLayer(row);
                m_parts.progress.layerDone();
            }
        }
        return true;
    }

    void addLayer(std::size_t row) {
        const DrawnLayer& layer = m_parts.job.layers[row];
        const LayerId id = m_parts.layers.id(row);
        m_builder.beginLayer(id);
        const DrawnSource source{&m_step, featuresOf(m_step, row), layer.file, id};
        if (source.features.empty()) {
            return;
        }
        std::optional<HoleRules> holes;
        if (isHoles(layer.type)) {
            holes.emplace(m_builder.layer(id), layer.tools, m_pins);
        }
        if (layer.isNegative || hasNegatives(source.features)) {
            paintLayer(source, layer.isNegative, holes ? &*holes : nullptr);
        } else {
            addDrawn(m_builder, m_nets, m_builder.diagnostics(), source, holes ? &*holes : nullptr);
        }
        m_copies.reportNegativesOfCopies(id, layer.file);
    }

    void paintLayer(const DrawnSource& source, bool isNegativeLayer, const HoleRules* holes) {
        DocumentBuilder scratch;
        scratch.beginLayer(scratch.addLayer({}));
        const std::vector<std::uint8_t> negatives = addDrawn(scratch, m_nets, m_builder.diagnostics(), source, holes);
        if (isNegativeLayer) {
            return addNegativeLayer(m_builder, source.layer, scratch.soFar(), negatives, source.path, 0);
        }
        m_copies.reportOwnNegatives(source.layer, source.path, scratch.soFar(), negatives);
        addPainted(m_builder, scratch.soFar(), negatives);
    }

    void addProfile() {
        const bool hasProfile = !m_step.profile.isEmpty();
        if (!hasProfile && !m_isShown) {
            return;  // a coupon, say, that lies on the substrate of the step that holds it
        }
        setOutline(m_builder, hasProfile ? std::optional(m_step.profile) : std::nullopt,
                   "the job draws no outline of the board", m_step.profileFile);
    }

    void addTools() {
        for (const std::size_t row : m_parts.layers.order()) {
            for (DrillTool tool : m_parts.job.layers[row].tools) {
                tool.layer = m_parts.layers.id(row);
                m_builder.addTool(std::move(tool));
            }
        }
    }

    void addNetlists() {
        std::vector<NetlistFile> files;
        for (const DrawnNetlist& netlist : m_step.netlists) {
            files.push_back({&netlist.netlist, netlist.kind, netlist.file});
        }
        addNetPoints(m_builder, files);
    }

    const AssemblyParts& m_parts;
    const DrawnStep& m_step;
    bool m_isShown;  ///< not one of which only copies are shown
    DocumentBuilder& m_builder;
    StepCopies m_copies;
    DrawnNets m_nets;
    PinLocations m_pins;
};

}  // namespace

bool assembleStep(const AssemblyParts& parts, std::size_t step, DocumentBuilder& builder) {
    return StepAssembly(parts, step, builder).run();
}

}  // namespace model::formats
