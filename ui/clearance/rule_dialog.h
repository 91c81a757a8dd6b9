#pragma once

#include <QDialog>
#include <vector>

#include "ui/clearance/net_class_model.h"
#include "ui/clearance/rule_model.h"

class QLabel;
class QLineEdit;

namespace ui {

class TableView;

/// Rules and net classes to edit; nothing counts before it is accepted. A choice says which rules the table began with:
/// those that the dialog was given, which can be taken back, or a preset.
class RuleDialog : public QDialog {
    Q_OBJECT

public:
    /// `nets`: all names of the board.
    RuleDialog(const model::RuleTable& rules, std::vector<std::string> nets, LengthUnit unit,
               QWidget* parent = nullptr);

    [[nodiscard]] RuleModel& rules() { return m_rules; }
    /// Stays open while the tolerance is none, and says why.
    void accept() override;

private:
    QWidget* beginningRow(const model::RuleTable& rules);
    QWidget* rulesBox();
    QWidget* classesBox();
    QWidget* toleranceRow();
    /// False if the text is none; it stays to be mended.
    bool takeTolerance();
    void addRule();
    void removeRule();
    void moveRule(int by);
    void addClass();
    void removeClass();

    RuleModel m_rules;
    NetClassModel m_classes;
    TableView* m_ruleTable;
    TableView* m_classTable;
    QLineEdit* m_tolerance;
    bool m_isToleranceRefused = false;
    std::vector<model::RuleTable> m_beginnings;  ///< in the order of their choice
    QLabel* m_hint;                              ///< why the last edit was refused; empty if it was not
};

}  // namespace ui
