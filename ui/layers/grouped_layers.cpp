#include "ui/layers/grouped_layers.h"

#include <QFont>
#include <algorithm>

namespace ui {

using model::LayerGroup;
using model::LayerId;

GroupedLayers::GroupedLayers(LayerModel& layers, QObject* parent) : QAbstractProxyModel(parent), m_layers(layers) {
    setSourceModel(&layers);
    takeDocument();
    connect(&layers, &QAbstractItemModel::modelAboutToBeReset, this, [this] { beginResetModel(); });
    connect(&layers, &QAbstractItemModel::modelReset, this, [this] {
        takeDocument();
        endResetModel();
    });
    connect(&layers, &QAbstractItemModel::dataChanged, this, [this] {
        if (!m_rows.empty()) {
            emit dataChanged(index(0, 0), index(rowCount() - 1, columnCount() - 1));
        }
    });
}

void GroupedLayers::takeDocument() {
    m_layersIn = {};
    m_rows.clear();
    const std::size_t count = m_layers.document() != nullptr ? m_layers.document()->layers.size() : 0;
    for (std::size_t row = 0; row < count; ++row) {
        const LayerGroup group = model::groupOf(m_layers.document()->layers[row]);
        m_layersIn[static_cast<std::size_t>(group)].emplace_back(row);
    }
    for (std::size_t i = 0; i < m_layersIn.size(); ++i) {
        const auto group = static_cast<LayerGroup>(i);
        if (m_layersIn[i].empty()) {
            continue;
        }
        m_isFolded[i] = isDull(group);
        m_rows.push_back({group, {}});
        for (std::size_t n = 0; n < m_layersIn[i].size() && !m_isFolded[i]; ++n) {
            m_rows.push_back({group, m_layersIn[i][n]});
        }
    }
}

/// Paste, drawings and dielectrics are looked for now and then; a group in which nothing is drawn is empty.
bool GroupedLayers::isDull(LayerGroup group) const {
    const bool isRare = group == LayerGroup::Paste || group == LayerGroup::Mechanical ||
                        group == LayerGroup::Dielectric || group == LayerGroup::Other;
    return isRare || std::ranges::all_of(layersIn(group), [this](LayerId layer) {
               return drawsNothing(m_layers.document()->layer(layer));
           });
}

std::vector<LayerId> GroupedLayers::layersAt(int row) const {
    const Row& at = m_rows[static_cast<std::size_t>(row)];
    return at.layer.isValid() ? std::vector{at.layer} : layersIn(at.group);
}

int GroupedLayers::reveal(LayerId layer) {
    if (!layer.isValid() || m_layers.document() == nullptr) {
        return -1;
    }
    fold(model::groupOf(m_layers.document()->layer(layer)), false);
    return mapFromSource(m_layers.index(static_cast<int>(layer.row()), 0)).row();
}

int GroupedLayers::headingOf(LayerGroup group) const {
    const auto heading = std::ranges::find(m_rows, group, &Row::group);
    return heading != m_rows.end() ? static_cast<int>(heading - m_rows.begin()) : -1;
}

void GroupedLayers::fold(LayerGroup group, bool isFolded) {
    const int heading = headingOf(group);
    if (heading < 0 || isFolded == this->isFolded(group)) {
        return;
    }
    const auto count = static_cast<int>(layersIn(group).size());
    const auto first = m_rows.begin() + heading + 1;
    m_isFolded[static_cast<std::size_t>(group)] = isFolded;
    if (isFolded) {
        beginRemoveRows({}, heading + 1, heading + count);
        m_rows.erase(first, first + count);
        endRemoveRows();
    } else {
        std::vector<Row> rows;
        std::ranges::transform(layersIn(group), std::back_inserter(rows), [group](LayerId layer) {
            return Row{group, layer};
        });
        beginInsertRows({}, heading + 1, heading + count);
        m_rows.insert(first, rows.begin(), rows.end());
        endInsertRows();
    }
    emit dataChanged(index(heading, 0), index(heading, columnCount() - 1));
}

int GroupedLayers::rowCount(const QModelIndex& parent) const {
    return parent.isValid() ? 0 : static_cast<int>(m_rows.size());
}

int GroupedLayers::columnCount(const QModelIndex& parent) const {
    return m_layers.columnCount(parent);
}

QModelIndex GroupedLayers::index(int row, int column, const QModelIndex& parent) const {
    const bool isThere = !parent.isValid() && row >= 0 && row < rowCount() && column >= 0 && column < columnCount();
    return isThere ? createIndex(row, column) : QModelIndex();
}

QModelIndex GroupedLayers::parent(const QModelIndex&) const {
    return {};
}

QModelIndex GroupedLayers::mapToSource(const QModelIndex& index) const {
    if (!index.isValid() || isHeading(index.row())) {
        return {};
    }
    const LayerId layer = m_rows[static_cast<std::size_t>(index.row())].layer;
    return m_layers.index(static_cast<int>(layer.row()), index.column());
}

QModelIndex GroupedLayers::mapFromSource(const QModelIndex& index) const {
    if (!index.isValid()) {
        return {};
    }
    const auto row = std::ranges::find(m_rows, LayerId{static_cast<std::size_t>(index.row())}, &Row::layer);
    return row != m_rows.end() ? this->index(static_cast<int>(row - m_rows.begin()), index.column()) : QModelIndex();
}

QVariant GroupedLayers::data(const QModelIndex& index, int role) const {
    if (!checkIndex(index, CheckIndexOption::IndexIsValid)) {
        return {};
    }
    return isHeading(index.row()) ? headingData(groupAt(index.row()), index.column(), role)
                                  : m_layers.data(mapToSource(index), role);
}

QVariant GroupedLayers::headingData(LayerGroup group, int column, int role) const {
    if (column == LayerModel::Visible) {
        return role == Qt::CheckStateRole        ? QVariant(checkOf(group))
               : role == TableModel::kTraitsRole ? QVariant(kCheck)
               : role == Qt::ToolTipRole         ? QVariant(tr("Draw all layers of the group (Space)"))
                                                 : QVariant();
    }
    if (role == TableModel::kTraitsRole) {
        return 0;
    }
    if (column != LayerModel::Name) {
        return {};
    }
    QFont bold;
    bold.setBold(true);
    switch (role) {
        case Qt::DisplayRole:
            return QStringLiteral("%1 %2 (%3)")
                .arg(isFolded(group) ? QStringLiteral("▸") : QStringLiteral("▾"), layerGroupText(group))
                .arg(layersIn(group).size());
        case Qt::FontRole: return bold;
        case Qt::ToolTipRole: return isFolded(group) ? tr("Unfold the group (Enter)") : tr("Fold the group (Enter)");
        default: return {};
    }
}

Qt::CheckState GroupedLayers::checkOf(LayerGroup group) const {
    const std::vector<bool> isVisible = m_layers.visibility();
    const auto shown = static_cast<std::size_t>(
        std::ranges::count_if(layersIn(group), [&](LayerId layer) { return isVisible[layer.row()]; }));
    return shown == 0 ? Qt::Unchecked : shown == layersIn(group).size() ? Qt::Checked : Qt::PartiallyChecked;
}

QVariant GroupedLayers::headerData(int section, Qt::Orientation orientation, int role) const {
    return m_layers.headerData(section, orientation, role);  // rows have none
}

Qt::ItemFlags GroupedLayers::flags(const QModelIndex& index) const {
    if (!index.isValid() || !isHeading(index.row())) {
        return m_layers.flags(mapToSource(index));
    }
    Qt::ItemFlags flags = Qt::ItemIsEnabled | Qt::ItemIsSelectable | Qt::ItemNeverHasChildren;
    flags.setFlag(Qt::ItemIsUserCheckable, index.column() == LayerModel::Visible);
    return flags;
}

bool GroupedLayers::setData(const QModelIndex& index, const QVariant& value, int role) {
    if (!checkIndex(index, CheckIndexOption::IndexIsValid)) {
        return false;
    }
    if (!isHeading(index.row())) {
        return m_layers.setData(mapToSource(index), value, role);
    }
    if (role == Qt::CheckStateRole && index.column() == LayerModel::Visible) {
        m_layers.setVisible(layersIn(groupAt(index.row())), value.toInt() == Qt::Checked);
        return true;
    }
    return false;
}

}  // namespace ui
