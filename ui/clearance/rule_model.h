#pragma once

#include <vector>

#include "model/clearance/rule_report.h"
#include "ui/common/table_model.h"

namespace ui {

/// What a check found out about a rule, over all steps of a board.
struct RuleResult {
    model::Verdict verdict = model::Verdict::Off;  ///< of the step where it is worst
    std::size_t count = 0;                         ///< locations
    std::size_t unchecked = 0;                     ///< reasons why it could not check everything
    std::size_t waived = 0;                        ///< locations that are none of count
};

/// The rules of a board and whether they pass; everything but the result can be edited. What is refused says why.
class RuleModel : public TableModel {
    Q_OBJECT

public:
    enum Column { On, Title, Kind, First, Second, FirstObject, SecondObject, Layer, Least, Result };

    explicit RuleModel(QObject* parent = nullptr);

    /// Names of layers to choose from, besides top, bottom, outer and inner.
    void setLayers(QStringList layers) { m_layers = std::move(layers); }
    void setRules(model::RuleTable rules);
    /// The same as an edit.
    void replaceRules(model::RuleTable rules);
    [[nodiscard]] const model::RuleTable& rules() const { return m_rules; }
    /// By rule; empty: not checked.
    void setResults(std::vector<RuleResult> results);

    /// With a unit, or in the user's; false if it is none.
    bool setTolerance(const QString& text);
    /// "0.5 µm"
    [[nodiscard]] QString tolerance() const;

    /// A rule between any nets, behind all others.
    void addRule();
    void removeRule(int row);
    /// Up with -1, down with 1; returns where it is then.
    int moveRule(int row, int by);
    /// Class of this row with another name, also in the rules that speak of it, and other nets. A row behind all others
    /// adds a class.
    bool setClass(std::size_t row, const model::NetClass& netClass);
    bool removeClass(std::size_t row);

    [[nodiscard]] Qt::ItemFlags flags(const QModelIndex& index) const override;

signals:
    /// Something was edited; `before` is what the rules were.
    void edited(const model::RuleTable& before);
    void refused(const QString& why);

private:
    [[nodiscard]] int rows() const override { return static_cast<int>(m_rules.rules.size()); }
    [[nodiscard]] Cell cell(int row, int column) const override;
    [[nodiscard]] static QString withWaived(const QString& text, const RuleResult& result);
    [[nodiscard]] Cell resultOf(std::size_t row) const;
    [[nodiscard]] QStringList choicesOf(const model::Rule& rule, int column) const;
    [[nodiscard]] QStringList netChoices(const model::Rule& rule) const;
    [[nodiscard]] QStringList layerChoices(const model::Rule& rule) const;
    /// Takes lengths with a unit ("100um", "4 mil"); without one in the user's. Of an aspect ratio "8" or "8 : 1".
    /// Kinds and classes go by name.
    bool edit(int row, int column, const QVariant& value) override;
    bool check(int row, int column, bool isChecked) override;
    [[nodiscard]] bool set(model::Rule& rule, int column, const QString& text);
    [[nodiscard]] bool setLimit(model::Rule& rule, const QString& text);
    bool refuse(const QString& why);
    void change(model::RuleTable after);

    model::RuleTable m_rules = model::defaultRules();
    std::vector<RuleResult> m_results;
    QStringList m_layers;
};

}  // namespace ui
