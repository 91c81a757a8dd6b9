#pragma once

#include <QWidget>

#include "ui/models/net_model.h"
#include "ui/models/selection_model.h"

class QComboBox;
class QLabel;
class QLineEdit;

namespace ui {

class TableView;

/// The nets of the board: filter, sort, highlight. Selected rows are the highlighted nets, both ways; Enter or a double
/// click asks to see the net.
class NetsPanel : public QWidget {
    Q_OBJECT

public:
    NetsPanel(models::NetModel& model, models::SelectionModel& selection, QWidget* parent = nullptr);

    /// Whether the table follows the net of what is selected in the views.
    void setFollows(bool isOn) { m_follows = isOn; }
    /// Whether choosing a row also asks to see the net.
    void setShowsChosen(bool isOn) { m_showsChosen = isOn; }
    [[nodiscard]] TableView& table() { return *m_table; }
    [[nodiscard]] QLineEdit& filterEdit() { return *m_filter; }
    [[nodiscard]] QComboBox& kindBox() { return *m_kind; }
    [[nodiscard]] QString summary() const;

signals:
    void showRequested(model::NetId net);

private:
    void applyFilter();
    void onArranged();
    void takeFromTable();
    void showInTable();
    void scrollToSelected();

    models::NetModel& m_model;
    models::SelectionModel& m_selection;
    QLineEdit* m_filter;
    QComboBox* m_kind;
    QLabel* m_summary;
    TableView* m_table;
    bool m_isSyncing = false;  ///< the table is being changed to show what is highlighted
    bool m_follows = true;
    bool m_showsChosen = false;
};

}  // namespace ui
