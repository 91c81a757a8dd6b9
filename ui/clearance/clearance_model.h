#pragma once

#include <QAbstractTableModel>
#include <memory>
#include <vector>

#include "model/board/copies.h"
#include "model/clearance/clearance.h"
#include "model/clearance/rule_check.h"
#include "ui/common/lengths.h"

namespace ui {

/// The narrowest places of one step, or where it breaks rules.
struct StepGaps {
    const model::Document* step = nullptr;  ///< the board or a step that it places
    std::vector<model::RuleFinding> locations;
};

/// Narrow places of a board as a table, the narrowest first: what a search for clearances or a check of rules found.
class ClearanceModel : public QAbstractTableModel {
    Q_OBJECT

public:
    enum Column { Spacing, Rule, Layer, First, Second, X, Y, Step, ColumnCount };

    using QAbstractTableModel::QAbstractTableModel;

    /// `rules` say what a finding's rule is; empty for a search without rules. A null board empties the table.
    void setSpacings(std::shared_ptr<const model::Document> board, std::vector<StepGaps> gaps, model::RuleTable rules);
    void setUnit(LengthUnit unit);

    struct Location {
        std::uint32_t step = 0;  ///< row of model::StepTree::steps
        model::RuleFinding found;
    };
    [[nodiscard]] const Location& location(int row) const { return m_locations[static_cast<std::size_t>(row)]; }
    /// "12 places, the narrowest 0.1 mm", or that nothing was looked for yet.
    [[nodiscard]] QString summary() const;

    [[nodiscard]] int rowCount(const QModelIndex& parent = {}) const override;
    [[nodiscard]] int columnCount(const QModelIndex& parent = {}) const override;
    [[nodiscard]] QVariant data(const QModelIndex& index, int role) const override;
    [[nodiscard]] QVariant headerData(int section, Qt::Orientation orientation, int role) const override;

private:
    [[nodiscard]] QString text(const Location& location, int column) const;
    [[nodiscard]] double number(const Location& location, int column) const;

    std::shared_ptr<const model::Document> m_board;
    model::StepTree m_tree;
    model::RuleTable m_rules;
    std::vector<Location> m_locations;
    LengthUnit m_unit = LengthUnit::Millimetre;
};

}  // namespace ui
