#pragma once

#include <QAbstractTableModel>
#include <vector>

#include "model/clearance/rules.h"
#include "ui/common/lengths.h"

namespace ui {

/// The rules of a board and whether they are kept; everything but the result can be edited. What is refused says why.
class RuleModel : public QAbstractTableModel {
    Q_OBJECT

public:
    enum Column { On, Title, Kind, First, Second, Least, Result, ColumnCount };
    /// What a cell may be, as a list of names; cells without it are typed freely.
    static constexpr int ChoicesRole = Qt::UserRole;

    using QAbstractTableModel::QAbstractTableModel;

    void setRules(model::RuleTable rules);
    [[nodiscard]] const model::RuleTable& rules() const { return m_rules; }
    /// How many places break each rule; empty: not checked.
    void setCounts(std::vector<std::size_t> counts);
    void setUnit(LengthUnit unit);

    /// A rule between any nets, behind all others.
    void addRule();
    void removeRule(int row);
    /// Up with -1, down with 1; the answer is where it is then.
    int moveRule(int row, int by);
    /// Class of this row with another name, also in the rules that speak of it, and other nets. A row behind all others
    /// adds a class.
    bool setClass(std::size_t row, const model::NetClass& netClass);
    bool removeClass(std::size_t row);

    [[nodiscard]] int rowCount(const QModelIndex& parent = {}) const override;
    [[nodiscard]] int columnCount(const QModelIndex& parent = {}) const override;
    [[nodiscard]] QVariant data(const QModelIndex& index, int role) const override;
    [[nodiscard]] QVariant headerData(int section, Qt::Orientation orientation, int role) const override;
    [[nodiscard]] Qt::ItemFlags flags(const QModelIndex& index) const override;
    /// Takes lengths with a unit ("100um", "4 mil"); without one in the user's. Kinds and classes go by name.
    bool setData(const QModelIndex& index, const QVariant& value, int role) override;

signals:
    /// Something was edited; `before` is what the rules were.
    void edited(const model::RuleTable& before);
    void refused(const QString& why);

private:
    [[nodiscard]] QString resultOf(std::size_t row) const;
    [[nodiscard]] QString textOf(std::size_t row, int column) const;
    [[nodiscard]] bool hasClasses(const QModelIndex& index) const;
    [[nodiscard]] QStringList choicesOf(int column) const;
    [[nodiscard]] bool edit(model::Rule& rule, int column, const QVariant& value);
    bool refuse(const QString& why);
    void change(model::RuleTable after);

    model::RuleTable m_rules = model::defaultRules();
    std::vector<std::size_t> m_counts;
    LengthUnit m_unit = LengthUnit::Millimetre;
};

}  // namespace ui
