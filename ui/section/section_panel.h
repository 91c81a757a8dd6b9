#pragma once

#include <QLabel>
#include <QWidget>

#include "ui/section/section_view.h"

class QComboBox;

namespace ui {

class ActionSet;
class SectionListModel;
class TableView;

/// A cross-section with its commands above it and what its reader must know below it.
class SectionPanel : public QWidget {
    Q_OBJECT

public:
    /// `saved` is listed beside the view once there are some.
    SectionPanel(SelectionModel& selection, SectionListModel& saved, const ActionSet& actions,
                 QWidget* parent = nullptr);

    [[nodiscard]] SectionView& view() { return *m_view; }
    /// Of saved sections: its row that is chosen is to be shown, and it says which ones are to be deleted.
    [[nodiscard]] TableView& list() { return *m_list; }
    [[nodiscard]] QComboBox& heightsBox() { return *m_heights; }
    /// Notes; empty ones take no room.
    void setNotes(const QString& notes);
    [[nodiscard]] QString notes() const { return m_notes->text(); }

signals:
    /// The section is not wanted any more.
    void cleared();

private:
    void addListCommands();

    SectionView* m_view;
    TableView* m_list;
    QComboBox* m_heights;
    QLabel* m_notes;
};

}  // namespace ui
