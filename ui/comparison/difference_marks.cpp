#include "ui/comparison/difference_marks.h"

#include <QPainter>

namespace ui {

namespace {

constexpr QColor kFrame(255, 221, 87);
constexpr QColor kRim(20, 20, 24, 220);
constexpr double kBesideChosen = 0.35;  ///< opacity of the other frames while a place is chosen
constexpr double kMargin = 4.0;         ///< pixels between a frame and what differs
constexpr double kLeast = 7.0;          ///< half the side of the smallest frame, in pixels

QPainterPath pathOf(const model::PolygonSet& polygons, model::Point origin) {
    QPainterPath path;
    path.setFillRule(Qt::OddEvenFill);
    for (std::size_t i = 0; i < polygons.loopCount(); ++i) {
        QPolygonF loop;
        for (const model::Point point : polygons.loop(i)) {
            loop += QPointF(static_cast<double>(point.x) - origin.x, static_cast<double>(point.y) - origin.y);
        }
        path.addPolygon(loop);
        path.closeSubpath();
    }
    return path;
}

void drawFrames(QPainter& painter, const std::vector<QPolygonF>& frames, double width, double opacity = 1.0) {
    painter.setOpacity(opacity);
    for (const auto& [colour, more] : {std::pair(kRim, 2.5), std::pair(kFrame, 0.0)}) {
        painter.setPen(QPen(colour, width + more, Qt::SolidLine, Qt::SquareCap, Qt::MiterJoin));
        for (const QPolygonF& frame : frames) {
            painter.drawPolygon(frame);
        }
    }
}

/// A box around them, with a margin, and never so small that it is not seen.
QPolygonF seenFrame(const QPolygonF& corners) {
    const QRectF around = corners.boundingRect();
    const QSizeF half(std::max(kLeast, around.width() / 2.0 + kMargin),
                      std::max(kLeast, around.height() / 2.0 + kMargin));
    return QRectF(around.center() - QPointF(half.width(), half.height()), 2.0 * half);
}

}  // namespace

DifferenceMarks::DifferenceMarks(BoardViews& views, Workspace& workspace, QObject* parent)
    : QObject(parent), m_views(views), m_workspace(workspace) {
    for (BoardView* view : views.both()) {
        view->addGroundPainter([this, view](QPainter& painter) { paint(painter, *view); });
    }
}

void DifferenceMarks::setPlaces(std::vector<Place> places) {
    m_places = std::move(places);
    m_views.requestOverlay();
}

void DifferenceMarks::choose(const Place& place) {
    m_chosen = place;
    m_only = {};
    m_views.requestOverlay();
}

bool DifferenceMarks::setOnly(const std::array<model::PolygonSet, 2>& only) {
    if (!m_chosen || only[0].points.size() + only[1].points.size() > kMostPoints) {
        return !m_chosen;
    }
    m_only = {pathOf(only[0], m_chosen->box.min), pathOf(only[1], m_chosen->box.min)};
    m_views.requestOverlay();
    return true;
}

bool DifferenceMarks::clearChosen() {
    const bool wasChosen = m_chosen.has_value();
    m_chosen.reset();
    m_only = {};
    m_views.requestOverlay();
    return wasChosen;
}

void DifferenceMarks::setShown(bool isShown) {
    m_isShown = isShown;
    m_views.requestOverlay();
}

void DifferenceMarks::paint(QPainter& painter, const BoardView& view) const {
    if (!m_isShown || !view.hasScene()) {
        return;
    }
    if (view.kind() == BoardView::Kind::Flat) {
        paintOnly(painter, view);
    }
    painter.setRenderHint(QPainter::Antialiasing, false);
    painter.setBrush(Qt::NoBrush);
    const Heights heights{view.drawnHeights(), view.seenFace(*m_workspace.board()->document)};
    std::vector<QPolygonF> frames;
    for (const Place& place : m_places) {
        if (const std::optional<QPolygonF> frame = place == m_chosen ? std::nullopt : frameOf(place, view, heights)) {
            frames.push_back(*frame);
        }
    }
    drawFrames(painter, frames, 1.0, m_chosen ? kBesideChosen : 1.0);
    if (const std::optional<QPolygonF> frame = m_chosen ? frameOf(*m_chosen, view, heights) : std::nullopt) {
        drawFrames(painter, {*frame}, 2.5);
    }
}

/// None where it is out of sight.
std::optional<QPolygonF> DifferenceMarks::frameOf(const Place& place, const BoardView& view, const Heights& heights) {
    const auto& [min, max] = place.box;
    const std::size_t row = place.layer.row();
    const float height = row < heights.layers.size() ? heights.layers[row].z0 : heights.face;
    QPolygonF corners;
    for (const model::Point corner : {min, model::Point{max.x, min.y}, max, model::Point{min.x, max.y}}) {
        glm::vec3 point = view.position().toModel(base::toDouble(corner));
        point.z = height;
        const std::optional<QPointF> at = view.controller().screenOf(point);
        if (!at) {
            return std::nullopt;
        }
        corners += *at;
    }
    const QPolygonF frame = seenFrame(corners);
    const QRectF canvas(QPointF(), view.controller().viewport());
    return canvas.intersects(frame.boundingRect()) ? std::optional(frame) : std::nullopt;
}

void DifferenceMarks::paintOnly(QPainter& painter, const BoardView& view) const {
    if (!m_chosen || (m_only[0].isEmpty() && m_only[1].isEmpty())) {
        return;
    }
    const base::PointD origin = base::toDouble(m_chosen->box.min);
    const auto screenOf = [&](double x, double y) { return *view.screenOf({origin.x + x, origin.y + y}); };
    const QPointF at = screenOf(0.0, 0.0);
    const QPointF right = (screenOf(base::kNmPerMm, 0.0) - at) / base::kNmPerMm;
    const QPointF up = (screenOf(0.0, base::kNmPerMm) - at) / base::kNmPerMm;
    painter.save();
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(Qt::NoPen);
    painter.setTransform(QTransform(right.x(), right.y(), up.x(), up.y(), at.x(), at.y()), true);
    for (std::size_t side = 0; side < m_only.size(); ++side) {
        painter.fillPath(m_only[side], kOnlyColours[side]);
    }
    painter.restore();
}

}  // namespace ui
