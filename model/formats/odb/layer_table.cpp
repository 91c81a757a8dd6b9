#include "model/formats/odb/layer_table.h"

#include <algorithm>
#include <cmath>

#include "model/board/flip.h"
#include "model/board/local_stack.h"
#include "model/board/stackup.h"
#include "model/formats/odb/rigid_flex.h"
#include "model/formats/odb/stackup/layer_facts.h"
#include "model/formats/odb/stackup/stackup_xml.h"
#include "model/formats/odb/text/records.h"

namespace model::odb {

namespace {

/// By how much a step may differ from the layers: it may count the solder mask.
constexpr double kStepTolerance = 0.05;

void describeFeatures(const StepLayer& source, Layer& layer) {
    layer.file = source.features.path;
    layer.featureCount = static_cast<std::uint32_t>(source.features.value.features.size());
}

/// Is the layer held against limits, so that a board without its features must not pass?
bool isChecked(const MatrixLayer& layer) {
    const bool isKind = layer.isCopper() || layer.isHoles() || layer.type == LayerType::SolderMask ||
                        layer.type == LayerType::SilkScreen;
    return isKind && layer.context == LayerContext::Board;
}

}  // namespace

LayerTable::LayerTable(const JobContext& job, const Steps& steps, DocumentBuilder& builder)
    : m_job(job),
      m_matrix(job.matrix),
      m_steps(steps),
      m_builder(builder),
      m_order(physicalOrder(job.matrix.layers, "matrix/matrix", builder.diagnostics())) {}

void LayerTable::add(std::optional<double> boardNm) {
    addLayers();
    setSpans();
    addStackup(boardNm);
    setOpposites(m_builder.layers());
}

void LayerTable::addLayers() {
    m_layerOfRow.resize(m_matrix.layers.size());
    const std::vector<std::uint32_t> groups = outlineGroups(m_steps, m_matrix);
    for (const std::size_t row : m_order) {
        const MatrixLayer& source = m_matrix.layers[row];
        Layer layer;
        layer.name = source.name;
        layer.type = source.type;
        layer.context = source.context;
        layer.isNegative = source.isNegative;
        layer.useName = source.useName;
        layer.use = source.use;
        layer.outlineGroup = groups[row];
        describeFeatures(m_steps[0].layers[row], layer);
        reportMissing(row);
        m_layerOfRow[row] = m_builder.addLayer(std::move(layer));
    }
    reportEmptyLayers();
    reportUnread();
}

void LayerTable::reportUnread() {
    const std::string& step = m_steps[0].folder;
    if (m_job.tree.has(step + "/impedance.xml")) {
        diagnostics().report(Severity::Info, step + "/impedance.xml", 0,
                             "impedance requirements are not read; nothing of the board's shape depends on them");
    }
    if (!m_steps[0].eda.isPresent()) {
        diagnostics().report(Severity::Info, step + "/eda/data", 0,
                             "the step has no eda/data; its elements have no nets");
    }
}

void LayerTable::reportMissing(std::size_t row) {
    const MatrixLayer& layer = m_matrix.layers[row];
    const bool mayBeBare = layer.type == LayerType::Dielectric || layer.type == LayerType::Component;
    if (mayBeBare || isRepeatedName(row)) {
        return;
    }
    const auto anyStep = [this](const auto& holds) { return std::ranges::any_of(m_steps, holds); };
    const std::string folder = "/layers/" + layer.name;
    const Severity severity = isChecked(layer) ? Severity::Error : Severity::Warning;
    if (!anyStep([&](const StepData& step) { return m_job.tree.hasFolder(step.folder + folder); })) {
        diagnostics().report(
            severity, "matrix/matrix", layer.line,
            "layer " + layer.name + " is in the matrix, but the step has no folder for it; it stays empty");
    } else if (!anyStep([row](const StepData& step) { return step.layers[row].features.isPresent(); })) {
        diagnostics().report(severity, m_steps[0].folder + folder, 0,
                             "layer " + layer.name + " has no features file; it stays empty");
    } else if (!anyStep([row](const StepData& step) { return !step.layers[row].features.value.features.empty(); })) {
        m_emptyLayers += (m_emptyLayers.empty() ? "" : ", ") + layer.name;
    }
}

/// One entry for all: writers list every layer their program knows.
void LayerTable::reportEmptyLayers() {
    if (!m_emptyLayers.empty()) {
        diagnostics().report(Severity::Info, m_steps[0].folder, 0,
                             "layers whose features file holds no features: " + m_emptyLayers);
    }
}

bool LayerTable::isRepeatedName(std::size_t row) const {
    const bool isRepeated = m_matrix.rowOf(m_matrix.layers[row].name) < row;
    if (isRepeated) {
        diagnostics().report(
            Severity::Info, "matrix/matrix", m_matrix.layers[row].line,
            "layer " + m_matrix.layers[row].name + " is listed twice; its features are in the first one");
    }
    return isRepeated;
}

/// Copper layers of the board from the top.
std::vector<LayerId> LayerTable::copperLayers() const {
    std::vector<LayerId> copper;
    for (const std::size_t row : m_order) {
        if (m_matrix.layers[row].isCopper() && m_matrix.layers[row].context == LayerContext::Board) {
            copper.push_back(m_layerOfRow[row]);
        }
    }
    return copper;
}

/// Either direction; empty means through all copper.
void LayerTable::setSpans() {
    const std::vector<LayerId> copper = copperLayers();
    for (std::size_t row = 0; row < m_matrix.layers.size() && !copper.empty(); ++row) {
        if (!m_matrix.layers[row].isHoles()) {
            continue;
        }
        Layer& layer = m_builder.layer(m_layerOfRow[row]);
        const LayerId start = spanEnd(copper, row, m_matrix.layers[row].startName, copper.front());
        const LayerId end = spanEnd(copper, row, m_matrix.layers[row].endName, copper.back());
        layer.spanTop = std::min(start, end);  // layer ids rise from the top
        layer.spanBottom = std::max(start, end);
    }
}

LayerId LayerTable::spanEnd(const std::vector<LayerId>& copper, std::size_t row, const std::string& name,
                            LayerId otherwise) const {
    if (name.empty()) {
        return otherwise;
    }
    for (const LayerId id : copper) {
        if (equalsIgnoringCase(m_builder.layer(id).name, name)) {
            return id;
        }
    }
    diagnostics().report(Severity::Warning, "matrix/matrix", m_matrix.layers[row].line,
                         "layer " + m_matrix.layers[row].name + ": its span ends at " + name +
                             ", which is no copper layer; the outer copper is used");
    return otherwise;
}

/// What the first step that says anything about the layer says.
LayerFacts LayerTable::factsOf(std::size_t row) const {
    for (const StepData& step : m_steps) {
        const LayerFacts& facts = step.layers[row].facts.value;
        if (facts.thicknessNm || facts.belowNm || facts.material.dielectricConstant) {
            return facts;
        }
    }
    return {};
}

/// Is it printed or deposited only where it is drawn, and drawn nowhere? A solder mask that draws nothing has no
/// openings instead, and a coverlay, adhesive or stiffener may be where its zone is.
bool LayerTable::isEmptyMaterial(std::size_t row) const {
    const MatrixLayer& layer = m_matrix.layers[row];
    const bool isDrawn =
        layer.type == LayerType::ConductivePaste || (layer.type == LayerType::Mask && !isLaidOn(layer.use));
    return isDrawn && isPhysical(layer) && std::ranges::none_of(m_steps, [row](const StepData& step) {
               return !step.layers[row].features.value.features.empty() || step.layers[row].profile.isPresent();
           });
}

/// What is no material of the board is left out of the stackup.
void LayerTable::leaveOut(std::vector<LayerFacts>& facts) {
    std::string markers;
    std::string empty;
    for (std::size_t i = 0; i < m_order.size(); ++i) {
        const MatrixLayer& layer = m_matrix.layers[m_order[i]];
        if (!isMarker(layer) && !isEmptyMaterial(m_order[i])) {
            continue;
        }
        facts[i].hasMaterial = false;
        std::string& names = isMarker(layer) ? markers : empty;
        names += (names.empty() ? "" : ", ") + layer.name;
    }
    if (!markers.empty()) {
        diagnostics().report(Severity::Info, "matrix/matrix", 0,
                             "layers that mark areas or process steps are not part of the stackup: " + markers);
    }
    if (!empty.empty()) {
        diagnostics().report(Severity::Info, "matrix/matrix", 0,
                             "masks and pastes that draw nothing are not part of the stackup: " + empty);
    }
}

void LayerTable::addStackup(std::optional<double> boardNm) {
    const std::string attributes = m_steps[0].folder + "/attrlist";
    const std::optional<double> stepNm = boardThicknessIn(m_job.tree, attributes, m_job.defaultUnit, diagnostics());
    StackupFacts facts;
    facts.boardNm = boardNm && *boardNm > 0 ? boardNm : stepNm;
    for (const std::size_t row : m_order) {
        facts.layers.push_back(factsOf(row));
        addMatrixFacts(m_matrix.layers[row], facts.layers.back().material);
    }
    leaveOut(facts.layers);
    if (const auto file = m_job.tree.read("matrix/stackup.xml", diagnostics())) {
        mergeStackupXml(parseStackupXml(file->text(), file->path, diagnostics()), file->path, m_builder.layers(), facts,
                        diagnostics());
    }
    Stackup stackup = buildStackup(m_builder.layers(), std::move(facts), diagnostics());
    compareWithStep(stackup, stepNm, attributes);
    m_builder.setBoardThickness(thicknessOf(stackup));
    m_builder.setStackup(std::move(stackup));
}

/// Where the job and its step disagree about the board, the job counts.
void LayerTable::compareWithStep(const Stackup& stackup, std::optional<double> stepNm, const std::string& path) {
    const double layers = thicknessOf(stackup);
    const bool isCompared = stepNm && *stepNm > 0 && stackup.facts.boardNm != stepNm;
    if (isCompared && std::abs(*stepNm - layers) > kStepTolerance * layers) {
        diagnostics().report(Severity::Warning, path, 0,
                             "the step says the board is " + std::to_string(std::lround(*stepNm / 1000)) +
                                 " µm thick, but its layers add up to " + std::to_string(std::lround(layers / 1000)) +
                                 " µm; the layers are used");
    }
}

void LayerTable::copyTo(DocumentBuilder& builder, const StepData& step) const {
    for (const std::size_t row : m_order) {
        Layer layer = m_builder.soFar().layer(m_layerOfRow[row]);
        layer.elements = {};
        layer.counts = {};
        layer.profile = {};
        describeFeatures(step.layers[row], layer);
        builder.addLayer(std::move(layer));
    }
    builder.setBoardThickness(m_builder.soFar().boardThickness);
    builder.setStackup(m_builder.soFar().stackup);
}

}  // namespace model::odb
