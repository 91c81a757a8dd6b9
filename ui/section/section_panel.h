#pragma once

#include <QLabel>
#include <QWidget>

#include "ui/section/section_view.h"

class QAction;
class QAbstractItemModel;
class QComboBox;
class QListView;

namespace ui {

class ActionSet;

/// A cross-section with its commands above it and what its reader must know below it.
class SectionPanel : public QWidget {
    Q_OBJECT

public:
    /// `kept`: names of the sections that are kept.
    SectionPanel(SelectionModel& selection, QAbstractItemModel& kept, const ActionSet& actions,
                 QWidget* parent = nullptr);

    [[nodiscard]] SectionView& view() { return *m_view; }
    [[nodiscard]] QListView& list() { return *m_list; }
    [[nodiscard]] QComboBox& heightsBox() { return *m_heights; }
    /// In plain words; empty ones take no room.
    void setRemarks(const QString& notes);
    [[nodiscard]] QString notes() const { return m_notes->text(); }

signals:
    /// The section is not wanted any more.
    void cleared();
    /// A kept section is to be shown, or is not wanted any more.
    void chosen(int row);
    void forgotten(int row);

private:
    SectionView* m_view;
    QListView* m_list;
    QComboBox* m_heights;
    QLabel* m_notes;
};

}  // namespace ui
