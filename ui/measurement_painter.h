#pragma once

#include <QPainter>

#include "model/measure/snapping.h"
#include "model/session/measurement.h"
#include "ui/board_place.h"
#include "ui/board_view.h"
#include "ui/models/lengths.h"

namespace ui {

/// Where a view draws an end of a measurement, in mm of the board's model: on the face of its layer that is seen.
[[nodiscard]] glm::vec3 drawnPlaceOf(const BoardView& view, BoardPlace place, const model::Document& document,
                                     const model::session::MeasuredEnd& end);

/// Draws measurements over one view: a dimension line from end to end, at the heights at which the view draws their
/// layers, and what was measured beside it.
class MeasurementPainter {
public:
    MeasurementPainter(QPainter& painter, const BoardView& view, BoardPlace place, const model::Document& document);

    /// With `isFull` also the parts along the axes, layers and nets.
    void paint(const model::session::Measurement& measurement, models::LengthUnit unit, bool isFull) const;
    /// The mark of what a cursor catches, and its name.
    void paintSnap(const model::session::MeasuredEnd& end, model::SnapKind kind) const;

private:
    /// Where an end is on the canvas; none behind the eye.
    [[nodiscard]] std::optional<QPointF> screenOf(const model::session::MeasuredEnd& end) const;
    void paintLine(QPointF from, QPointF to) const;
    void paintLabel(const QStringList& lines, QPointF beside) const;

    QPainter& m_painter;
    const BoardView& m_view;
    BoardPlace m_place;
    const model::Document& m_document;
};

}  // namespace ui
