#pragma once

#include <vector>

#include "model/session/session.h"
#include "ui/common/table_model.h"

namespace ui {

/// The saved views of a user, oldest first. Names can be edited; whoever listens sets the changed list.
class ViewListModel : public TableModel {
    Q_OBJECT

public:
    enum Column { Name, Layers };

    explicit ViewListModel(QObject* parent = nullptr);

    void setViews(std::vector<model::session::SavedView> views) { replace(m_views, std::move(views)); }
    [[nodiscard]] const std::vector<model::session::SavedView>& views() const { return m_views; }

signals:
    void renamed(int row, const QString& name);

private:
    [[nodiscard]] int rows() const override { return static_cast<int>(m_views.size()); }
    [[nodiscard]] Cell cell(int row, int column) const override;
    [[nodiscard]] QString tip(int row, int column) const override;
    bool edit(int row, int column, const QVariant& value) override;

    std::vector<model::session::SavedView> m_views;
};

}  // namespace ui
