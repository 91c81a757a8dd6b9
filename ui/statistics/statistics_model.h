#pragma once

#include <QAbstractTableModel>
#include <memory>
#include <vector>

#include "model/board/document.h"
#include "ui/common/lengths.h"

namespace ui {

/// Elements by kind and what copper covers for every layer of the job, and for all of them in the last row. Layers that
/// Copperscope adds (board body, outline) are left out, so that the numbers add up to the job's own. Numbers are
/// grouped for reading (display) and plain for sorting and copying (edit; copper in mm²).
class StatisticsModel : public QAbstractTableModel {
    Q_OBJECT

public:
    enum Column { Layer, Line, Arc, Circle, Trail, Area, Elements, Features, Copper, ColumnCount };

    using QAbstractTableModel::QAbstractTableModel;

    /// `copperNm2` as model::copperAreas answers it; empty: not known.
    void setDocument(std::shared_ptr<const model::Document> document, std::vector<double> copperNm2 = {});
    void setUnit(LengthUnit unit);
    [[nodiscard]] bool isTotal(int row) const { return row == static_cast<int>(m_layers.size()); }

    [[nodiscard]] int rowCount(const QModelIndex& parent = {}) const override;
    [[nodiscard]] int columnCount(const QModelIndex& parent = {}) const override;
    [[nodiscard]] QVariant data(const QModelIndex& index, int role) const override;
    [[nodiscard]] QVariant headerData(int section, Qt::Orientation orientation, int role) const override;

private:
    [[nodiscard]] qulonglong number(int row, int column) const;
    [[nodiscard]] qulonglong totalOf(int column) const;
    [[nodiscard]] double copper(int row) const;
    [[nodiscard]] QVariant value(int row, int column) const;
    [[nodiscard]] QString text(int row, int column) const;

    std::shared_ptr<const model::Document> m_document;
    std::vector<model::LayerId> m_layers;  ///< row to layer
    std::vector<double> m_copperNm2;       ///< by layer
    LengthUnit m_unit = LengthUnit::Millimetre;
};

}  // namespace ui
