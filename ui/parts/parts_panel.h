#pragma once

#include <QWidget>

#include "ui/parts/linked_table.h"
#include "ui/parts/part_model.h"

class QComboBox;
class QLabel;

namespace ui {

/// The components of the board: filter, sort, export. Selected rows are the components that are selected in the views,
/// both ways; Enter or a double click shows them there. A line above says how many there are and what the job does not
/// say of them.
class PartsPanel : public QWidget {
    Q_OBJECT

public:
    PartsPanel(PartModel& model, PartPicking& parts, QWidget* parent = nullptr);

    /// The selection must be of this board already.
    void setBoard(std::shared_ptr<const model::Document> board);
    /// Whether choosing a row also shows the component in the views.
    void setShowsChosen(bool isOn) { m_showsChosen = isOn; }
    [[nodiscard]] LinkedTable& table() { return *m_table; }

signals:
    void exportRequested();

private:
    void setUpTable();
    void layOut();
    void takeRows(const std::vector<int>& rows);
    void markChosen();
    void listAttributes();
    void showCount();

    PartModel& m_model;
    PartPicking& m_parts;
    LinkedTable* m_table;
    QComboBox* m_attribute;  ///< which one the column shows
    QLabel* m_count;
    bool m_isTaking = false;  ///< what is selected becomes the rows
    bool m_showsChosen = false;
};

}  // namespace ui
