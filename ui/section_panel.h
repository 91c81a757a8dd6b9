#pragma once

#include <QLabel>
#include <QWidget>

#include "ui/section_view.h"

class QAction;
class QComboBox;

namespace ui {

class ActionSet;

/// A cross-section with its commands above it and what its reader must know below it.
class SectionPanel : public QWidget {
    Q_OBJECT

public:
    SectionPanel(models::SelectionModel& selection, const ActionSet& actions, QWidget* parent = nullptr);

    [[nodiscard]] SectionView& view() { return *m_view; }
    [[nodiscard]] QComboBox& heightsBox() { return *m_heights; }
    /// In plain words; empty ones take no room.
    void setRemarks(const QString& remarks);
    [[nodiscard]] QString remarks() const { return m_remarks->text(); }

signals:
    /// The section is not wanted any more.
    void cleared();

private:
    SectionView* m_view;
    QComboBox* m_heights;
    QLabel* m_remarks;
};

}  // namespace ui
