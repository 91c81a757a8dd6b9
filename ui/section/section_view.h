#pragma once

#include <QPolygonF>
#include <QWidget>
#include <array>
#include <optional>
#include <vector>

#include "model/section/net_line.h"
#include "model/section/section.h"
#include "model/section/section_labels.h"
#include "ui/common/display_units.h"
#include "ui/section/section_dimensions.h"
#include "ui/workspace/selection_model.h"

namespace ui {

/// A cross-section of a board, from the side: what is cut to scale, heights drawn larger than lengths, names,
/// thicknesses and heights of the layers at the right, a ruler along the line and a legend of the materials below. Of
/// an unrolled net a band above says on which layer it runs. While measuring is on, or with Shift, two clicks measure a
/// distance, and Del takes the last one back; what the next click is for, and why one has measured nothing, is
/// signalled for whoever can say it. The wheel zooms, a drag pans, a double click shows all again, a click
/// selects the element, whose pieces are highlighted as are those of highlighted nets. A tool tip describes what is
/// under the pointer, but not while a distance is being measured. A right click opens a menu of what clicks do, and of
/// the actions that were added to the view.
class SectionView : public QWidget {
    Q_OBJECT

public:
    explicit SectionView(SelectionModel& selection, QWidget* parent = nullptr);

    /// None empties the view. `board` is what was cut, and lives as long as the section is shown. Zoom and position
    /// stay as the user chose them, until `fit`; dimensions stay too.
    void setSection(std::shared_ptr<const model::BoardIndex> board, std::optional<model::Section> section);
    [[nodiscard]] const std::optional<model::Section>& section() const { return m_section; }
    /// Where an unrolled net runs; empty: the line follows none.
    void setRuns(std::vector<model::LayerRun> runs);
    [[nodiscard]] const std::vector<model::LayerRun>& runs() const { return m_runs; }
    /// One per layer of the board.
    void setColours(std::vector<QColor> colours);
    void setUnit(LengthUnit unit);
    [[nodiscard]] LengthUnit unit() const { return m_unit; }
    /// Heights are drawn so many times larger than lengths; 0: as fills the view when all of the line is in it.
    void setHeightTimes(double times);
    /// As they are drawn now.
    [[nodiscard]] double heightTimes() const { return m_times; }
    /// Shows the whole line, also after the next changes of it.
    void fit();

    /// Clicks measure instead of selecting.
    void setMeasuring(bool isOn);
    [[nodiscard]] bool isMeasuring() const { return m_isMeasuring; }
    /// What the next click measures, for the user who has the pointer here; empty: clicks do not measure.
    [[nodiscard]] QString prompt() const;
    void setDimensions(std::vector<model::SectionDimension> dimensions);
    [[nodiscard]] const SectionDimensions& dimensions() const { return m_dimensions; }
    /// Gives the first click of a distance up. False if there was none.
    bool stepBack();
    /// Takes what was clicked last back, as Del does.
    void removeLastDimension();
    /// Does either end not lie on an edge of what is drawn any more? The board has other heights than it had then.
    [[nodiscard]] bool isStale(const model::SectionDimension& dimension) const;

    /// Where a location of the section is drawn, in pixels; lengths along the line and heights in nm.
    [[nodiscard]] QPointF positionOf(double along, double z) const;
    /// What is written beside a dimension, and whether it is stale as it is drawn.
    [[nodiscard]] QString textOf(const model::SectionDimension& dimension) const;
    [[nodiscard]] bool isShownStale(const model::SectionDimension& dimension) const;
    /// Where the name of a row of the stackup points to; none: the row is not in sight.
    [[nodiscard]] std::optional<QPointF> markOf(std::size_t row) const;
    /// What is written beside the section of each row of the stackup that is named: name, thickness and height above
    /// the bottom. Where there is no room for all, heights are left out, then thicknesses, then names are cut.
    using LabelTexts = std::array<QString, 3>;
    [[nodiscard]] std::vector<LabelTexts> labels() const;
    /// Parts that are too high to be shown whole beside the board while all of the line is: they end in a break line.
    [[nodiscard]] std::vector<QRectF> brokenParts() const;
    /// What is drawn there: what is solid before what was drilled out of it, small before large. Null: nothing.
    [[nodiscard]] const model::SectionPiece* pieceAt(QPointF at) const;
    [[nodiscard]] QString tipAt(QPointF at) const;
    /// The corner or else the edge of what is drawn that is nearest within a few pixels. What leans has corners and
    /// level edges.
    [[nodiscard]] std::optional<model::SectionPosition> locationAt(QPointF at) const;
    /// A material that is shown: the colours it has, of layers from the top, and its name.
    using LegendRow = std::pair<std::vector<QColor>, QString>;
    [[nodiscard]] std::vector<LegendRow> legend() const;
    [[nodiscard]] QSize sizeHint() const override { return {600, 260}; }

signals:
    /// The user has added a distance or taken one back.
    void dimensionsChanged();
    void promptChanged(const QString& prompt);
    /// The user has measured this, or has clicked and not measured for this reason.
    void measured(const QString& text);
    void refused(const QString& why);

protected:
    void paintEvent(QPaintEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;
    void wheelEvent(QWheelEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void mouseReleaseEvent(QMouseEvent* event) override;
    void mouseDoubleClickEvent(QMouseEvent* event) override;
    void enterEvent(QEnterEvent* event) override;
    void leaveEvent(QEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    void contextMenuEvent(QContextMenuEvent* event) override;
    bool event(QEvent* event) override;

private:
    [[nodiscard]] QRectF plot() const;
    [[nodiscard]] double lineHeight() const { return fontMetrics().height() + 1.0; }
    [[nodiscard]] const model::Document& board() const { return *m_board->board; }
    [[nodiscard]] QRectF rectOf(const model::SectionPiece& piece) const;
    [[nodiscard]] QPolygonF outlineOf(const model::SectionPiece& piece) const;
    [[nodiscard]] QColor colourOf(const model::SectionPiece& piece) const;
    [[nodiscard]] QString dielectricText(const model::SectionPiece& piece, const model::StackupRow& row) const;
    [[nodiscard]] bool isHighlighted(const model::SectionPiece& piece) const;
    [[nodiscard]] bool isEdge(const model::SectionPosition& position) const;
    void measureAt(QPointF at);
    /// The element that is drawn there, or nothing.
    void selectAt(QPointF at);
    void openMenu(QPointF at);
    /// "R20.1", or "R20" of bodies and of pads of several pins; empty: it is of no component.
    [[nodiscard]] QString componentOf(const model::SectionPiece& piece) const;
    /// Repaints, and signals the prompt if it is another.
    void updateMeasuring();
    [[nodiscard]] std::pair<double, double> fittedHeights() const;
    void arrange();
    void paintPieces(QPainter& painter) const;
    void paintBreaks(QPainter& painter) const;
    void paintHighlighted(QPainter& painter) const;
    struct NamedRow {
        const model::StackupRow* row = nullptr;
        std::optional<model::RowMark> mark;
        double y = 0.0;  ///< of what is named
    };
    /// Where the three texts of a row begin; each ends where the next one does, one without room is empty.
    struct LabelColumns {
        double name = 0.0;
        double thickness = 0.0;
        double height = 0.0;
        double end = 0.0;
    };
    /// How wide the texts of rows are, with what is between them.
    struct LabelWidths {
        double name = 0.0;
        double thickness = 0.0;
        double height = 0.0;
    };
    [[nodiscard]] LabelWidths widthsOf(const std::vector<NamedRow>& rows) const;
    /// What the labels of all rows take, in sight or not, so that zooming does not move the cut.
    [[nodiscard]] double roomForLabels() const;
    [[nodiscard]] model::SectionWindow window() const;
    [[nodiscard]] std::vector<NamedRow> namedRows() const;
    [[nodiscard]] QString heightText(const NamedRow& named) const;
    [[nodiscard]] QString nameIn(const NamedRow& named, double room) const;
    [[nodiscard]] bool areTold(const std::vector<NamedRow>& rows, double room) const;
    [[nodiscard]] LabelColumns labelColumns(const std::vector<NamedRow>& rows) const;
    [[nodiscard]] LabelTexts textsOf(const NamedRow& named, const LabelColumns& columns) const;
    void paintLabel(QPainter& painter, const NamedRow& named, double y, const LabelColumns& columns) const;
    [[nodiscard]] std::vector<std::uint32_t> layerColours() const;
    void paintLayers(QPainter& painter) const;
    void paintRuler(QPainter& painter) const;
    void paintLegend(QPainter& painter) const;
    void paintBends(QPainter& painter) const;
    void paintRuns(QPainter& painter) const;
    void paintDimensions(QPainter& painter) const;
    void paintDimension(QPainter& painter, const model::SectionDimension& dimension, std::vector<QRectF>& taken) const;

    SelectionModel& m_selection;
    std::shared_ptr<const model::BoardIndex> m_board;
    std::optional<model::Section> m_section;
    std::vector<model::SectionPiece> m_drawn;  ///< merged; what others lie in comes first
    std::vector<model::LayerRun> m_runs;
    std::vector<QColor> m_colours;
    LengthUnit m_unit = LengthUnit::Millimetre;
    double m_wantedTimes = 0.0;
    bool m_isFitted = true;

    double m_labelRoom = 0.0;  ///< at the right, pixels
    double m_perNm = 1e-6;     ///< pixels
    double m_times = 1.0;
    double m_along = 0.0;  ///< what is in the middle of the plot, nm
    double m_z = 0.0;

    SectionDimensions m_dimensions;
    bool m_isMeasuring = false;
    bool m_isPointedAt = false;
    QString m_prompt;                               ///< as it was signalled last
    std::optional<model::SectionPosition> m_under;  ///< the pointer, while measuring
    QPointF m_pressed;
    QPointF m_last;
    bool m_isDragged = false;
    bool m_endsDoubleClick = false;  ///< the next release: the section was fitted under it
};

}  // namespace ui
