#pragma once

#include <QAbstractTableModel>
#include <memory>
#include <vector>

#include "model/board/document.h"

namespace ui {

/// The stack of the board from the top as a table whose thicknesses can be edited: a number with um, mm, mil, inch or,
/// for copper, oz. An empty text takes a row back to what the job says. Values that are assumed are in italics, those
/// set by the user in bold, and where a value comes from stands beside it. The document stays as it is; whoever listens
/// sets another one.
class StackupModel : public QAbstractTableModel {
    Q_OBJECT

public:
    enum Column { Order, Name, Type, Thickness, From, Weight, MaterialName, Constant, Tangent, ColumnCount };

    using QAbstractTableModel::QAbstractTableModel;

    /// A null document, or one of a format that states its heights, empties the table. Rows that stay are not reset, so
    /// that the selection stays too.
    void setDocument(std::shared_ptr<const model::Document> document);

    /// Takes rows back to what the job says.
    void reset(const std::vector<int>& rows);

    [[nodiscard]] int rowCount(const QModelIndex& parent = {}) const override;
    [[nodiscard]] int columnCount(const QModelIndex& parent = {}) const override;
    [[nodiscard]] QVariant data(const QModelIndex& index, int role) const override;
    [[nodiscard]] QVariant headerData(int section, Qt::Orientation orientation, int role) const override;
    [[nodiscard]] Qt::ItemFlags flags(const QModelIndex& index) const override;
    bool setData(const QModelIndex& index, const QVariant& value, int role) override;

    /// From the top.
    [[nodiscard]] const model::StackupRow& row(int index) const;

signals:
    /// The user wants these rows to be so thick; 0 takes one back to what the job says.
    void edited(const std::vector<model::ThicknessOverride>& changes);
    /// The text is no thickness; says why.
    void refused(const QString& reason);

private:
    [[nodiscard]] QVariant displayData(int row, int column) const;

    std::shared_ptr<const model::Document> m_document;
};

}  // namespace ui
