#pragma once

#include <QWidget>

#include "ui/saved_views/view_list_model.h"

namespace ui {

class ActionSet;
class TableView;

/// The saved views. A click on one, or Enter, restores it; F2 or a double click renames it, Del deletes it.
class SavedViewsPanel : public QWidget {
    Q_OBJECT

public:
    SavedViewsPanel(ViewListModel& list, const ActionSet& actions, QWidget* parent = nullptr);

    [[nodiscard]] TableView& table() { return *m_table; }

signals:
    void chosen(int row);
    void forgotten(int row);

private:
    TableView* m_table;
};

}  // namespace ui
