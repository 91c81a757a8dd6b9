#pragma once

#include <vector>

#include "model/session/session.h"
#include "ui/common/table_model.h"

namespace ui {

/// The saved sections of a board, oldest first. Names can be edited; whoever listens sets the changed list.
class SectionListModel : public TableModel {
    Q_OBJECT

public:
    enum Column { Name };

    explicit SectionListModel(QObject* parent = nullptr);

    void setSections(std::vector<model::session::SavedSection> sections) { replace(m_sections, std::move(sections)); }

signals:
    void renamed(int row, const QString& name);

private:
    [[nodiscard]] int rows() const override { return static_cast<int>(m_sections.size()); }
    [[nodiscard]] Cell cell(int row, int column) const override;
    bool edit(int row, int column, const QVariant& value) override;

    std::vector<model::session::SavedSection> m_sections;
};

}  // namespace ui
