#pragma once

#include <QDialog>
#include <vector>

#include "ui/assignment/assignment_model.h"

class QLabel;
class QPushButton;

namespace ui {

class TableView;

/// What the files of a Gerber job draw, to be told; nothing counts before it is accepted. What nobody knows is at the
/// top, and the keyboard begins there: Enter opens a cell with its list, letters choose, Ctrl+Enter accepts.
class AssignmentDialog : public QDialog {
    Q_OBJECT

public:
    /// `proposals`: as the job is open. `found`: as it would be without a layer map. `job`: its name, for people;
    /// `map`: where it is remembered.
    AssignmentDialog(const QString& job, const QString& map, std::vector<model::gerber::LayerProposal> proposals,
                     std::vector<model::gerber::LayerProposal> found, QWidget* parent = nullptr);

    /// What was told.
    [[nodiscard]] model::gerber::LayerMap map() const { return model::gerber::mapOf(m_model.proposals()); }

protected:
    void keyPressEvent(QKeyEvent* event) override;
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    TableView* makeTable();
    void show(std::vector<model::gerber::LayerProposal> proposals);
    /// Ctrl+Enter accepts, Enter in the table does not. True if the key needs nothing else.
    bool takeEnter(const QKeyEvent& event);

    AssignmentModel m_model;
    std::vector<model::gerber::LayerProposal> m_found;
    TableView* m_table;
    QPushButton* m_ok;
    QLabel* m_hint;  ///< why the last edit was refused
};

}  // namespace ui
