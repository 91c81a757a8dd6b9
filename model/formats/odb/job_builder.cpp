#include "model/formats/odb/job_builder.h"

#include <algorithm>
#include <memory>

#include "model/board/stackup_checks.h"
#include "model/formats/common/back_drills.h"
#include "model/formats/common/board_outline.h"
#include "model/formats/common/hole_rules.h"
#include "model/formats/common/net_points.h"
#include "model/formats/common/painting.h"
#include "model/formats/common/routed_cutouts.h"
#include "model/formats/odb/copy_plan.h"
#include "model/formats/odb/elements/feature_elements.h"
#include "model/formats/odb/layer_table.h"
#include "model/formats/odb/message_locations.h"
#include "model/formats/odb/parts.h"
#include "model/formats/odb/rigid_flex.h"
#include "model/formats/odb/text/records.h"
#include "model/formats/steps/negative_layers.h"
#include "model/formats/steps/step_copies.h"
#include "model/formats/steps/step_progress.h"
#include "model/solids/solids.h"

namespace model::odb {

namespace {

/// What is the same for all steps of the job.
struct JobParts {
    const JobContext& job;
    const Steps& steps;
    const LayerTable& layers;
    const std::vector<formats::CopyPlan>& plans;
    formats::StepDocuments& documents;
    formats::StepProgress& progress;
};

/// Builds the document of one step.
class StepBuilder {
public:
    /// The layers are in `builder` already.
    StepBuilder(const JobParts& parts, std::size_t step, DocumentBuilder& builder)
        : m_parts(parts),
          m_matrix(parts.job.matrix),
          m_step(parts.steps[step]),
          m_isChosen(step == 0),
          m_builder(builder),
          m_layers(parts.layers),
          m_copies(builder, parts.plans[step], parts.documents, m_step.header.path,
                   [&parts](std::size_t copied, LayerId layer) { return hasNegatives(parts, copied, layer); }),
          m_symbols(parts.job.tree, parts.job.defaultUnit, builder.diagnostics()),
          m_nets(builder, parts.job.matrix, parts.steps[step]),
          m_pins(pinsOf(parts.steps[step])) {}

    bool build() {
        takeDiagnostics();
        m_copies.add();
        if (!buildPositives()) {
            return false;
        }
        setProfile();
        buildRouted();
        addOutlines(m_builder, m_matrix, m_layers, m_step);
        if (m_isChosen) {
            reportStackup(m_builder.soFar(), diagnostics());
        }
        if (!buildNegatives()) {
            return false;
        }
        formats::cutPlating(m_builder);
        addTools();
        addParts(m_builder, m_matrix, m_layers, m_step, m_nets);
        addGroups(m_builder, m_matrix, m_layers, m_step);
        addNetlists();
        locateMessages(m_builder, m_layers, m_step);
        if (!addSolids(m_builder, m_parts.progress.inner())) {
            return false;
        }
        addBodies(m_builder, tallestParts(m_matrix, m_layers, m_parts.steps, m_builder.soFar()));
        return true;
    }

private:
    Diagnostics& diagnostics() { return m_builder.diagnostics(); }

    void takeDiagnostics() {
        diagnostics().append(m_step.header.diagnostics);
        diagnostics().append(m_step.profile.diagnostics);
        diagnostics().append(m_step.zones.diagnostics);
        diagnostics().append(m_step.eda.diagnostics);
        for (const StepLayer& layer : m_step.layers) {
            diagnostics().append(layer.features.diagnostics);
            diagnostics().append(layer.profile.diagnostics);
            diagnostics().append(layer.facts.diagnostics);
            diagnostics().append(layer.tools.diagnostics);
            diagnostics().append(layer.components.diagnostics);
        }
        for (const Parsed<formats::Netlist>& netlist : m_step.netlists) {
            diagnostics().append(netlist.diagnostics);
        }
    }

    // ---- elements ----

    /// Surfaces are most of the nodes; pads of symbols, outlines and bodies add a fifth on boards with planes.
    void expectSurfaces() {
        std::size_t nodes = 0;
        for (const StepLayer& layer : m_step.layers) {
            nodes += layer.features.value.surfaces.nodes.size();
        }
        m_builder.expectNodes(nodes + nodes / 4);
    }

    bool buildPositives() {
        expectSurfaces();
        for (const std::size_t row : m_layers.order()) {
            if (m_parts.progress.isCancelled()) {
                return false;
            }
            if (isRouted(row)) {
                const std::string& file = m_step.layers[row].features.path;
                m_routed.push_back({m_layers.id(row), std::make_unique<DocumentBuilder>(), file});
                paint(*m_routed.back().routed, row);
            } else if (!m_matrix.layers[row].isNegative) {
                buildLayer(row);
                m_parts.progress.layerDone();
            }
        }
        return true;
    }

    /// Which paths are slots, and which the edge of the board, the outline says.
    [[nodiscard]] bool isRouted(std::size_t row) const {
        const FeatureFile& file = m_step.layers[row].features.value;
        return m_matrix.layers[row].type == LayerType::Rout && !m_matrix.layers[row].isNegative && !file.hasNegatives &&
               m_step.layers[row].features.isPresent();
    }

    void buildRouted() {
        formats::takeOutRouted(m_builder, m_routed);
        for (const formats::RoutedLayer& layer : m_routed) {
            addRouted(m_builder, layer);
            m_copies.reportNegativesOfCopies(layer.layer, layer.file);
            m_parts.progress.layerDone();
        }
    }

    /// They need the profile and the holes, so they come last.
    bool buildNegatives() {
        std::vector<formats::NegativeLayer> negatives;
        for (const std::size_t row : m_layers.order()) {
            if (m_matrix.layers[row].isNegative) {
                negatives.push_back(paintNegative(row));
            }
        }
        const formats::StepRole role = m_isChosen ? formats::StepRole::Shown : formats::StepRole::Copied;
        if (!addNegativeLayers(m_builder, negatives, role, m_parts.progress)) {
            return false;
        }
        for (const formats::NegativeLayer& layer : negatives) {
            m_copies.reportNegativesOfCopies(layer.layer, m_step.layers[m_layers.rowOf(layer.layer)].features.path);
            m_copies.reportClearedNeighbours(layer.layer);
        }
        return true;
    }

    [[nodiscard]] FeatureSource sourceOf(std::size_t row) const {
        const Parsed<FeatureFile>& features = m_step.layers[row].features;
        return {&features.value, features.path, m_nets.linksOf(row), m_parts.job.attributeTypes};
    }

    /// None for layers without holes.
    [[nodiscard]] std::optional<formats::HoleRules> holesOf(std::size_t row) {
        return m_matrix.layers[row].isHoles()
                   ? std::optional<formats::HoleRules>(std::in_place, m_builder.layer(m_layers.id(row)),
                                                       m_step.layers[row].tools.value, m_pins)
                   : std::nullopt;
    }

    void buildLayer(std::size_t row) {
        const Parsed<FeatureFile>& features = m_step.layers[row].features;
        m_builder.beginLayer(m_layers.id(row));
        if (!features.isPresent()) {
            return;
        }
        if (features.value.hasNegatives) {
            paintLayer(row);
        } else {
            const std::optional<formats::HoleRules> holes = holesOf(row);
            addFeatures(m_builder, m_symbols, diagnostics(), sourceOf(row), holes ? &*holes : nullptr);
        }
        m_copies.reportNegativesOfCopies(m_layers.id(row), features.path);
    }

    std::vector<std::uint8_t> paint(DocumentBuilder& scratch, std::size_t row) {
        const std::optional<formats::HoleRules> holes = holesOf(row);
        scratch.beginLayer(scratch.addLayer({}));
        return addFeatures(scratch, m_symbols, diagnostics(), sourceOf(row), holes ? &*holes : nullptr);
    }

    void paintLayer(std::size_t row) {
        DocumentBuilder scratch;
        const std::vector<std::uint8_t> negatives = paint(scratch, row);
        m_copies.reportOwnNegatives(m_layers.id(row), m_step.layers[row].features.path, scratch.soFar(), negatives);
        formats::addPainted(m_builder, scratch.soFar(), negatives, m_step.layers[row].features.path);
    }

    formats::NegativeLayer paintNegative(std::size_t row) {
        formats::NegativeLayer layer;
        layer.layer = m_layers.id(row);
        layer.file = "matrix/matrix";
        layer.line = m_matrix.layers[row].line;
        if (m_step.layers[row].features.isPresent()) {
            layer.painted = std::make_unique<DocumentBuilder>();
            layer.negatives = paint(*layer.painted, row);
        }
        return layer;
    }

    static bool hasNegatives(const JobParts& parts, std::size_t step, LayerId layer) {
        return parts.steps[step].layers[parts.layers.rowOf(layer)].features.value.hasNegatives;
    }

    // ---- profile ----

    void setProfile() {
        const Parsed<FeatureFile>& file = m_step.profile;
        std::optional<ShapeSketch> sketch = profileOf(file.value);
        if (!sketch && !m_isChosen) {
            return;  // a coupon, say, that lies on the substrate of the step that holds it
        }
        const char* why = file.isPresent() ? "the profile holds no outline" : "the step has no profile";
        formats::setOutline(m_builder, std::move(sketch), why,
                            file.isPresent() ? file.path : m_step.folder + "/profile");
    }

    // ---- the rest ----

    static formats::PinLocations pinsOf(const StepData& step) {
        std::vector<Point> pins;
        for (const StepLayer& layer : step.layers) {
            for (const PlacedComponent& component : layer.components.value) {
                for (const PlacedPin& pin : component.pins) {
                    pins.push_back(pin.position);
                }
            }
        }
        return formats::PinLocations(std::move(pins));
    }

    void addNetlists() {
        std::vector<formats::NetlistFile> files;
        for (const Parsed<formats::Netlist>& file : m_step.netlists) {
            files.push_back({&file.value, static_cast<NetlistKind>(files.size()), file.path});
        }
        formats::addNetPoints(m_builder, files);
    }

    void addTools() {
        for (const std::size_t row : m_layers.order()) {
            for (DrillTool tool : m_step.layers[row].tools.value) {
                tool.layer = m_layers.id(row);
                m_builder.addTool(std::move(tool));
            }
        }
    }

    const JobParts& m_parts;
    const Matrix& m_matrix;
    const StepData& m_step;
    bool m_isChosen;  ///< the step the user opened, not one it holds copies of
    DocumentBuilder& m_builder;
    const LayerTable& m_layers;
    formats::StepCopies m_copies;
    SymbolLibrary m_symbols;
    NetLinks m_nets;
    formats::PinLocations m_pins;
    std::vector<formats::RoutedLayer> m_routed;  ///< built when the outline is known
};

/// The document of a step that others hold copies of.
std::shared_ptr<const Document> buildCopied(const JobParts& parts, std::size_t step, const JobInfo& job) {
    DocumentBuilder builder;
    builder.job() = job;
    builder.job().step = parts.steps[step].name;
    parts.layers.copyTo(builder, parts.steps[step]);
    return StepBuilder(parts, step, builder).build() ? builder.finish() : nullptr;
}

}  // namespace

bool buildJob(const JobContext& job, const Steps& steps, std::optional<double> boardNm, DocumentBuilder& builder,
              base::Progress& progress) {
    LayerTable layers(job, steps, builder);
    layers.add(boardNm);
    const std::vector<formats::CopyPlan> plans = planCopies(steps, builder.diagnostics());
    formats::StepDocuments documents(steps.size());
    formats::StepProgress stepProgress(progress, steps.size() * layers.order().size());
    const JobParts parts{job, steps, layers, plans, documents, stepProgress};
    const auto build = [&](std::size_t step) { return buildCopied(parts, step, builder.job()); };
    if (!formats::buildCopiedSteps(plans, documents, build) || !StepBuilder(parts, 0, builder).build()) {
        return false;
    }
    for (const auto& document : documents) {
        if (document != nullptr) {
            builder.diagnostics().append(formats::messagesOfCopies(*document, builder.soFar()));
        }
    }
    return true;
}

}  // namespace model::odb
