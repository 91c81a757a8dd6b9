#include "model/formats/odb/job_builder.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <map>

#include "model/base/parallel.h"
#include "model/board/stackup_checks.h"
#include "model/formats/common/back_drills.h"
#include "model/formats/common/board_outline.h"
#include "model/formats/common/hole_rules.h"
#include "model/formats/common/net_points.h"
#include "model/formats/common/painting.h"
#include "model/formats/odb/copy_plan.h"
#include "model/formats/odb/elements/feature_elements.h"
#include "model/formats/odb/layer_table.h"
#include "model/formats/odb/message_locations.h"
#include "model/formats/odb/parts.h"
#include "model/formats/odb/rigid_flex.h"
#include "model/formats/odb/text/records.h"
#include "model/geometry/region.h"
#include "model/solids/solids.h"

namespace model::odb {

namespace {

/// How far all steps together are; the steps are built side by side.
class StepProgress {
public:
    StepProgress(base::Progress& progress, std::size_t layers) : m_progress(progress), m_layers(layers) {}

    void layerDone() {
        m_progress.setFraction(static_cast<float>(++m_done) / static_cast<float>(std::max<std::size_t>(m_layers, 1)));
    }
    [[nodiscard]] bool isCancelled() const { return m_progress.isCancelled(); }
    [[nodiscard]] const base::Progress& inner() const { return m_progress; }

private:
    base::Progress& m_progress;
    std::size_t m_layers;
    std::atomic<std::size_t> m_done{0};
};

/// What is the same for all steps of the job.
struct JobParts {
    const JobContext& job;
    const Steps& steps;
    const LayerTable& layers;
    const std::vector<CopyPlan>& plans;
    std::vector<std::shared_ptr<const Document>>&
        documents;  ///< by step; those whose copies a step holds are there before it
    StepProgress& progress;
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
          m_plan(parts.plans[step]),
          m_builder(builder),
          m_layers(parts.layers),
          m_symbols(parts.job.tree, parts.job.defaultUnit, builder.diagnostics()),
          m_nets(builder, parts.job.matrix, parts.steps[step]),
          m_pins(pinsOf(parts.steps[step])) {}

    bool build() {
        takeDiagnostics();
        addCopies();
        if (!buildLayers(false)) {
            return false;
        }
        setProfile();
        addOutlines(m_builder, m_matrix, m_layers, m_step);
        if (m_isChosen) {
            reportStackup(m_builder.soFar(), diagnostics());
        }
        if (!buildLayers(true)) {
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

    // ---- copies of other steps ----

    void addCopies() {
        std::map<std::size_t, std::uint32_t> rows;
        for (const PlannedCopy& copy : m_plan.copies) {
            const std::shared_ptr<const Document>& step = m_parts.documents[copy.step];
            if (!isInRange(copy, *step)) {
                continue;
            }
            const auto [location, isNew] = rows.try_emplace(copy.step);
            if (isNew) {
                location->second = m_builder.addStep(step);
            }
            m_builder.addInstance({location->second, copy.placement, copy.isFlipped});
            if (copy.isFlipped) {
                reportOneSided(copy, *step);
            }
        }
    }

    /// Copies must not leave the coordinate range.
    bool isInRange(const PlannedCopy& copy, const Document& step) {
        constexpr double kReach = base::kMaxCoordinate;
        for (const Box& box : {step.extent, step.board}) {
            for (const Point corner : {box.min, {box.max.x, box.min.y}, box.max, {box.min.x, box.max.y}}) {
                const PointD placed = copy.placement.apply(base::toDouble(corner));
                if (!box.isEmpty() && (std::abs(placed.x) > kReach || std::abs(placed.y) > kReach)) {
                    diagnostics().report(
                        Severity::Error, m_step.header.path, copy.line,
                        "a panel copy lies outside of the coordinate range of ±1.07 m; it was left out");
                    return false;
                }
            }
        }
        return true;
    }

    /// What a flipped copy has on a layer without a counterpart lies on no layer of the panel.
    void reportOneSided(const PlannedCopy& copy, const Document& step) {
        for (const Layer& layer : step.layers) {
            const bool hasElements =
                std::ranges::any_of(layer.countsWithCopies, [](std::uint64_t count) { return count > 0; });
            const bool isStacked = layer.side == LayerSide::Top || layer.side == LayerSide::Bottom ||
                                   layer.type == LayerType::Drill || layer.type == LayerType::Rout;
            if (hasElements && isStacked && !layer.opposite.isValid() && layer.context == LayerContext::Board) {
                diagnostics().report(Severity::Warning, m_step.header.path, copy.line,
                                     "layer " + layer.name +
                                         " has no counterpart on the other side; in flipped copies it lies mirrored "
                                         "through the board");
            }
        }
    }

    // ---- elements ----

    /// All layers whose polarity is `isNegative`; negative ones need the profile, so they come last.
    bool buildLayers(bool isNegative) {
        for (const std::size_t row : m_layers.order()) {
            if (m_parts.progress.isCancelled()) {
                return false;
            }
            if (m_matrix.layers[row].isNegative == isNegative) {
                buildLayer(row);
                m_parts.progress.layerDone();
            }
        }
        return true;
    }

    void buildLayer(std::size_t row) {
        const MatrixLayer& layer = m_matrix.layers[row];
        const Parsed<FeatureFile>& features = m_step.layers[row].features;
        m_builder.beginLayer(m_layers.id(row));
        if (!features.isPresent()) {
            return;
        }
        std::optional<formats::HoleRules> holes;
        if (layer.isHoles()) {
            holes.emplace(m_builder.layer(m_layers.id(row)), m_step.layers[row].tools.value, m_pins);
        }
        const FeatureSource source{&features.value, features.path, m_nets.linksOf(row), m_parts.job.attributeTypes};
        if (layer.isNegative || features.value.hasNegatives) {
            paintLayer(row, source, holes ? &*holes : nullptr);
        } else {
            addFeatures(m_builder, m_symbols, diagnostics(), source, holes ? &*holes : nullptr);
        }
        reportNegativesOfCopies(row);
    }

    void paintLayer(std::size_t row, const FeatureSource& source, const formats::HoleRules* holes) {
        DocumentBuilder scratch;
        scratch.beginLayer(scratch.addLayer({}));
        const std::vector<std::uint8_t> negatives = addFeatures(scratch, m_symbols, diagnostics(), source, holes);
        if (!m_matrix.layers[row].isNegative) {
            reportOwnNegatives(row, scratch.soFar(), negatives);
            return formats::addPainted(m_builder, scratch.soFar(), negatives);
        }
        const ShapeId own = m_builder.layer(m_layers.id(row)).profile;
        const ShapeId profile = own.isValid() ? own : m_builder.soFar().profile;
        if (!profile.isValid()) {
            diagnostics().report(
                Severity::Error, "matrix/matrix", m_matrix.layers[row].line,
                "layer " + m_matrix.layers[row].name + " is negative, but the board has no outline; it stays empty");
            return;
        }
        const PolygonSet outline = discretise(m_builder.shapes(), profile, kBooleanChords);
        const std::vector<formats::NetVote> votes =
            formats::votesOn(m_builder.soFar(), m_layers.id(row), scratch.soFar());
        reportInverse(m_matrix.layers[row],
                      formats::addInverse(m_builder, formats::withoutCopies(m_builder.soFar(), outline, kBooleanChords),
                                          scratch.soFar(), negatives, votes));
    }

    void reportInverse(const MatrixLayer& layer, const formats::InverseSummary& summary) {
        diagnostics().report(Severity::Info, "matrix/matrix", layer.line,
                             "layer " + layer.name + " is negative: shown is the board's outline minus its features; " +
                                 std::to_string(summary.pieces - summary.withoutNet) + " of " +
                                 std::to_string(summary.pieces) +
                                 " pieces have a net, that of the plated holes and pads in them");
        if (summary.withSeveralNets > 0) {
            diagnostics().report(Severity::Warning, "matrix/matrix", layer.line,
                                 "layer " + layer.name + ": in " + std::to_string(summary.withSeveralNets) +
                                     " pieces lie holes of several nets; the most frequent one was taken");
        }
    }

    // ---- paint order between a step and its copies ----

    /// Boxes of the copies with elements on this row of the matrix.
    std::vector<Box> copiesOn(std::size_t row, bool withNegatives) {
        std::vector<Box> boxes;
        const Document& own = m_builder.soFar();
        for (const PlannedCopy& copy : m_plan.copies) {
            const LayerId from = own.layerOfCopy(m_layers.id(row), copy.isFlipped);
            const auto& counts = m_parts.documents[copy.step]->layer(from).countsWithCopies;
            const bool isAny = std::ranges::any_of(counts, [](std::uint64_t count) { return count > 0; });
            const std::size_t fromRow = m_layers.rowOf(from);
            if (withNegatives ? m_parts.steps[copy.step].layers[fromRow].features.value.hasNegatives : isAny) {
                boxes.push_back(copy.placement.boxOf(m_parts.documents[copy.step]->extent));
            }
        }
        return boxes;
    }

    void reportOwnNegatives(std::size_t row, const Document& painted, const std::vector<std::uint8_t>& negatives) {
        const std::vector<Box> copies = copiesOn(row, false);
        for (std::size_t i = 0; i < negatives.size() && !copies.empty(); ++i) {
            const Box box = painted.boxOf(ElementId{i});
            if (negatives[i] != 0 && std::ranges::any_of(copies, [&](const Box& copy) { return box.meets(copy); })) {
                return diagnostics().report(
                    Severity::Warning, m_step.layers[row].features.path, painted.elements.line[i],
                    "a negative feature reaches over a copy of another step; it takes nothing away from the copy");
            }
        }
    }

    void reportNegativesOfCopies(std::size_t row) {
        const std::vector<Box> copies = copiesOn(row, true);
        const Document& own = m_builder.soFar();
        const Range range = own.layer(m_layers.id(row)).elements;
        for (std::uint32_t i = range.first; i < range.first + range.count && !copies.empty(); ++i) {
            const Box box = own.boxOf(ElementId{i});
            if (std::ranges::any_of(copies, [&](const Box& copy) { return box.meets(copy); })) {
                return diagnostics().report(Severity::Warning, m_step.layers[row].features.path, own.elements.line[i],
                                            "a copy of another step with negative features lies over this one; they "
                                            "take nothing away from it");
            }
        }
    }

    // ---- profile ----

    void setProfile() {
        const Parsed<FeatureFile>& file = m_step.profile;
        std::optional<ShapeSketch> sketch = profileOf(file.value);
        if (!sketch && !m_isChosen) {
            return;  // a coupon, say, that lies on the substrate of the step that holds it
        }
        const bool isBelieved = sketch && formats::fitsCopper(*sketch, m_builder.soFar());
        if (!isBelieved) {
            const std::string why = sketch             ? "the profile does not enclose the copper"
                                    : file.isPresent() ? "the profile holds no outline"
                                                       : "the step has no profile";
            sketch = formats::outlineOfCopper(m_builder.soFar());
            diagnostics().report(Severity::Warning, file.isPresent() ? file.path : m_step.folder + "/profile", 0,
                                 why + (sketch ? "; the box around all copper is used as the board's outline"
                                               : "; the board has no outline"));
        }
        if (sketch) {
            m_builder.setProfile(m_builder.addShape(*sketch));
        }
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
    const CopyPlan& m_plan;
    DocumentBuilder& m_builder;
    const LayerTable& m_layers;
    SymbolLibrary m_symbols;
    NetLinks m_nets;
    formats::PinLocations m_pins;
};

/// The document of a step that others hold copies of.
std::shared_ptr<const Document> buildCopied(const JobParts& parts, std::size_t step, const JobInfo& job) {
    DocumentBuilder builder;
    builder.job() = job;
    builder.job().step = parts.steps[step].name;
    parts.layers.copyTo(builder, parts.steps[step]);
    return StepBuilder(parts, step, builder).build() ? builder.finish() : nullptr;
}

/// Builds the steps that the chosen one holds copies of, each once: those without copies first, then those that hold
/// only these, and so on; steps of one height side by side.
bool buildCopies(const JobParts& parts, const JobInfo& job) {
    for (int height = 0; height < parts.plans[0].height; ++height) {
        std::vector<std::size_t> rows;
        for (std::size_t step = 1; step < parts.steps.size(); ++step) {
            if (parts.plans[step].height == height) {
                rows.push_back(step);
            }
        }
        base::parallelFor(rows.size(),
                          [&](std::size_t i) { parts.documents[rows[i]] = buildCopied(parts, rows[i], job); });
        if (parts.progress.isCancelled()) {
            return false;
        }
    }
    return true;
}

}  // namespace

bool buildJob(const JobContext& job, const Steps& steps, std::optional<double> boardNm, DocumentBuilder& builder,
              base::Progress& progress) {
    LayerTable layers(job, steps, builder);
    layers.add(boardNm);
    const std::vector<CopyPlan> plans = planCopies(steps, builder.diagnostics());
    std::vector<std::shared_ptr<const Document>> documents(steps.size());
    StepProgress stepProgress(progress, steps.size() * layers.order().size());
    const JobParts parts{job, steps, layers, plans, documents, stepProgress};
    if (!buildCopies(parts, builder.job()) || !StepBuilder(parts, 0, builder).build()) {
        return false;
    }
    for (const auto& document : documents) {
        if (document != nullptr) {
            builder.diagnostics().append(messagesOfCopies(*document, builder.soFar()));
        }
    }
    return true;
}

}  // namespace model::odb
