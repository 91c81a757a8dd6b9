#include "ui/layers/layer_model.h"

#include <algorithm>
#include <iterator>
#include <numeric>

#include "model/base/assert.h"
#include "ui/common/thickness_text.h"

namespace ui {

bool drawsNothing(const model::Layer& layer) {
    return std::ranges::all_of(layer.countsWithCopies, [](auto count) { return count == 0; });
}

QString layerGroupText(model::LayerGroup group) {
    using model::LayerGroup;
    switch (group) {
        case LayerGroup::Copper: return LayerModel::tr("Copper");
        case LayerGroup::SolderMask: return LayerModel::tr("Solder mask");
        case LayerGroup::Paste: return LayerModel::tr("Solder paste");
        case LayerGroup::Silkscreen: return LayerModel::tr("Silkscreen");
        case LayerGroup::Drill: return LayerModel::tr("Drill and routing");
        case LayerGroup::Components: return LayerModel::tr("Components");
        case LayerGroup::Mechanical: return LayerModel::tr("Mechanical");
        case LayerGroup::Dielectric: return LayerModel::tr("Dielectric");
        case LayerGroup::Other: return LayerModel::tr("Other");
    }
    return {};
}

QString layerTypeText(model::LayerType type) {
    using model::LayerType;
    switch (type) {
        case LayerType::Signal: return LayerModel::tr("Signal");
        case LayerType::PowerGround: return LayerModel::tr("Power plane");
        case LayerType::Mixed: return LayerModel::tr("Mixed copper");
        case LayerType::Dielectric: return LayerModel::tr("Dielectric");
        case LayerType::SolderMask: return LayerModel::tr("Solder mask");
        case LayerType::SolderPaste: return LayerModel::tr("Solder paste");
        case LayerType::SilkScreen: return LayerModel::tr("Silkscreen");
        case LayerType::Drill: return LayerModel::tr("Drill");
        case LayerType::Rout: return LayerModel::tr("Routing");
        case LayerType::Component: return LayerModel::tr("Components");
        case LayerType::Mask: return LayerModel::tr("Mask");
        case LayerType::ConductivePaste: return LayerModel::tr("Conductive paste");
        case LayerType::Document: return LayerModel::tr("Document");
        case LayerType::Profile: return LayerModel::tr("Board outline");
        case LayerType::Body: return LayerModel::tr("Board substrate");
        case LayerType::ComponentBody: return LayerModel::tr("Component bodies");
        case LayerType::Other: return LayerModel::tr("Other");
    }
    return {};
}

namespace {

bool isDrilledThrough(const model::Layer& holes, model::LayerId layer) {
    return model::groupOf(holes) == model::LayerGroup::Drill && holes.spans(layer);
}

}  // namespace

LayerModel::LayerModel(QObject* parent)
    : TableModel({{tr("Show"), tr("Draw the layer (Space)"), kCheck},
                  {tr("Colour"), tr("Colour on the canvas (Enter changes it)"), kColour | kEditable},
                  {tr("Layer"), tr("Name in the job")},
                  {tr("Type"), tr("What the layer is for")},
                  {tr("Opacity"), tr("Drag in the cell, or press Enter and type"), kPercent | kEditable},
                  {tr("Solo"), tr("Draw this layer alone (Space)"), kCheck}},
                 parent) {}

void LayerModel::setDocument(std::shared_ptr<const model::Document> document, std::vector<LayerAppearance> defaults) {
    ASSERT(defaults.size() == (document ? document->layers.size() : 0));
    beginResetModel();
    m_document = std::move(document);
    m_styles = defaults;
    m_defaults = std::move(defaults);
    m_solo = {};
    endResetModel();
    emit stylesChanged();
}

void LayerModel::setHeights(std::shared_ptr<const model::Document> document) {
    m_document = std::move(document);  // only tips show heights, and they are made anew
}

std::vector<LayerAppearance> LayerModel::effectiveStyles() const {
    std::vector<LayerAppearance> styles = m_styles;
    if (m_solo.isValid()) {
        for (std::size_t row = 0; row < styles.size(); ++row) {
            styles[row].isVisible =
                row == m_solo.row() || (styles[row].isVisible && isDrilledThrough(m_document->layers[row], m_solo));
        }
    }
    return styles;
}

template <class Change>
void LayerModel::change(const QString& what, int cell, const Change& apply) {
    LayerEdit edit{what, settings(), {}, cell};
    apply();
    edit.after = settings();
    if (edit.after != edit.before) {
        announceAllChanged();
        emit edited(edit);
    }
}

void LayerModel::setVisibility(const std::vector<bool>& isVisible) {
    change(tr("showing layers"), -1, [&] {
        m_solo = {};
        for (std::size_t row = 0; row < m_styles.size(); ++row) {
            m_styles[row].isVisible = isVisible[row];
        }
    });
}

void LayerModel::showPreset(model::LayerPreset preset) {
    if (m_document) {
        setVisibility(model::layersOf(*m_document, preset));
    }
}

void LayerModel::showDefaultSet() {
    setVisibility(defaultVisibility());
}

void LayerModel::showOnly(const std::vector<std::string>& names) {
    std::vector<bool> isVisible;
    for (std::size_t row = 0; row < m_styles.size(); ++row) {
        isVisible.push_back(std::ranges::find(names, m_document->layers[row].name) != names.end());
    }
    setVisibility(isVisible);
}

void LayerModel::showLayers(std::span<const model::LayerId> layers) {
    std::vector<bool> isVisible(m_styles.size());
    for (const model::LayerId layer : layers) {
        isVisible[layer.row()] = true;
    }
    setVisibility(isVisible);
}

void LayerModel::offerSets(std::vector<model::session::LayerSet> sets) {
    m_offered = std::move(sets);
    emit stylesChanged();
}

void LayerModel::setVisible(std::span<const model::LayerId> layers, bool isVisible) {
    if (layers.empty()) {
        return;
    }
    change(isVisible ? tr("showing a layer") : tr("hiding a layer"), -1, [&] {
        m_solo = {};
        for (const model::LayerId layer : layers) {
            m_styles[layer.row()].isVisible = isVisible;
        }
    });
}

void LayerModel::show(model::LayerId layer) {
    if (layer != m_solo) {
        setVisible({&layer, 1}, true);
    }
}

std::vector<bool> LayerModel::visibility() const {
    std::vector<bool> isVisible;
    std::ranges::transform(m_styles, std::back_inserter(isVisible), &LayerAppearance::isVisible);
    return isVisible;
}

std::vector<bool> LayerModel::defaultVisibility() const {
    std::vector<bool> isVisible;
    std::ranges::transform(m_defaults, std::back_inserter(isVisible), &LayerAppearance::isVisible);
    return isVisible;
}

LayerSettings LayerModel::settings() const {
    LayerSettings settings{m_styles, m_solo};
    for (std::size_t row = 0; row < m_styles.size(); ++row) {
        if (m_styles[row].colour == m_defaults[row].colour) {
            settings.styles[row].colour = QColor();
        }
    }
    return settings;
}

void LayerModel::setSettings(const LayerSettings& settings) {
    ASSERT(settings.styles.size() == m_styles.size());
    if (settings == this->settings()) {
        return;
    }
    m_styles = settings.styles;
    m_solo = settings.solo;
    for (std::size_t row = 0; row < m_styles.size(); ++row) {
        if (!m_styles[row].colour.isValid()) {
            m_styles[row].colour = m_defaults[row].colour;
        }
    }
    announceAllChanged();
}

std::vector<std::string> LayerModel::visibleNames() const {
    std::vector<std::string> names;
    const std::vector<LayerAppearance> styles = effectiveStyles();
    for (std::size_t row = 0; row < styles.size(); ++row) {
        if (styles[row].isVisible) {
            names.push_back(m_document->layers[row].name);
        }
    }
    return names;
}

std::vector<model::session::LayerState> LayerModel::states() const {
    std::vector<model::session::LayerState> states;
    for (std::size_t row = 0; row < m_styles.size(); ++row) {
        const LayerAppearance& style = m_styles[row];
        states.push_back({m_document->layers[row].name, style.isVisible, style.opacityPercent, std::nullopt});
        if (style.colour != m_defaults[row].colour) {
            states.back().rgb = style.colour.rgb() & 0xffffffU;
        }
    }
    return states;
}

void LayerModel::setStates(const std::vector<model::session::LayerState>& states) {
    m_solo = {};
    for (const model::session::LayerState& state : states) {
        for (std::size_t row = 0; row < m_styles.size(); ++row) {
            if (m_document->layers[row].name == state.layer) {
                m_styles[row].isVisible = state.isVisible;
                m_styles[row].opacityPercent = state.opacityPercent;
                m_styles[row].colour = state.rgb ? QColor::fromRgb(*state.rgb) : m_defaults[row].colour;
            }
        }
    }
    announceAllChanged();
}

void LayerModel::setDefaults(std::vector<LayerAppearance> defaults) {
    ASSERT(defaults.size() == m_styles.size());
    for (std::size_t row = 0; row < m_styles.size(); ++row) {
        if (m_styles[row].colour == m_defaults[row].colour) {
            m_styles[row].colour = defaults[row].colour;
        }
    }
    m_defaults = std::move(defaults);
    announceAllChanged();
}

void LayerModel::setBoardColours(const model::BoardColourChoice& chosen) {
    m_boardColours = chosen;
    emit boardColoursChanged();
}

void LayerModel::restoreDefaults() {
    change(tr("default layers"), -1, [this] {
        m_solo = {};
        m_styles = m_defaults;
    });
}

void LayerModel::toggleSolo(model::LayerId layer) {
    ASSERT(!layer.isValid() || layer.row() < m_styles.size());
    const int soloCell = rows() * columnCount();  // behind all that can be edited
    change(tr("showing a layer alone"), soloCell, [&] { m_solo = layer == m_solo ? model::LayerId{} : layer; });
}

void LayerModel::announceAllChanged() {
    if (!m_styles.empty()) {
        announceChange();
        emit stylesChanged();
    }
}

/// What a layer that draws nothing is set to changes no picture: its row is grey.
Cell LayerModel::cell(int row, int column) const {
    Cell cell = settingOf(row, column);
    if (drawsNothing(m_document->layers[static_cast<std::size_t>(row)])) {
        cell.colour = QColor(Qt::gray);
    }
    return cell;
}

Cell LayerModel::settingOf(int row, int column) const {
    const model::Layer& layer = m_document->layers[static_cast<std::size_t>(row)];
    const LayerAppearance& style = m_styles[static_cast<std::size_t>(row)];
    switch (column) {
        case Visible: return {.isChecked = style.isVisible};
        case Colour: return {{}, style.colour};
        case Name: return {QString::fromStdString(layer.name)};
        case Type: return {layerTypeText(layer.type)};
        case Opacity: return {QStringLiteral("%1 %").arg(style.opacityPercent), style.opacityPercent};
        default: return {.isChecked = m_solo == model::LayerId{static_cast<std::size_t>(row)}};
    }
}

QString LayerModel::tip(int row, int) const {
    const model::Layer& layer = m_document->layers[static_cast<std::size_t>(row)];
    QString text = QString::fromStdString(layer.name) + '\n' + layerTypeText(layer.type);
    if (model::isDrawingAsSilkscreen(layer)) {
        text += tr(" in the job, a drawing by its name: shown as one");
    }
    if (layer.side != model::LayerSide::None) {
        text += QStringLiteral(", ") + model::toString(layer.side);
    }
    if (layer.thickness > 0) {
        text += '\n' + tr("%1 thick (%2), from z = %3")
                           .arg(thicknessText(layer.thickness, unit()), model::toString(layer.thicknessSource),
                                heightText(layer.z, unit()));
    }
    if (!layer.useName.empty()) {
        text += '\n' + tr("Made as %1").arg(QString::fromStdString(layer.useName));
    }
    if (drawsNothing(layer)) {
        return text + '\n' + tr("No elements: there is nothing to show");
    }
    const auto all = std::accumulate(layer.countsWithCopies.begin(), layer.countsWithCopies.end(), qulonglong{0});
    return text + '\n' + tr("%1 elements").arg(all);
}

bool LayerModel::check(int row, int column, bool isChecked) {
    if (column == Solo) {
        const model::LayerId layer{static_cast<std::size_t>(row)};
        if (isChecked != (layer == m_solo)) {
            toggleSolo(layer);
        }
        return true;
    }
    const model::LayerId layer{static_cast<std::size_t>(row)};
    setVisible({&layer, 1}, isChecked);
    return true;
}

bool LayerModel::edit(int row, int column, const QVariant& value) {
    LayerAppearance& style = m_styles[static_cast<std::size_t>(row)];
    const int cell = row * columnCount() + column;
    if (column == Colour && value.value<QColor>().isValid()) {
        change(tr("the colour of a layer"), cell, [&] { style.colour = value.value<QColor>(); });
    } else if (column == Opacity && value.canConvert<int>()) {
        change(tr("the opacity of a layer"), cell, [&] { style.opacityPercent = std::clamp(value.toInt(), 0, 100); });
    } else {
        return false;
    }
    return true;
}

std::vector<QColor> LayerModel::colours() const {
    std::vector<QColor> colours;
    for (const LayerAppearance& appearance : effectiveStyles()) {
        colours.push_back(appearance.colour);
    }
    return colours;
}

}  // namespace ui
