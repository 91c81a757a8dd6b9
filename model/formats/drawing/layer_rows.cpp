#include "model/formats/drawing/layer_rows.h"

#include <algorithm>
#include <numeric>

#include "model/board/flip.h"
#include "model/board/holes.h"
#include "model/board/local_stack.h"
#include "model/board/stackup.h"
#include "model/formats/drawing/layer_outlines.h"

namespace model::formats {

namespace {

bool isBoardCopper(const DrawnLayer& layer) {
    const bool isCopper =
        layer.type == LayerType::Signal || layer.type == LayerType::PowerGround || layer.type == LayerType::Mixed;
    return isCopper && layer.context == LayerContext::Board;
}

/// Is it printed or deposited only where it is drawn?
bool isOnlyWhereDrawn(const DrawnLayer& layer) {
    return layer.type == LayerType::ConductivePaste || (layer.type == LayerType::Mask && !isLaidOn(layer.use));
}

void addName(std::string& names, const std::string& name) {
    names += (names.empty() ? "" : ", ") + name;
}

}  // namespace

std::span<const DrawnFeature> featuresOf(const DrawnStep& step, std::size_t row) {
    return row < step.features.size() ? std::span<const DrawnFeature>(step.features[row])
                                      : std::span<const DrawnFeature>();
}

bool isPhysical(const DrawnLayer& layer) {
    switch (layer.type) {
        case LayerType::Dielectric:
        case LayerType::SolderMask:
        case LayerType::SolderPaste:
        case LayerType::SilkScreen:
        case LayerType::ConductivePaste:
        case LayerType::Mask: return layer.context == LayerContext::Board && layer.facts.hasMaterial;
        default: return isBoardCopper(layer);
    }
}

LayerRows::LayerRows(const DrawnJob& job, DocumentBuilder& builder)
    : m_job(job), m_builder(builder), m_order(job.layers.size()), m_layerOfRow(job.layers.size()) {
    std::iota(m_order.begin(), m_order.end(), std::size_t{0});
    std::stable_partition(m_order.begin(), m_order.end(),
                          [&job](std::size_t row) { return isPhysical(job.layers[row]); });
}

Layer LayerRows::layerOf(std::size_t row) const {
    const DrawnLayer& from = m_job.layers[row];
    Layer layer;
    layer.name = from.name;
    layer.file = from.file;
    layer.type = from.type;
    layer.context = from.context;
    layer.side = from.side;
    layer.isNegative = from.isNegative;
    layer.use = from.use;
    layer.useName = from.useName;
    layer.featureCount = static_cast<std::uint32_t>(featuresOf(m_job.steps[0], row).size());
    return layer;
}

void LayerRows::add() {
    const std::vector<std::uint32_t> groups = outlineGroups(m_job);
    for (const std::size_t row : m_order) {
        Layer layer = layerOf(row);
        layer.outlineGroup = groups[row];
        m_layerOfRow[row] = m_builder.addLayer(std::move(layer));
    }
    reportEmptyLayers();
    setSpans();
    addStackup();
    setOpposites(m_builder.layers());
}

void LayerRows::copyTo(DocumentBuilder& builder, std::size_t step) const {
    for (const std::size_t row : m_order) {
        Layer layer = m_builder.soFar().layer(m_layerOfRow[row]);
        layer.elements = {};
        layer.counts = {};
        layer.profile = {};
        layer.featureCount = static_cast<std::uint32_t>(featuresOf(m_job.steps[step], row).size());
        builder.addLayer(std::move(layer));
    }
    builder.setBoardThickness(m_builder.soFar().boardThickness);
    builder.setStackup(m_builder.soFar().stackup);
}

bool LayerRows::isDrawnOn(std::size_t row) const {
    return std::ranges::any_of(m_job.steps, [row](const DrawnStep& step) { return !featuresOf(step, row).empty(); });
}

/// One entry for all: writers list every layer their program knows.
void LayerRows::reportEmptyLayers() const {
    std::string names;
    for (const std::size_t row : m_order) {
        const LayerType type = m_job.layers[row].type;
        if (type != LayerType::Dielectric && type != LayerType::Component && !isDrawnOn(row)) {
            addName(names, m_job.layers[row].name);
        }
    }
    if (!names.empty()) {
        m_builder.diagnostics().report(Severity::Info, "", 0, "layers on which nothing is drawn: " + names);
    }
}

/// Either direction; none means through all copper.
void LayerRows::setSpans() {
    std::vector<LayerId> copper;
    for (const std::size_t row : m_order) {
        if (isBoardCopper(m_job.layers[row])) {
            copper.push_back(m_layerOfRow[row]);
        }
    }
    for (std::size_t row = 0; row < m_job.layers.size() && !copper.empty(); ++row) {
        if (!isHoles(m_job.layers[row].type)) {
            continue;
        }
        const LayerId start = spanEnd(row, m_job.layers[row].spanTop, copper.front());
        const LayerId end = spanEnd(row, m_job.layers[row].spanBottom, copper.back());
        Layer& layer = m_builder.layer(m_layerOfRow[row]);
        layer.spanTop = std::min(start, end);  // layer ids rise from the top
        layer.spanBottom = std::max(start, end);
    }
}

LayerId LayerRows::spanEnd(std::size_t row, std::int32_t end, LayerId otherwise) const {
    if (end == kNoRow) {
        return otherwise;
    }
    const auto index = static_cast<std::size_t>(end);
    if (index < m_job.layers.size() && isBoardCopper(m_job.layers[index])) {
        return m_layerOfRow[index];
    }
    m_builder.diagnostics().report(
        Severity::Warning, m_job.layers[row].file, 0,
        "layer " + m_job.layers[row].name + ": its span ends at what is no copper layer; the outer copper is used");
    return otherwise;
}

/// What draws nothing of what it is made of is left out of the stackup.
void LayerRows::leaveOut(std::vector<LayerFacts>& facts) const {
    std::string empty;
    for (std::size_t i = 0; i < m_order.size(); ++i) {
        const DrawnLayer& layer = m_job.layers[m_order[i]];
        if (isPhysical(layer) && isOnlyWhereDrawn(layer) && layer.outline.isEmpty() && !isDrawnOn(m_order[i])) {
            facts[i].hasMaterial = false;
            addName(empty, layer.name);
        }
    }
    if (!empty.empty()) {
        m_builder.diagnostics().report(Severity::Info, "", 0,
                                       "masks and pastes that draw nothing are not part of the stackup: " + empty);
    }
}

void LayerRows::addStackup() {
    StackupFacts facts;
    if (m_job.boardNm && *m_job.boardNm > 0) {
        facts.boardNm = m_job.boardNm;
    }
    for (const std::size_t row : m_order) {
        facts.layers.push_back(m_job.layers[row].facts);
    }
    leaveOut(facts.layers);
    Stackup stackup = buildStackup(m_builder.layers(), std::move(facts), m_builder.diagnostics());
    m_builder.setBoardThickness(thicknessOf(stackup));
    m_builder.setStackup(std::move(stackup));
}

}  // namespace model::formats
