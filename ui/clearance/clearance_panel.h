#pragma once

#include <QWidget>

#include "ui/clearance/clearance_map_bar.h"
#include "ui/clearance/clearance_model.h"
#include "ui/clearance/rule_model.h"

class QAction;
class QComboBox;
class QLabel;
class QSlider;

namespace ui {

class ActionSet;
class TableView;

/// The smallest clearances or broken rules, one row each, to step through; and the sliders of the lens and the
/// clearance map. A row that becomes the current one is shown, so the arrow keys walk through all locations.
class ClearancePanel : public QWidget {
    Q_OBJECT

public:
    enum class What { Smallest, Rules };
    enum class Where { Board, Layer, View, Nets };

    ClearancePanel(ClearanceModel& locations, RuleModel& rules, const ActionSet& actions, QWidget* parent = nullptr);

    [[nodiscard]] What what() const;
    [[nodiscard]] Where where() const;
    void setUnit(LengthUnit unit);
    /// How far the lens reaches, nm.
    [[nodiscard]] double lensReach() const;
    /// What was not measured, in plain words; empty ones take no room.
    void setNotes(const QString& notes);
    [[nodiscard]] QString notes() const;
    /// What the lens shows, beside its slider.
    void showLens(const QString& text);

    [[nodiscard]] TableView& table() { return *m_table; }
    [[nodiscard]] TableView& ruleTable() { return *m_ruleTable; }
    [[nodiscard]] QComboBox& whatBox() { return *m_what; }
    [[nodiscard]] QComboBox& whereBox() { return *m_where; }
    [[nodiscard]] QSlider& lensSlider() { return *m_lens; }
    [[nodiscard]] ClearanceMapBar& distances() { return *m_distances; }
    [[nodiscard]] QString summary() const;

signals:
    void chosen(const ClearanceModel::Location& location);
    void lensMoved(double nm);
    void rulesAsked();
    void rulesSaved();

private:
    void onReset();
    void onWhat();

    ClearanceModel& m_locations;
    QComboBox* m_what;
    QComboBox* m_where;
    QLabel* m_summary;
    TableView* m_table;
    TableView* m_ruleTable;
    QAction* m_openRules;
    QAction* m_saveRules;
    QSlider* m_lens;
    QLabel* m_lensText;
    ClearanceMapBar* m_distances;
    QLabel* m_notes;
};

}  // namespace ui
