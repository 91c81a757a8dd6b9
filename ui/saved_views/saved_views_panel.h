#pragma once

#include <QWidget>

#include "ui/saved_views/view_list_model.h"

class QAction;

namespace ui {

class ActionSet;
class TableView;

/// The kept views. A click on one, or Enter, asks to look so again; F2 or a double click renames it, Del forgets it.
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
    QAction* m_delete;
};

}  // namespace ui
