#pragma once

#include <QAbstractTableModel>
#include <QFont>
#include <optional>
#include <vector>

#include "ui/common/display_units.h"

namespace ui {

/// What the cells of a column have in common.
enum ColumnTrait {
    kNumber = 1,    ///< to the right, as is the heading
    kEditable = 2,  ///< typed, or chosen from Cell::choices
    kCheck = 4,     ///< with a box; without any other trait the box is all there is
    kColour = 8,    ///< a swatch of the value
    kPercent = 16,  ///< a bar of the value
    kLength = 32,   ///< in the user's unit, which files name in the heading
    kPath = 64,     ///< its end tells what it is: without room its beginning is cut
};

struct Column {
    QString heading;
    QString tip;
    int traits = 0;
};

struct Cell {
    QVariant text = {};   ///< as it is shown
    QVariant value = {};  ///< as it is sorted, copied and edited; invalid: the text
    QVariant order = {};  ///< as it is sorted; invalid: the value
    std::optional<bool> isChecked = {};
    QVariant colour = {};      ///< of the text
    QVariant decoration = {};  ///< before the text
    QVariant font = {};
    QStringList choices = {};           ///< what the value may be; empty: anything
    QString tip = {};                   ///< where the model has none of its own
    std::optional<double> length = {};  ///< nm, of a cell without a tip: that says it in both systems
};

/// A table of rows that its heir holds: the heir says how many there are and what is in a cell, and takes edits. All
/// the rest of an item model is here.
class TableModel : public QAbstractTableModel {
    Q_OBJECT

public:
    static constexpr int kTraitsRole = Qt::UserRole;  ///< of a cell: its column's traits
    static constexpr int kChoicesRole = Qt::UserRole + 1;
    static constexpr int kSortRole = Qt::UserRole + 2;
    static constexpr int kFileHeadingRole = Qt::UserRole + 3;  ///< of a heading: with the unit of lengths

    explicit TableModel(std::vector<Column> columns, QObject* parent = nullptr);

    void setUnit(LengthUnit unit);

    /// Rows of a lower rank can be filtered out.
    [[nodiscard]] virtual int rankOf(int /*row*/) const { return 0; }
    /// A row of totals, which is last however the table is sorted.
    [[nodiscard]] virtual bool isTotal(int /*row*/) const { return false; }
    /// What a filter looks for words in.
    [[nodiscard]] virtual QString searchText(int row) const;

    [[nodiscard]] int rowCount(const QModelIndex& parent = {}) const final;
    [[nodiscard]] int columnCount(const QModelIndex& parent = {}) const final;
    [[nodiscard]] QVariant data(const QModelIndex& index, int role = Qt::DisplayRole) const final;
    /// Views ask for all that they draw of a cell at once.
    void multiData(const QModelIndex& index, QModelRoleDataSpan roles) const final;
    [[nodiscard]] QVariant headerData(int section, Qt::Orientation orientation, int role) const final;
    [[nodiscard]] Qt::ItemFlags flags(const QModelIndex& index) const override;
    bool setData(const QModelIndex& index, const QVariant& value, int role) final;

protected:
    [[nodiscard]] virtual int rows() const = 0;
    [[nodiscard]] virtual Cell cell(int row, int column) const = 0;
    /// As it is sorted, where that takes long to find and is of no use to cells that are only shown; invalid: as the
    /// cell says.
    [[nodiscard]] virtual QVariant order(int /*row*/, int /*column*/) const { return {}; }
    [[nodiscard]] virtual QString tip(int /*row*/, int /*column*/) const { return {}; }
    /// Of cells with the trait; false if it cannot be.
    virtual bool edit(int /*row*/, int /*column*/, const QVariant& /*value*/) { return false; }
    virtual bool check(int /*row*/, int /*column*/, bool /*isChecked*/) { return false; }

    /// All cells may show something else.
    void announceChange();
    /// Other columns, between beginResetModel and endResetModel.
    void setColumns(std::vector<Column> columns) { m_columns = std::move(columns); }
    /// Other rows: as many as before keep the selection, another number begins anew.
    template <class Rows>
    void replace(Rows& rows, Rows after) {
        const bool isSame = rows.size() == after.size();
        if (!isSame) {
            beginResetModel();
        }
        rows = std::move(after);
        isSame ? announceChange() : endResetModel();
    }

    [[nodiscard]] LengthUnit unit() const { return m_unit; }
    /// In the user's unit; the tip says it in the other system too.
    [[nodiscard]] Cell length(double nm) const {
        return {.text = fixedLengthText(nm, m_unit), .value = nm / nmPer(m_unit), .length = nm};
    }
    [[nodiscard]] Cell area(double nm2) const;  ///< its value is in mm²
    /// Grouped for reading.
    [[nodiscard]] static Cell count(qulonglong number);
    [[nodiscard]] static Cell text(const std::string& utf8) { return {QString::fromStdString(utf8)}; }
    [[nodiscard]] static QFont boldFont();

private:
    [[nodiscard]] QVariant tipOf(const QModelIndex& index) const;

    std::vector<Column> m_columns;
    LengthUnit m_unit = LengthUnit::Millimetre;
};

}  // namespace ui
