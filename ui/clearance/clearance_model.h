#pragma once

#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "model/board/copies.h"
#include "model/clearance/clearance.h"
#include "model/clearance/side_names.h"
#include "model/clearance/stackup_clearance.h"
#include "model/clearance/waivers.h"
#include "ui/common/table_model.h"

namespace ui {

/// The smallest clearances of one step, or where it breaks rules.
struct StepSpacings {
    const model::Document* step = nullptr;  ///< the board or a step that it places
    std::vector<model::RuleFinding> locations;
    std::shared_ptr<const model::SideNames> names;  ///< of the step
    std::vector<model::WaivedFinding> waived{};
};

/// Small clearances of a board as a table, the smallest first: what a search for clearances or a check of rules found.
/// Behind them, grey and of a lower rank, those that are waived. Columns come in the order one reads a finding: what is
/// broken, between what, by how much, where. Views leave Rule, Waived and Required out where they say nothing.
class ClearanceModel : public TableModel {
    Q_OBJECT

public:
    enum Column { Rule, Waived, First, Second, Spacing, Required, Layer, X, Y, Step };

    explicit ClearanceModel(QObject* parent = nullptr);

    /// `rules` say what a finding's rule is; empty for a search without rules. `isComplete`: could they check
    /// everything? `isCut`: may there be more locations than these? A null board empties the table.
    void setSpacings(std::shared_ptr<const model::Document> board, std::vector<StepSpacings> spacings,
                     model::RuleTable rules, bool isComplete, bool isCut = false);

    /// Distances in space, as they are found; `names` by step of StepTree::steps.
    void setThroughStackup(std::shared_ptr<const model::Document> board,
                           std::span<const model::StackupClearance> clearances,
                           std::vector<std::shared_ptr<const model::SideNames>> names, bool isCut = false);

    struct Location {
        std::uint32_t step = 0;  ///< row of model::StepTree::steps
        model::RuleFinding found;
        std::optional<std::size_t> waiver{};                      ///< row of the list of waivers that was checked
        std::string reason{};                                     ///< why it is waived
        std::optional<model::StackupClearance> throughStackup{};  ///< then its sides may lie in different copies
    };
    [[nodiscard]] const Location& location(int row) const { return m_locations[static_cast<std::size_t>(row)]; }
    /// The row of the same two elements of the same rule and layer; -1: none.
    [[nodiscard]] int rowOf(const Location& location) const;
    /// The first location of a rule; -1: none.
    [[nodiscard]] int firstOf(std::size_t rule) const;
    /// The waiver of a row, but for what a person has to say. Not of a search without rules.
    [[nodiscard]] model::Waiver waiverFor(int row) const;
    [[nodiscard]] bool isOfRules() const { return !m_rules.rules.empty(); }
    /// Waived ones are the last rows.
    [[nodiscard]] bool hasWaived() const { return !m_locations.empty() && m_locations.back().waiver; }
    /// Locations of other rules get a rank below all others; none: all rules count. Who filters rows has to do so anew.
    void showRule(std::optional<std::size_t> rule);
    /// What the locations break; without rules for a search without them.
    [[nodiscard]] const model::RuleTable& rules() const { return m_rules; }
    [[nodiscard]] int rankOf(int row) const override;
    /// "Smallest spacing 0.1 mm; 12 locations", "…; at least 500 locations" of those that are cut, of rules the verdict
    /// first, then which of them is shown alone and their tolerance, or that no search was made yet.
    [[nodiscard]] QString summary() const;

private:
    /// The summary without the tolerance.
    [[nodiscard]] QString found() const;
    /// "shown: 16 of 3,050, of “track width” alone"
    [[nodiscard]] QString shownText() const;
    [[nodiscard]] QString foundOf(std::span<const Location> locations) const;
    [[nodiscard]] int rows() const override { return static_cast<int>(m_locations.size()); }
    [[nodiscard]] Cell cell(int row, int column) const override;
    [[nodiscard]] QString tip(int row, int /*column*/) const override {
        return QString::fromStdString(location(row).reason);
    }
    [[nodiscard]] Cell plainCell(int row, int column) const;
    [[nodiscard]] Cell requiredCell(const model::RuleFinding& found) const;
    [[nodiscard]] Cell stackupCell(const model::StackupClearance& found, int column) const;
    [[nodiscard]] std::uint32_t stepOf(const model::BoardElement& at) const { return m_tree.copies[at.copy].step; }
    void setBoard(std::shared_ptr<const model::Document> board);

    std::shared_ptr<const model::Document> m_board;
    model::StepTree m_tree;
    model::RuleTable m_rules;
    std::optional<std::size_t> m_shownRule;  ///< row of the table; none: all
    bool m_isComplete = true;
    bool m_isCut = false;
    std::vector<std::shared_ptr<const model::SideNames>> m_names;  ///< by step of the tree
    std::vector<Location> m_locations;
};

}  // namespace ui
