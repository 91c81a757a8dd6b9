#pragma once

#include <QDialog>

#include "ui/clearance/net_class_model.h"
#include "ui/clearance/rule_model.h"

class QLabel;

namespace ui {

class TableView;

/// Rules and net classes to edit; nothing counts before it is accepted.
class RuleDialog : public QDialog {
    Q_OBJECT

public:
    /// `nets`: all names of the board.
    RuleDialog(const model::RuleTable& rules, std::vector<std::string> nets, LengthUnit unit,
               QWidget* parent = nullptr);

    [[nodiscard]] RuleModel& rules() { return m_rules; }

private:
    QWidget* presetRow();
    void setPreset(int row);
    QWidget* rulesBox();
    QWidget* classesBox();
    QWidget* toleranceRow();
    void addRule();
    void removeRule();
    void moveRule(int by);
    void addClass();
    void removeClass();

    RuleModel m_rules;
    NetClassModel m_classes;
    TableView* m_ruleTable;
    TableView* m_classTable;
    QLabel* m_hint;  ///< why the last edit was refused; empty if it was not
};

}  // namespace ui
