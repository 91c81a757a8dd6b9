#pragma once

#include <QWidget>
#include <optional>
#include <vector>

#include "model/section/section.h"
#include "ui/common/display_units.h"
#include "ui/section/section_dimension.h"
#include "ui/workspace/selection_model.h"

namespace ui {

/// A cross-section of a board, from the side: what is cut to scale, heights drawn larger than lengths, names,
/// thicknesses and heights of the layers at the right, a ruler along the line below. Two clicks with Shift measure a
/// distance. The wheel zooms, a drag pans, a double click shows all again, a click selects the element, whose pieces
/// are highlighted as are those of highlighted nets.
class SectionView : public QWidget {
    Q_OBJECT

public:
    explicit SectionView(SelectionModel& selection, QWidget* parent = nullptr);

    /// None empties the view. `board` is what was cut, and lives as long as the section is shown. Zoom and position
    /// stay as the user chose them, until `fit`.
    void setSection(std::shared_ptr<const model::BoardIndex> board, std::optional<model::Section> section);
    [[nodiscard]] const std::optional<model::Section>& section() const { return m_section; }
    /// One per layer of the board.
    void setColours(std::vector<QColor> colours);
    void setUnit(LengthUnit unit);
    /// Heights are drawn so many times larger than lengths; 0: as fills the view when all of the line is in it.
    void setHeightTimes(double times);
    /// As they are drawn now.
    [[nodiscard]] double heightTimes() const { return m_times; }
    /// Shows the whole line, also after the next changes of it.
    void fit();

    /// Where a location of the section is drawn, in pixels; lengths along the line and heights in nm.
    [[nodiscard]] QPointF positionOf(double along, double z) const;
    /// What is drawn there: what is solid before what was drilled out of it, small before large. Null: nothing.
    [[nodiscard]] const model::SectionPiece* pieceAt(QPointF at) const;
    [[nodiscard]] QString tipAt(QPointF at) const;
    /// The corner or else the edge of what is drawn that is nearest within a few pixels.
    [[nodiscard]] std::optional<SectionPosition> locationAt(QPointF at) const;
    [[nodiscard]] const SectionDimension& dimension() const { return m_dimension; }
    [[nodiscard]] QSize sizeHint() const override { return {600, 260}; }

protected:
    void paintEvent(QPaintEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;
    void wheelEvent(QWheelEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void mouseReleaseEvent(QMouseEvent* event) override;
    void mouseDoubleClickEvent(QMouseEvent* event) override;
    bool event(QEvent* event) override;

private:
    [[nodiscard]] QRectF plot() const;
    [[nodiscard]] double lineHeight() const { return fontMetrics().height() + 1.0; }
    [[nodiscard]] const model::Document& board() const { return *m_board->board; }
    [[nodiscard]] QRectF rectOf(const model::SectionPiece& piece) const;
    [[nodiscard]] bool isHighlighted(const model::SectionPiece& piece) const;
    void arrange();
    void paintPieces(QPainter& painter) const;
    void paintHighlighted(QPainter& painter) const;
    void paintCorners(QPainter& painter) const;
    [[nodiscard]] std::vector<const model::StackupRow*> namedRows() const;
    void paintLayers(QPainter& painter) const;
    void paintRuler(QPainter& painter) const;
    void paintDimension(QPainter& painter) const;

    SelectionModel& m_selection;
    std::shared_ptr<const model::BoardIndex> m_board;
    std::optional<model::Section> m_section;
    std::vector<model::SectionPiece> m_drawn;  ///< merged; what others lie in comes first
    std::vector<QColor> m_colours;
    LengthUnit m_unit = LengthUnit::Millimetre;
    double m_wantedTimes = 0.0;
    bool m_isFitted = true;

    double m_perNm = 1e-6;  ///< pixels
    double m_times = 1.0;
    double m_along = 0.0;  ///< what is in the middle of the plot, nm
    double m_z = 0.0;

    SectionDimension m_dimension;
    QPointF m_pressed;
    QPointF m_last;
    bool m_isDragged = false;
};

}  // namespace ui
