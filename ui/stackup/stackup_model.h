#pragma once

#include <memory>

#include "model/board/document.h"
#include "model/board/stackup_checks.h"
#include "model/board/stackup_table.h"
#include "ui/common/table_model.h"

namespace ui {

/// The stackup of the board from the top as a table whose thicknesses can be edited: a number with um, mm, mil, inch
/// or, for copper, oz; a number alone is in the unit that the cell shows. An empty text takes a row back to what the
/// job says. Values that are assumed are in italics, those edited in bold, and where a value comes from is beside it.
/// The document stays as it is; whoever listens sets another one.
///
/// Thicknesses add up in a column; a board with zones has one for each, side by side, with "–" where the zone does not
/// have the layer. The last two rows are totals: copper to copper, and overall. Rows that the checks found something
/// about have a swatch, and the finding as their tool tip.
class StackupModel : public TableModel {
    Q_OBJECT

public:
    /// Of a board with one stackup; with zones those behind Cumulative are moved on (see columnOf).
    enum Column { Order, Name, Type, Thickness, Cumulative, From, Weight, Constant, Tangent, MaterialName };

    explicit StackupModel(QObject* parent = nullptr);

    /// A null document, or one of a format that states its heights, empties the table. Rows that stay are not reset, so
    /// that the selection stays too.
    void setDocument(std::shared_ptr<const model::Document> document);
    /// Thicknesses, and the findings about them, in this unit.
    void setUnit(LengthUnit unit);
    using TableModel::unit;

    /// Takes rows back to what the job says; totals are passed over.
    void reset(const std::vector<int>& rows);
    void resetAll();

    /// Rows without the totals.
    [[nodiscard]] int layerCount() const { return m_document ? static_cast<int>(m_document->stackup.rows.size()) : 0; }
    /// From the top; below layerCount().
    [[nodiscard]] const model::StackupRow& row(int index) const;
    /// The row of a layer; -1 if it is in none.
    [[nodiscard]] int rowOf(model::LayerId layer) const;
    /// Where a column is now; Cumulative: the first of them.
    [[nodiscard]] int columnOf(Column column) const;
    [[nodiscard]] const std::vector<model::Substack>& substacks() const { return m_substacks; }
    [[nodiscard]] const std::vector<model::StackupFinding>& findings() const { return m_findings; }

    [[nodiscard]] bool isTotal(int row) const override { return row >= layerCount(); }
    [[nodiscard]] Qt::ItemFlags flags(const QModelIndex& index) const override;

signals:
    /// The user wants these rows to be so thick; 0 takes one back to what the job says.
    void edited(const std::vector<model::ThicknessOverride>& changes);
    /// The text is no thickness; says why.
    void refused(const QString& reason);

private:
    [[nodiscard]] int rows() const override { return layerCount() > 0 ? layerCount() + 2 : 0; }
    [[nodiscard]] Cell cell(int row, int column) const override;
    [[nodiscard]] Cell totalCell(int row, int column) const;
    [[nodiscard]] Cell cumulativeCell(int row, std::size_t substack) const;
    [[nodiscard]] Cell nameCell(int row) const;
    [[nodiscard]] QString tip(int row, int column) const override;
    bool edit(int row, int column, const QVariant& value) override;
    /// What a column shows, however many substacks there are, and of which substack if it is Cumulative.
    [[nodiscard]] std::pair<Column, std::size_t> fieldOf(int column) const;
    [[nodiscard]] static std::vector<ui::Column> columnsFor(const std::vector<model::Substack>& substacks);
    [[nodiscard]] static QString sourceText(model::Source source);
    [[nodiscard]] static QString typeText(const model::StackupRow& row, model::StackupKind kind);
    [[nodiscard]] static QString thicknessHint();
    [[nodiscard]] std::string withUnit(const QString& text, model::Nm now) const;
    void checkAll(LengthUnit unit);

    std::shared_ptr<const model::Document> m_document;
    std::vector<model::Substack> m_substacks;
    std::vector<model::StackupFinding> m_findings;
};

}  // namespace ui
