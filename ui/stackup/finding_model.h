#pragma once

#include "model/board/stackup_checks.h"
#include "ui/common/table_model.h"

namespace ui {

/// What the checks found about the stackup (model/board/stackup_checks.h), a line each.
class FindingModel : public TableModel {
    Q_OBJECT

public:
    explicit FindingModel(QObject* parent = nullptr);

    void setFindings(std::vector<model::StackupFinding> findings);
    [[nodiscard]] const model::StackupFinding& finding(int row) const {
        return m_findings[static_cast<std::size_t>(row)];
    }

private:
    [[nodiscard]] int rows() const override { return static_cast<int>(m_findings.size()); }
    [[nodiscard]] Cell cell(int row, int column) const override;
    [[nodiscard]] QString tip(int row, int column) const override;

    std::vector<model::StackupFinding> m_findings;
};

}  // namespace ui
