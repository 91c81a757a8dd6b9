#pragma once

#include <QWidget>
#include <vector>

#include "ui/clearance/clearance_model.h"
#include "ui/clearance/rule_model.h"

class QAction;
class QBoxLayout;
class QComboBox;
class QLabel;
class QMenu;
class QSlider;
class QSplitter;

namespace ui {

class ActionSet;
class ElidedLabel;
class NotesArea;
class SortedRows;
class TableView;

/// The smallest clearances or broken rules, one row each, to step through; and the sliders of the lens and the
/// clearance map. While a rule is selected only its locations are listed; a second click on it lists all again. A row
/// that becomes the current one is shown, so the arrow keys walk through all locations; of rules several may be
/// selected, to be waived at once. In a narrow column controls lie below each other, else side by side; so do the
/// tables where both have room, and long texts are cut so that the values behind them are in sight.
class ClearancePanel : public QWidget {
    Q_OBJECT

public:
    enum class What { Smallest, Rules, ThroughStackup };
    enum class Where { Board, Layer, View, Nets };

    ClearancePanel(ClearanceModel& locations, RuleModel& rules, const ActionSet& actions, QWidget* parent = nullptr);

    [[nodiscard]] What what() const;
    [[nodiscard]] Where where() const;
    void showRules();
    void setUnit(LengthUnit unit);
    /// How far the lens reaches, and the end of the map's colours, nm.
    [[nodiscard]] double lensReach() const;
    [[nodiscard]] double mapReach() const;
    /// What was not measured, in plain words; empty ones take no room, many ones that of a few lines.
    void setNotes(const QString& notes);
    /// What the lens and the map show, beside their sliders.
    void showLens(const QString& text);
    void showMap(const QString& text);

    [[nodiscard]] TableView& table() { return *m_table; }
    /// Of the current row; none: -1.
    [[nodiscard]] int currentRow() const;
    /// Shows that row of the model, if it is listed.
    void setCurrentRow(int row);
    /// Where in the list the user is: a row as it is sorted, selected ones before it not counted, and how far down it
    /// is scrolled.
    struct Place {
        int row = -1;
        int scrolled = 0;
    };
    [[nodiscard]] Place place() const;
    /// Whatever is there now; the last row, if the list is shorter.
    void returnTo(const Place& place);

signals:
    /// Something else is looked for: what is listed answers another question.
    void whatChanged();
    void chosen(const ClearanceModel::Location& location);
    void lensMoved(double nm);
    void mapReachChanged(double nm);
    void rulesAsked();
    void rulesSaved();
    /// Of rows of the model, at least one.
    void waiverAsked(const std::vector<int>& rows);
    void withdrawalAsked(const std::vector<int>& rows);
    void waiversAsked();
    void waiversSaved();
    void goneWaiversAsked();

protected:
    /// A click on the selected rule takes it out of the selection.
    bool eventFilter(QObject* watched, QEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;

private:
    [[nodiscard]] QBoxLayout* searchRow(const ActionSet& actions);
    [[nodiscard]] QBoxLayout* sliderRow(const ActionSet& actions);
    [[nodiscard]] QMenu* waiverMenu();
    void addRowCommands();
    void onReset();
    void onSelection();
    /// Selected locations of rules that are waived, or not; rising.
    [[nodiscard]] std::vector<int> selectedOf(bool isWaived) const;
    /// Lists the locations of the selected rule, all if there is none.
    void listRule();
    void showFirst();
    void fitTables();
    [[nodiscard]] bool isNarrow(int width) const;
    void arrange();
    [[nodiscard]] bool areTablesNarrow() const;
    void onWhat();
    void onMapReach();

    ClearanceModel& m_locations;
    const RuleModel& m_rules;
    LengthUnit m_unit = LengthUnit::Millimetre;
    QComboBox* m_what;
    QComboBox* m_where;
    ElidedLabel* m_summary;
    TableView* m_table;
    TableView* m_ruleTable;
    QAction* m_openRules;
    QAction* m_saveRules;
    QAction* m_showWaived;
    QAction* m_waivers;  ///< the button with the menu
    QAction* m_waive;    ///< of the selected rows
    QAction* m_withdraw;
    SortedRows* m_rows;
    QSlider* m_lens;
    QLabel* m_lensText;
    QSlider* m_map;
    QLabel* m_mapReach;
    QLabel* m_mapText;
    NotesArea* m_notes;
    QBoxLayout* m_searchRow;
    QBoxLayout* m_sliderRow;
    QSplitter* m_tables;
    bool m_areFitNarrow = false;  ///< the columns of the tables
};

}  // namespace ui
