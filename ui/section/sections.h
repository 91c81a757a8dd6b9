#pragma once

#include <QObject>
#include <QTimer>

#include "ui/section/saved_sections.h"
#include "ui/section/section_line.h"
#include "ui/section/section_panel.h"
#include "ui/views/board_views.h"

namespace ui {

/// Cross-sections, from the line in the 2D view to the cut in its panel. Every move of the line cuts anew.
class Sections : public QObject {
    Q_OBJECT

public:
    Sections(BoardViews& views, SelectionModel& selection, const ActionSet& actions, QUndoStack& history,
             QObject* parent = nullptr);

    void setBoard(const LoadedBoard& board);
    /// The same board with other heights.
    void setHeights(std::shared_ptr<const model::Document> board);
    /// One per layer.
    void setColours(std::vector<QColor> colours);
    void setUnit(LengthUnit unit) { m_panel->view().setUnit(unit); }

    /// The next drag or clicks in the 2D view draw the line, or do not: the line is then what it was.
    void draw(bool isOn);
    /// Ends drawing; false if nothing was being drawn.
    bool giveUp();
    /// Cuts along a line, corners in nm of the board; none: no section.
    void cutAlong(std::vector<base::PointD> line);
    /// The ends of the line, if it is straight.
    [[nodiscard]] std::optional<std::pair<base::PointD, base::PointD>> straightLine() const;
    /// Cuts along the highlighted net, unrolled; of a net of a step that is placed often, along its first copy.
    void followNet();
    /// Keeps the line by name.
    void keep();
    /// Cuts along the line that is kept in this row.
    void goTo(int row);
    /// Writes what is shown as SVG. Errors: BadUsage if nothing is, OutputFailed.
    [[nodiscard]] base::Status save(const QString& path) const;

    /// Belongs to whoever shows it.
    [[nodiscard]] SectionPanel& panel() { return *m_panel; }
    [[nodiscard]] SectionLine& line() { return m_line; }
    [[nodiscard]] SavedSections& keeping() { return m_keeping; }

signals:
    /// A line has been drawn or moved, and is in place.
    void placed();
    /// What came of a command, in words.
    void reported(const QString& what);

private:
    void cut();

    SelectionModel& m_selection;
    SectionLine m_line;
    SavedSections m_keeping;
    SectionPanel* m_panel;
    std::shared_ptr<const model::BoardIndex> m_index;
    std::vector<QColor> m_colours;
    QTimer m_due;  ///< runs out once all moves of the line that are under way have come
};

}  // namespace ui
