#pragma once

#include <QWidget>
#include <span>

#include "ui/parts/linked_table.h"
#include "ui/parts/part_group_model.h"

class QComboBox;
class QLabel;

namespace ui {

/// The components of the board: filter, sort, export; a row each, or equal ones as one row (PartGroupModel). Selected
/// rows are the components that are selected in the views, both ways; Enter, a double click or the menu of a row shows
/// them there, and the menu has what else is done with what is selected. A line above says how many there are and what
/// the job does not say of them.
class PartsPanel : public QWidget {
    Q_OBJECT

public:
    PartsPanel(PartModel& model, PartPicking& parts, const ActionSet& actions, QWidget* parent = nullptr);

    /// The selection must be of this board already. The tables begin at their top, or at what is selected; with the
    /// same components as before, as of a board that is read anew, they stay where they are.
    void setBoard(std::shared_ptr<const model::Document> board);
    /// Whether choosing a row also shows the component in the views.
    void setShowsChosen(bool isOn) { m_showsChosen = isOn; }
    /// See LinkedTable.
    void setFollows(bool isOn);
    [[nodiscard]] bool isGrouped() const { return m_groups.isOn(); }
    /// The table that is shown.
    [[nodiscard]] LinkedTable& table() { return isGrouped() ? *m_groupTable : *m_table; }
    /// Its rows as a file, without a second column of values.
    [[nodiscard]] QString csv();

signals:
    void exportRequested();

protected:
    void showEvent(QShowEvent* event) override;

private:
    /// `names`: columns that take what room there is.
    void setUp(LinkedTable& table, std::span<const std::pair<int, int>> widths, const std::vector<int>& names);
    void addRowCommands(LinkedTable& table, const ActionSet& actions);
    void layOut();
    void setGrouped(bool isOn);
    void showColumns();
    /// Rows of the PartModel.
    void takeParts(const std::vector<int>& rows);
    void takeGroups(const std::vector<int>& rows);
    void markChosen();
    [[nodiscard]] std::vector<int> shownParts() const;
    void listAttributes();
    [[nodiscard]] QString chosenAttribute() const;
    /// Is it the one that equal parts have a column of anyway?
    [[nodiscard]] bool isValueChosen() const;
    void showCount();

    PartModel& m_model;
    PartPicking& m_parts;
    PartGroupModel m_groups;
    LinkedTable* m_table;
    LinkedTable* m_groupTable;
    QComboBox* m_attribute;  ///< which one the column shows
    QLabel* m_count;
    bool m_isTaking = false;   ///< what is selected becomes the rows
    bool m_isMarkDue = false;  ///< something else was selected while no table was seen
    bool m_showsChosen = false;
};

}  // namespace ui
