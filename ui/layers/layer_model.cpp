#include "ui/layers/layer_model.h"

#include <algorithm>
#include <numeric>

#include "model/base/assert.h"

namespace ui {

namespace {

struct ColumnText {
    const char* heading;
    const char* tip;
};

constexpr ColumnText kColumns[LayerModel::ColumnCount] = {
    {"Show", "Draw the layer (Space)"},
    {"Colour", "Colour on the canvas (Enter changes it)"},
    {"Layer", "Name in the job"},
    {"Type", "What the layer is for"},
    {"Opacity", "Drag in the cell, or press Enter and type"},
    {"Solo", "Draw this layer alone (Space)"},
};

QString micrometres(model::Nm nm) {
    return QString::number(static_cast<double>(nm) / base::kNmPerUm, 'g', 6) + QStringLiteral(" µm");
}

QString layerTip(const model::Layer& layer) {
    QString text = QString::fromStdString(layer.name) + '\n' + layerTypeText(layer.type);
    if (layer.side != model::LayerSide::None) {
        text += QStringLiteral(", ") + model::toString(layer.side);
    }
    if (layer.thickness > 0) {
        text +=
            '\n' + QStringLiteral("%1 thick (%2), from z = %3")
                       .arg(micrometres(layer.thickness), model::toString(layer.thicknessSource), micrometres(layer.z));
    }
    if (!layer.addType.empty()) {
        text += '\n' + QStringLiteral("Made as %1").arg(QString::fromStdString(layer.addType));
    }
    const auto all = std::accumulate(layer.countsWithCopies.begin(), layer.countsWithCopies.end(), qulonglong{0});
    return text + '\n' + QStringLiteral("%1 elements").arg(all);
}

Qt::CheckState checkState(bool isOn) {
    return isOn ? Qt::Checked : Qt::Unchecked;
}

}  // namespace

QString layerTypeText(model::LayerType type) {
    using model::LayerType;
    switch (type) {
        case LayerType::Signal: return QStringLiteral("Signal");
        case LayerType::PowerGround: return QStringLiteral("Power plane");
        case LayerType::Mixed: return QStringLiteral("Mixed copper");
        case LayerType::Dielectric: return QStringLiteral("Dielectric");
        case LayerType::SolderMask: return QStringLiteral("Solder mask");
        case LayerType::SolderPaste: return QStringLiteral("Solder paste");
        case LayerType::SilkScreen: return QStringLiteral("Silk screen");
        case LayerType::Drill: return QStringLiteral("Drill");
        case LayerType::Rout: return QStringLiteral("Rout");
        case LayerType::Component: return QStringLiteral("Components");
        case LayerType::Mask: return QStringLiteral("Mask");
        case LayerType::ConductivePaste: return QStringLiteral("Conductive paste");
        case LayerType::Document: return QStringLiteral("Document");
        case LayerType::Profile: return QStringLiteral("Board outline");
        case LayerType::Body: return QStringLiteral("Board body");
        case LayerType::ComponentBody: return QStringLiteral("Component bodies");
        case LayerType::Other: return QStringLiteral("Other");
    }
    return {};
}

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
    m_document = std::move(document);  // heights are told in tips, which are asked for anew
}

std::vector<LayerAppearance> LayerModel::effectiveStyles() const {
    std::vector<LayerAppearance> styles = m_styles;
    if (m_solo.isValid()) {
        for (std::size_t row = 0; row < styles.size(); ++row) {
            styles[row].isVisible = row == m_solo.row();
        }
    }
    return styles;
}

template <class Rule>
void LayerModel::setVisibility(const Rule& rule) {
    m_solo = {};
    for (std::size_t row = 0; row < m_styles.size(); ++row) {
        m_styles[row].isVisible = rule(m_document->layers[row]);
    }
    announceAllChanged();
}

void LayerModel::showAll() {
    setVisibility([](const model::Layer&) { return true; });
}

void LayerModel::hideAll() {
    setVisibility([](const model::Layer&) { return false; });
}

void LayerModel::showCopperOnly() {
    setVisibility([](const model::Layer& layer) { return layer.isCopper(); });
}

void LayerModel::showOnly(const std::vector<std::string>& names) {
    setVisibility([&](const model::Layer& layer) { return std::ranges::find(names, layer.name) != names.end(); });
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
        const LayerAppearance& look = m_styles[row];
        states.push_back({m_document->layers[row].name, look.isVisible, look.opacityPercent, std::nullopt});
        if (look.colour != m_defaults[row].colour) {
            states.back().rgb = look.colour.rgb() & 0xffffffU;
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

void LayerModel::restoreDefaults() {
    m_solo = {};
    m_styles = m_defaults;
    announceAllChanged();
}

void LayerModel::toggleSolo(model::LayerId layer) {
    ASSERT(!layer.isValid() || layer.row() < m_styles.size());
    m_solo = layer == m_solo ? model::LayerId{} : layer;
    announceAllChanged();
}

void LayerModel::announceAllChanged() {
    if (!m_styles.empty()) {
        emit dataChanged(index(0, 0), index(rowCount() - 1, ColumnCount - 1));
        emit stylesChanged();
    }
}

int LayerModel::rowCount(const QModelIndex& parent) const {
    return parent.isValid() ? 0 : static_cast<int>(m_styles.size());
}

int LayerModel::columnCount(const QModelIndex& parent) const {
    return parent.isValid() ? 0 : ColumnCount;
}

QVariant LayerModel::displayData(const model::Layer& layer, const LayerAppearance& look, int column) const {
    switch (column) {
        case Name: return QString::fromStdString(layer.name);
        case Type: return layerTypeText(layer.type);
        case Opacity: return QStringLiteral("%1 %").arg(look.opacityPercent);
        default: return {};
    }
}

QVariant LayerModel::editData(const LayerAppearance& look, const QModelIndex& index) const {
    switch (index.column()) {
        case Colour: return look.colour;
        case Opacity: return look.opacityPercent;
        default: return displayData(m_document->layers[static_cast<std::size_t>(index.row())], look, index.column());
    }
}

QVariant LayerModel::data(const QModelIndex& index, int role) const {
    if (!checkIndex(index, CheckIndexOption::IndexIsValid | CheckIndexOption::ParentIsInvalid)) {
        return {};
    }
    const auto row = static_cast<std::size_t>(index.row());
    const model::Layer& layer = m_document->layers[row];
    const LayerAppearance& look = m_styles[row];
    switch (role) {
        case Qt::DisplayRole: return displayData(layer, look, index.column());
        case Qt::EditRole: return editData(look, index);
        case Qt::DecorationRole: return index.column() == Colour ? QVariant(look.colour) : QVariant();
        case Qt::ToolTipRole: return layerTip(layer);
        case Qt::CheckStateRole:
            if (index.column() == Visible) {
                return checkState(look.isVisible);
            }
            return index.column() == Solo ? QVariant(checkState(m_solo.isValid() && m_solo.row() == row)) : QVariant();
        default: return {};
    }
}

QVariant LayerModel::headerData(int section, Qt::Orientation orientation, int role) const {
    if (orientation != Qt::Horizontal || section < 0 || section >= ColumnCount) {
        return {};
    }
    switch (role) {
        case Qt::DisplayRole: return kColumns[section].heading;
        case Qt::ToolTipRole: return kColumns[section].tip;
        default: return {};
    }
}

Qt::ItemFlags LayerModel::flags(const QModelIndex& index) const {
    if (!index.isValid()) {
        return Qt::NoItemFlags;
    }
    const Qt::ItemFlags common = Qt::ItemIsEnabled | Qt::ItemIsSelectable | Qt::ItemNeverHasChildren;
    switch (index.column()) {
        case Visible:
        case Solo: return common | Qt::ItemIsUserCheckable;
        case Colour:
        case Opacity: return common | Qt::ItemIsEditable;
        default: return common;
    }
}

bool LayerModel::setData(const QModelIndex& index, const QVariant& value, int role) {
    if (!checkIndex(index, CheckIndexOption::IndexIsValid | CheckIndexOption::ParentIsInvalid)) {
        return false;
    }
    LayerAppearance& look = m_styles[static_cast<std::size_t>(index.row())];
    if (index.column() == Solo && role == Qt::CheckStateRole) {
        const model::LayerId layer{static_cast<std::size_t>(index.row())};
        if ((value.toInt() == Qt::Checked) != (layer == m_solo)) {
            toggleSolo(layer);
        }
        return true;
    }
    if (index.column() == Visible && role == Qt::CheckStateRole) {
        look.isVisible = value.toInt() == Qt::Checked;
    } else if (index.column() == Colour && role == Qt::EditRole && value.value<QColor>().isValid()) {
        look.colour = value.value<QColor>();
    } else if (index.column() == Opacity && role == Qt::EditRole && value.canConvert<int>()) {
        look.opacityPercent = std::clamp(value.toInt(), 0, 100);
    } else {
        return false;
    }
    emit dataChanged(index, index);
    emit stylesChanged();
    return true;
}

}  // namespace ui
