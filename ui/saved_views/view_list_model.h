#pragma once

#include <QAbstractTableModel>
#include <vector>

#include "model/session/session.h"

namespace ui {

/// The views a user has kept, in the order they were kept. Names can be edited; whoever listens sets the changed list.
class ViewListModel : public QAbstractTableModel {
    Q_OBJECT

public:
    enum Column { Name, Layers, ColumnCount };

    using QAbstractTableModel::QAbstractTableModel;

    void setViews(std::vector<model::session::SavedView> views);
    [[nodiscard]] const std::vector<model::session::SavedView>& views() const { return m_views; }

    [[nodiscard]] int rowCount(const QModelIndex& parent = {}) const override;
    [[nodiscard]] int columnCount(const QModelIndex& parent = {}) const override;
    [[nodiscard]] QVariant data(const QModelIndex& index, int role) const override;
    [[nodiscard]] QVariant headerData(int section, Qt::Orientation orientation, int role) const override;
    [[nodiscard]] Qt::ItemFlags flags(const QModelIndex& index) const override;
    bool setData(const QModelIndex& index, const QVariant& value, int role) override;

signals:
    void renamed(int row, const QString& name);

private:
    std::vector<model::session::SavedView> m_views;
};

}  // namespace ui
