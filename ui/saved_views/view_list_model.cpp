#include "ui/saved_views/view_list_model.h"

#include <utility>

namespace ui {

void ViewListModel::setViews(std::vector<model::session::SavedView> views) {
    if (views.size() != m_views.size()) {
        beginResetModel();
        m_views = std::move(views);
        endResetModel();
    } else if (!views.empty()) {
        m_views = std::move(views);
        emit dataChanged(index(0, 0), index(rowCount() - 1, ColumnCount - 1));
    }
}

int ViewListModel::rowCount(const QModelIndex& parent) const {
    return parent.isValid() ? 0 : static_cast<int>(m_views.size());
}

int ViewListModel::columnCount(const QModelIndex& parent) const {
    return parent.isValid() ? 0 : ColumnCount;
}

QVariant ViewListModel::data(const QModelIndex& index, int role) const {
    if (!index.isValid() || (role != Qt::DisplayRole && role != Qt::EditRole && role != Qt::ToolTipRole)) {
        return {};
    }
    const model::session::SavedView& view = m_views[static_cast<std::size_t>(index.row())];
    if (view.selection && (role == Qt::ToolTipRole || index.column() == Layers)) {
        return QStringLiteral("%L1 nets, %L2 elements")
            .arg(view.selection->nets.size())
            .arg(view.selection->elements.size());
    }
    if (role == Qt::ToolTipRole || index.column() == Layers) {
        QStringList names;
        for (const std::string& layer : view.layers) {
            names += QString::fromStdString(layer);
        }
        return names.join(QStringLiteral(", "));
    }
    return QString::fromStdString(view.name);
}

QVariant ViewListModel::headerData(int section, Qt::Orientation orientation, int role) const {
    if (orientation != Qt::Horizontal || role != Qt::DisplayRole) {
        return {};
    }
    return section == Name ? QStringLiteral("Name") : QStringLiteral("Holds");
}

Qt::ItemFlags ViewListModel::flags(const QModelIndex& index) const {
    const Qt::ItemFlags plain = QAbstractTableModel::flags(index);
    return index.isValid() && index.column() == Name ? plain | Qt::ItemIsEditable : plain;
}

bool ViewListModel::setData(const QModelIndex& index, const QVariant& value, int role) {
    const QString name = value.toString().trimmed();
    if (!index.isValid() || index.column() != Name || role != Qt::EditRole || name.isEmpty()) {
        return false;
    }
    if (name != data(index, Qt::EditRole).toString()) {
        emit renamed(index.row(), name);
    }
    return true;
}

}  // namespace ui
