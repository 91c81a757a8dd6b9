#pragma once

#include <QAbstractTableModel>
#include <memory>
#include <vector>

#include "model/board/holes.h"
#include "ui/common/lengths.h"

namespace ui {

/// The drill table of a board: holes that are the same to a fabricator, a row each (model/board/holes.h). Lengths are
/// in the user's unit, written out (display) and as plain numbers for sorting and copying (edit). Copies of other steps
/// are not counted.
class DrillModel : public QAbstractTableModel {
    Q_OBJECT

public:
    enum Column { Layer, Span, Kind, Shape, Diameter, Finished, Tool, Holes, ColumnCount };

    using QAbstractTableModel::QAbstractTableModel;

    void setDocument(std::shared_ptr<const model::Document> document);
    void setUnit(LengthUnit unit);
    /// The holes that these rows count, in rising order.
    [[nodiscard]] std::vector<model::ElementId> holesIn(const std::vector<int>& rows) const;

    [[nodiscard]] int rowCount(const QModelIndex& parent = {}) const override;
    [[nodiscard]] int columnCount(const QModelIndex& parent = {}) const override;
    [[nodiscard]] QVariant data(const QModelIndex& index, int role) const override;
    [[nodiscard]] QVariant headerData(int section, Qt::Orientation orientation, int role) const override;

private:
    [[nodiscard]] QVariant value(const model::DrillRow& row, int column) const;
    [[nodiscard]] QString text(const model::DrillRow& row, int column) const;
    [[nodiscard]] QString spanTip(const model::DrillRow& row) const;

    std::shared_ptr<const model::Document> m_document;
    std::vector<model::DrillRow> m_rows;
    LengthUnit m_unit = LengthUnit::Millimetre;
};

}  // namespace ui
