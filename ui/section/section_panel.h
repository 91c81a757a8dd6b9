#pragma once

#include <QLabel>
#include <QWidget>

#include "ui/section/section_view.h"

class QAbstractItemModel;
class QComboBox;
class QListView;

namespace ui {

class ActionSet;

/// A cross-section with its commands above it and what its reader must know below it.
class SectionPanel : public QWidget {
    Q_OBJECT

public:
    /// `saved`: names of the saved sections, which are listed beside the view once there are some.
    SectionPanel(SelectionModel& selection, QAbstractItemModel& saved, const ActionSet& actions,
                 QWidget* parent = nullptr);

    [[nodiscard]] SectionView& view() { return *m_view; }
    [[nodiscard]] QListView& list() { return *m_list; }
    [[nodiscard]] QComboBox& heightsBox() { return *m_heights; }
    /// Notes; empty ones take no room.
    void setNotes(const QString& notes);
    [[nodiscard]] QString notes() const { return m_notes->text(); }

signals:
    /// The section is not wanted any more.
    void cleared();
    /// A saved section is to be shown, or deleted.
    void chosen(int row);
    void forgotten(int row);

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    void addListCommands();
    void showSaved(const QModelIndex& saved);

    SectionView* m_view;
    QListView* m_list;
    QComboBox* m_heights;
    QLabel* m_notes;
};

}  // namespace ui
