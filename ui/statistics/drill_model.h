#pragma once

#include <memory>

#include "model/board/holes.h"
#include "ui/common/table_model.h"

namespace ui {

/// The drill table of a board with the copies of steps on it: holes that are the same to a fabricator, a row each
/// (model/board/holes.h). A finished size is what the tool list of the job states; what the plating leaves may be
/// assumed and has a column of its own, as in `copperscope info`.
class DrillModel : public TableModel {
    Q_OBJECT

public:
    enum Column { Layer, Span, Kind, Shape, Diameter, Length, Finished, Inside, Tool, Holes };

    explicit DrillModel(QObject* parent = nullptr);

    void setDocument(std::shared_ptr<const model::Document> document);
    [[nodiscard]] const std::vector<model::DrillRow>& table() const { return m_rows; }
    /// The holes that these rows count, in rising order.
    [[nodiscard]] std::vector<model::BoardElement> holesIn(const std::vector<int>& rows) const;

private:
    [[nodiscard]] int rows() const override { return static_cast<int>(m_rows.size()); }
    [[nodiscard]] Cell cell(int row, int column) const override;
    [[nodiscard]] Cell inside(const model::DrillRow& row) const;
    [[nodiscard]] QString tip(int row, int column) const override;

    std::shared_ptr<const model::Document> m_document;
    std::vector<model::DrillRow> m_rows;
};

}  // namespace ui
