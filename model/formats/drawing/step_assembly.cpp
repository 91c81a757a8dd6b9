#include "model/formats/drawing/step_assembly.h"

#include <algorithm>
#include <memory>

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
        if (!addPositiveLayers()) {
            return false;
        }
        addProfile();
        addOutlines(m_builder, m_parts.job, m_parts.layers, m_step);
        if (m_isShown) {
            reportStackup(m_builder.soFar(), m_builder.diagnostics());
        }
        if (!addNegatives()) {
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
    bool addPositiveLayers() {
        for (const std::size_t row : m_parts.layers.order()) {
            if (m_parts.progress.isCancelled()) {
                return false;
            }
            if (!m_parts.job.layers[row].isNegative) {
                addLayer(row);
                m_parts.progress.layerDone();
            }
        }
        return true;
    }

    /// They need the profile and the holes, so they come last.
    bool addNegatives() {
        std::vector<NegativeLayer> negatives;
        for (const std::size_t row : m_parts.layers.order()) {
            if (m_parts.job.layers[row].isNegative) {
                negatives.push_back(paintNegative(row));
            }
        }
        const StepRole role = m_isShown ? StepRole::Shown : StepRole::Copied;
        if (!addNegativeLayers(m_builder, negatives, role, m_parts.progress)) {
            return false;
        }
        for (const NegativeLayer& layer : negatives) {
            m_copies.reportNegativesOfCopies(layer.layer, layer.file);
            m_copies.reportClearedNeighbours(layer.layer);
        }
        return true;
    }

    [[nodiscard]] DrawnSource sourceOf(std::size_t row) const {
        return {&m_step, featuresOf(m_step, row), m_parts.job.layers[row].file, m_parts.layers.id(row)};
    }

    /// None for layers without holes.
    [[nodiscard]] std::optional<HoleRules> holesOf(std::size_t row) {
        const DrawnLayer& layer = m_parts.job.layers[row];
        return isHoles(layer.type) ? std::optional<HoleRules>(std::in_place, m_builder.layer(m_parts.layers.id(row)),
                                                              layer.tools, m_pins)
                                   : std::nullopt;
    }

    void addLayer(std::size_t row) {
        const DrawnSource source = sourceOf(row);
        m_builder.beginLayer(source.layer);
        if (source.features.empty()) {
            return;
        }
        const std::optional<HoleRules> holes = holesOf(row);
        if (hasNegatives(source.features)) {
            paintLayer(source, holes);
        } else {
            addDrawn(m_builder, m_nets, m_builder.diagnostics(), source, holes ? &*holes : nullptr);
        }
        m_copies.reportNegativesOfCopies(source.layer, source.path);
    }

    std::vector<std::uint8_t> paint(DocumentBuilder& scratch, const DrawnSource& source,
                                    const std::optional<HoleRules>& holes) {
        scratch.beginLayer(scratch.addLayer({}));
        return addDrawn(scratch, m_nets, m_builder.diagnostics(), source, holes ? &*holes : nullptr);
    }

    void paintLayer(const DrawnSource& source, const std::optional<HoleRules>& holes) {
        DocumentBuilder scratch;
        const std::vector<std::uint8_t> negatives = paint(scratch, source, holes);
        m_copies.reportOwnNegatives(source.layer, source.path, scratch.soFar(), negatives);
        addPainted(m_builder, scratch.soFar(), negatives, source.path);
    }

    NegativeLayer paintNegative(std::size_t row) {
        const DrawnSource source = sourceOf(row);
        NegativeLayer layer;
        layer.layer = source.layer;
        layer.file = std::string(source.path);
        layer.line = m_parts.job.layers[row].line;
        if (!source.features.empty()) {
            layer.painted = std::make_unique<DocumentBuilder>();
            layer.negatives = paint(*layer.painted, source, holesOf(row));
        }
        return layer;
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
