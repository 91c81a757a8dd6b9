#include "ui/section/section_handle.h"

#include <QLineF>
#include <QMouseEvent>
#include <QPainter>
#include <cmath>

#include "ui/section/section_ink.h"

namespace ui {

namespace {

constexpr double kHalf = 20.0;  // of the arrow, pixels
constexpr double kHead = 8.0;
constexpr double kGripPixels = 8.0;
constexpr QColor kInkHovered(255, 190, 230);

/// Seen straight from the front the plane would leave the pointer behind: a pixel moves it by as much as this share of
/// a pixel, seen from the side, at most.
constexpr double kFlattest = 0.25;

double lengthOf(QPointF way) {
    return std::hypot(way.x(), way.y());
}

QPolygonF headAt(QPointF tip, QPointF way) {
    const QPointF across(-way.y(), way.x());
    const QPointF foot = tip - kHead * way;
    return {{tip, foot + kHead * 0.6 * across, foot - kHead * 0.6 * across}};
}

}  // namespace

SectionHandle::SectionHandle(BoardView& solid, SectionPlaneTool& plane, QObject* parent)
    : QObject(parent), m_view(solid), m_plane(plane) {
    solid.addPainter([this](QPainter& painter) { paint(painter); }, BoardView::Shown::OnCanvas);
    solid.controller().addTaker([this](QEvent& event) { return take(event); });
}

std::optional<QPointF> SectionHandle::place() const {
    return m_plane.isOn() ? onCanvas(foot()) : std::nullopt;
}

/// Where it stands on the plane.
base::PointD SectionHandle::foot() const {
    const QRectF canvas({}, m_view.controller().viewport());
    const base::PointD middle = m_plane.middle();
    const std::optional<QPointF> place = onCanvas(middle);
    if (place && canvas.contains(*place)) {
        return middle;
    }
    const std::optional<glm::vec3> seen = m_view.controller().boardPointAt(canvas.center());
    return seen ? m_plane.nearestTo(m_view.position().toJob(*seen)) : middle;
}

std::optional<QPointF> SectionHandle::onCanvas(base::PointD location) const {
    glm::vec3 point = m_view.position().toModel(location);
    point.z = m_view.seenFace(m_plane.board());
    return m_view.controller().screenOf(point);
}

/// Along the way forward. From the front, where that is no way on the canvas, up is forward.
QPointF SectionHandle::pixelsPerNm() const {
    const base::PointD from = foot();
    const base::PointD forward = m_plane.forward();
    constexpr double kWay = 1e6;
    const double fromTheSide = 1.0 / m_view.controller().nmPerPixel();
    const auto a = onCanvas(from);
    const auto b = onCanvas({from.x + kWay * forward.x, from.y + kWay * forward.y});
    const QPointF way = a && b ? (*b - *a) / kWay : QPointF();
    const double length = lengthOf(way);
    const double least = kFlattest * fromTheSide;
    return length > 0.01 * least ? way * (std::max(length, least) / length) : QPointF(0.0, -least);
}

bool SectionHandle::isAt(QPointF position) const {
    const std::optional<QPointF> middle = place();
    if (!middle) {
        return false;
    }
    const QPointF way = pixelsPerNm() / lengthOf(pixelsPerNm());
    const QPointF off = position - *middle;
    const double along = QPointF::dotProduct(off, way);
    const double across = QPointF::dotProduct(off, {-way.y(), way.x()});
    return std::abs(along) <= kHalf && std::abs(across) <= kGripPixels;
}

bool SectionHandle::take(QEvent& event) {
    switch (event.type()) {
        case QEvent::MouseButtonPress:
        case QEvent::MouseButtonDblClick: return press(static_cast<const QMouseEvent&>(event));
        case QEvent::MouseMove: return move(static_cast<const QMouseEvent&>(event));
        case QEvent::MouseButtonRelease: return release(static_cast<const QMouseEvent&>(event));
        case QEvent::Leave: setHovered(false); return false;
        default: return false;
    }
}

bool SectionHandle::press(const QMouseEvent& event) {
    if (!m_drag && event.button() == Qt::LeftButton && isAt(event.position())) {
        m_drag = Drag{event.position(), foot(), m_plane.forward(), pixelsPerNm()};
    }
    return m_drag.has_value();
}

bool SectionHandle::move(const QMouseEvent& event) {
    if (!m_drag) {
        setHovered(event.buttons() == Qt::NoButton && isAt(event.position()));
        return m_isHovered;
    }
    if (!m_plane.isOn()) {  // a key has taken it away
        m_drag.reset();
        return false;
    }
    const QPointF way = m_drag->pixelsPerNm;
    const double nm = QPointF::dotProduct(event.position() - m_drag->from, way) / QPointF::dotProduct(way, way);
    m_plane.put({m_drag->through.x + nm * m_drag->forward.x, m_drag->through.y + nm * m_drag->forward.y});
    return true;
}

bool SectionHandle::release(const QMouseEvent& event) {
    if (!m_drag || event.button() != Qt::LeftButton) {
        return m_drag.has_value();
    }
    m_drag.reset();
    setHovered(isAt(event.position()));
    return true;
}

void SectionHandle::setHovered(bool isHovered) {
    if (isHovered == m_isHovered) {
        return;
    }
    if (isHovered) {
        emit m_view.controller().left();  // whatever of the board was under the cursor no longer is
    }
    m_isHovered = isHovered;
    m_view.requestOverlay();
}

void SectionHandle::paint(QPainter& painter) const {
    const std::optional<QPointF> middle = place();
    if (!middle) {
        return;
    }
    const QPointF way = pixelsPerNm() / lengthOf(pixelsPerNm());
    const QPolygonF ahead = headAt(*middle + kHalf * way, way);
    const QPolygonF back = headAt(*middle - kHalf * way, -way);
    const QLineF shaft(*middle - (kHalf - kHead) * way, *middle + (kHalf - kHead) * way);
    const QColor ink = m_isHovered || m_drag ? kInkHovered : kSectionInk;
    for (const auto& [colour, wider] : {std::pair(kSectionRim, 2.0), std::pair(ink, 0.0)}) {
        painter.setPen(QPen(colour, 4.0 + wider));
        painter.drawLine(shaft);
        painter.setPen(QPen(colour, 1.0 + wider));
        painter.setBrush(colour);
        painter.drawPolygon(ahead);
        painter.drawPolygon(back);
    }
}

}  // namespace ui
