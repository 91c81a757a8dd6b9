#pragma once

#include <QAbstractTableModel>
#include <vector>

#include "model/clearance/rules.h"
#include "ui/models/lengths.h"

namespace ui::models {

/// The rules of a board and whether they are kept. How much they ask for can be edited.
class RuleModel : public QAbstractTableModel {
    Q_OBJECT

public:
    enum Column { Title, Least, Result, ColumnCount };

    using QAbstractTableModel::QAbstractTableModel;

    void setRules(model::RuleTable rules);
    [[nodiscard]] const model::RuleTable& rules() const { return m_rules; }
    /// How many places break each rule; empty: not checked.
    void setCounts(std::vector<std::size_t> counts);
    void setUnit(LengthUnit unit);

    [[nodiscard]] int rowCount(const QModelIndex& parent = {}) const override;
    [[nodiscard]] int columnCount(const QModelIndex& parent = {}) const override;
    [[nodiscard]] QVariant data(const QModelIndex& index, int role) const override;
    [[nodiscard]] QVariant headerData(int section, Qt::Orientation orientation, int role) const override;
    [[nodiscard]] Qt::ItemFlags flags(const QModelIndex& index) const override;
    /// Takes lengths with a unit ("100um", "4 mil"); without one in the user's. Refuses what is none.
    bool setData(const QModelIndex& index, const QVariant& value, int role) override;

private:
    [[nodiscard]] QString resultOf(std::size_t row) const;

    model::RuleTable m_rules = model::defaultRules();
    std::vector<std::size_t> m_counts;
    LengthUnit m_unit = LengthUnit::Millimetre;
};

}  // namespace ui::models
