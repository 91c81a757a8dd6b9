#pragma once

#include <QPainter>
#include <QStringList>

#include "model/measure/measurement.h"
#include "model/measure/snapping.h"
#include "ui/common/display_units.h"
#include "ui/views/board_position.h"
#include "ui/views/board_view.h"
#include "ui/views/label_placing.h"

namespace ui {

/// Where a view draws locations on layers.
class DrawnHeights {
public:
    DrawnHeights(const BoardView& view, const model::Document& document);

    /// In mm of the board's model: on the face of the layer that is seen; of no layer on the face of the board.
    [[nodiscard]] glm::vec3 at(base::PointD nm, const std::string& layer) const;
    [[nodiscard]] glm::vec3 at(const model::MeasuredEnd& end) const { return at({end.x, end.y}, end.layer); }

private:
    BoardPosition m_position;
    const model::Document& m_document;
    model::ZRange m_board;
    std::vector<render::ZRange> m_heights;
    bool m_isFromAbove;
};

/// Draws measurements over one view, at the heights at which the view draws their layers, and what was measured beside
/// them. Labels are drawn last, where there is room for them.
class MeasurementPainter {
public:
    MeasurementPainter(QPainter& painter, const BoardView& view, const model::Document& document);

    /// With `isFull` also parts, layers, nets and notes.
    void paint(const model::Measurement& measurement, LengthUnit unit, bool isFull);
    /// The mark of what a cursor catches, and a word for it.
    void paintSnap(const model::MeasuredEnd& end, model::SnapKind kind, const QString& word);
    /// All labels of what was painted, off the corners of the view as long as there is room. Call it once, at the end.
    /// Returns where they are.
    std::vector<QRectF> paintLabels();

private:
    struct Label {
        QStringList lines;
        QPointF beside;
    };

    /// Where a location is on the canvas; none behind the camera.
    [[nodiscard]] std::optional<QPointF> screenOf(base::PointD nm, const std::string& layer) const;
    [[nodiscard]] std::optional<QPointF> screenOf(const model::MeasuredEnd& end) const;
    [[nodiscard]] QRectF canvas() const { return {QPointF(), m_view.controller().viewport()}; }
    /// These draw one kind each; they return where its label belongs, none if it is not on the canvas.
    std::optional<QPointF> paintDistance(const model::Measurement& measurement);
    std::optional<QPointF> paintAngle(const model::Measurement& measurement);
    std::optional<QPointF> paintRadius(const model::Measurement& measurement);
    std::optional<QPointF> paintPath(const model::Measurement& measurement);
    /// The arc around a location from one direction over `sweep` radians, on a layer.
    [[nodiscard]] QPolygonF arcAround(base::PointD centre, const std::string& layer, double radius, double start,
                                      double sweep) const;
    void drawLine(const QPolygonF& line, double width, Qt::PenStyle style = Qt::SolidLine);
    void drawTick(QPointF at, QPointF along);
    void paintLabel(const Label& label, const QRectF& box) const;

    QPainter& m_painter;
    const BoardView& m_view;
    DrawnHeights m_heights;
    LabelPlacing m_placing;
    std::vector<Label> m_labels;
};

}  // namespace ui
