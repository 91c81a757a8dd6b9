#pragma once

#include <string>
#include <vector>

#include "ui/clearance/rule_model.h"

namespace ui {

/// The net classes that rules use: name, patterns, and how many nets of the board they fit.
class NetClassModel : public TableModel {
    Q_OBJECT

public:
    enum Column { Name, Nets, Fits };

    /// Edits the classes of `rules`, which must live longer, and begins anew whenever those do. `nets`: all names of
    /// the board.
    NetClassModel(RuleModel& rules, std::vector<std::string> nets, QObject* parent = nullptr);

    /// A class with a name of its own and no nets.
    void addClass();
    /// Nothing without such a row.
    void removeClass(int row);

private:
    [[nodiscard]] int rows() const override { return static_cast<int>(m_rules.rules().classes.size()); }
    [[nodiscard]] Cell cell(int row, int column) const override;
    [[nodiscard]] QString tip(int row, int column) const override;
    /// Patterns stand between commas.
    bool edit(int row, int column, const QVariant& value) override;
    [[nodiscard]] const model::NetClass& classOf(int row) const {
        return m_rules.rules().classes[static_cast<std::size_t>(row)];
    }
    [[nodiscard]] std::vector<std::string> netsOf(const model::NetClass& netClass) const;

    RuleModel& m_rules;
    std::vector<std::string> m_nets;
};

}  // namespace ui
