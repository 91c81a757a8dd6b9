#include "ui/section/section_line.h"

#include <QKeyEvent>
#include <QMouseEvent>
#include <QPainter>
#include <algorithm>
#include <cmath>
#include <utility>

#include "model/measure/snapping.h"
#include "ui/section/section_ink.h"

namespace ui {

namespace {

constexpr double kGripPixels = 8.0;
constexpr double kCornerPixels = 4.0;
constexpr double kHandlesApart = 24.0;  // three of their diameters: what lies under them can be seen

}  // namespace

SectionLine::SectionLine(BoardView& flat, QObject* parent) : QObject(parent), m_view(flat) {
    flat.addPainter([this](QPainter& painter) { paint(painter); });
    flat.controller().addTaker([this](QEvent& event) { return take(event); });
}

void SectionLine::clear() {
    m_held.reset();
    m_isDrawing = m_isLaying = false;
    setLine({});
}

void SectionLine::setShown(bool isShown) {
    m_isShown = isShown;
    m_view.requestOverlay();
}

void SectionLine::setDrawing(bool isOn) {
    if (isOn == m_isDrawing) {
        return;
    }
    m_isDrawing = isOn;
    if (isOn) {
        m_before = m_line;
        return;
    }
    m_held.reset();
    m_isLaying = false;
    setLine(m_before);
    emit finished();
}

void SectionLine::setLine(std::vector<base::PointD> line) {
    m_held.reset();  // it was a corner of the line before
    m_line = std::move(line);
    m_view.requestOverlay();
}

bool SectionLine::take(QEvent& event) {
    if (m_isLaying) {
        return lay(event);
    }
    switch (event.type()) {
        case QEvent::MouseButtonPress: return press(static_cast<const QMouseEvent&>(event));
        case QEvent::MouseMove:
            if (m_held) {
                moveCorner(*m_held, static_cast<const QMouseEvent&>(event));
            }
            return m_held.has_value();
        case QEvent::MouseButtonRelease:
            if (!m_held || static_cast<const QMouseEvent&>(event).button() != Qt::LeftButton) {
                return m_held.has_value();
            }
            release();
            return true;
        case QEvent::ShortcutOverride:
        case QEvent::KeyPress: return takeEscape(static_cast<QKeyEvent&>(event));
        default: return false;
    }
}

/// Of a corner that is being moved. While a line is drawn it is the command that ends the tool.
bool SectionLine::takeEscape(QKeyEvent& event) {
    if (!m_held || m_isDrawing || event.key() != Qt::Key_Escape) {
        return false;
    }
    event.accept();
    if (event.type() == QEvent::KeyPress) {
        setLine(m_before);
        emit putBack();
    }
    return true;
}

bool SectionLine::press(const QMouseEvent& event) {
    if (m_held || event.button() != Qt::LeftButton || !m_view.hasScene() || !isThere()) {
        return m_held.has_value();
    }
    if (m_isDrawing) {
        const base::PointD start = m_view.locationAt(event.position());
        setLine({start, start});
        m_held = 1;
    } else if (!event.modifiers().testFlag(Qt::ControlModifier)) {
        m_held = cornerAt(event.position());
        m_before = m_line;
    }
    return m_held.has_value();
}

/// Straight from the corner beside it, with Shift.
void SectionLine::moveCorner(std::size_t corner, const QMouseEvent& event) {
    base::PointD to = m_view.locationAt(event.position());
    if (event.modifiers().testFlag(Qt::ShiftModifier)) {
        to = model::straightened(m_line[corner == 0 ? 1 : corner - 1], to, 45.0);
    }
    m_line[corner] = to;
    m_view.requestOverlay();
    emit moved();
}

void SectionLine::release() {
    m_held.reset();
    if (m_isDrawing && isClick(m_line[0], m_line[1])) {
        m_isLaying = true;  // its first corner is set
        setLine({m_line[0], m_line[0]});
        emit moved();
        return;
    }
    m_isDrawing = false;
    emit finished();
}

bool SectionLine::isClick(base::PointD from, base::PointD to) const {
    return std::hypot(to.x - from.x, to.y - from.y) < CameraController::kClickPixels * m_view.controller().nmPerPixel();
}

bool SectionLine::lay(QEvent& event) {
    switch (event.type()) {
        case QEvent::MouseButtonPress: return layPress(static_cast<const QMouseEvent&>(event));
        case QEvent::MouseButtonDblClick: endLaying(); return true;
        case QEvent::MouseMove: moveCorner(m_line.size() - 1, static_cast<const QMouseEvent&>(event)); return false;
        case QEvent::ShortcutOverride: return keepKey(static_cast<QKeyEvent&>(event));
        case QEvent::KeyPress: return layKey(static_cast<const QKeyEvent&>(event));
        default: return false;
    }
}

bool SectionLine::layPress(const QMouseEvent& event) {
    if (event.button() != Qt::LeftButton) {
        return false;  // the camera moves meanwhile
    }
    moveCorner(m_line.size() - 1, event);
    if (!isClick(m_line[m_line.size() - 2], m_line.back())) {
        m_line.push_back(m_line.back());
    }
    return true;
}

/// Keys of the line are no commands meanwhile, whatever the user's keys are.
bool SectionLine::keepKey(QKeyEvent& event) {
    const bool isOwn =
        event.key() == Qt::Key_Return || event.key() == Qt::Key_Enter || event.key() == Qt::Key_Backspace;
    event.setAccepted(isOwn || event.isAccepted());
    return isOwn;
}

bool SectionLine::layKey(const QKeyEvent& event) {
    switch (event.key()) {
        case Qt::Key_Return:
        case Qt::Key_Enter: endLaying(); return true;
        case Qt::Key_Backspace:
            if (m_line.size() > 2) {
                m_line.erase(m_line.end() - 2);
            } else {
                m_isLaying = false;  // the first corner is to be set anew
                m_line.clear();
            }
            m_view.requestOverlay();
            emit moved();
            return true;
        default: return false;
    }
}

/// What was clicked is the line; the leg to the cursor is not part of it.
void SectionLine::endLaying() {
    if (m_line.size() < 3) {
        return;  // one corner is no line
    }
    m_line.pop_back();
    m_isLaying = m_isDrawing = false;
    m_view.requestOverlay();
    emit finished();
}

std::vector<std::size_t> SectionLine::handles() const {
    std::vector<std::size_t> shown;
    std::vector<QPointF> taken;
    const QRectF sight({}, m_view.controller().viewport());
    const auto offer = [&](std::size_t corner, bool isWanted) {
        const auto at = m_view.screenOf(m_line[corner]);
        const auto isNear = [&](QPointF other) { return QLineF(*at, other).length() < kHandlesApart; };
        if (at && (isWanted || (sight.contains(*at) && std::ranges::none_of(taken, isNear)))) {
            shown.push_back(corner);
            taken.push_back(*at);
        }
    };
    const auto isWanted = [&](std::size_t corner) {
        return corner == 0 || corner + 1 == m_line.size() || corner == m_held;
    };
    for (const bool first : {true, false}) {
        for (std::size_t corner = 0; corner < m_line.size(); ++corner) {
            if (isWanted(corner) == first) {
                offer(corner, first);
            }
        }
    }
    return shown;
}

/// What has no handle cannot be taken by mistake.
std::optional<std::size_t> SectionLine::cornerAt(QPointF position) const {
    for (const std::size_t i : handles()) {
        const auto at = m_view.screenOf(m_line[i]);
        if (at && QLineF(*at, position).length() <= kGripPixels) {
            return i;
        }
    }
    return std::nullopt;
}

void SectionLine::paint(QPainter& painter) const {
    QPolygonF corners;
    for (const base::PointD& corner : m_line) {
        if (const auto at = m_view.screenOf(corner)) {
            corners += *at;
        }
    }
    if (corners.size() < 2 || !isThere()) {
        return;
    }
    // Rulers and what else covers the rim of the view lie above.
    painter.setClipRect(QRectF({}, m_view.controller().viewport()).marginsRemoved(m_view.controller().margins()));
    painter.setPen(QPen(kSectionRim, 4.0));
    painter.drawPolyline(corners);
    painter.setPen(QPen(kSectionInk, 2.0));
    painter.drawPolyline(corners);
    painter.setBrush(kSectionInk);
    painter.setPen(QPen(kSectionRim, 1.0));
    for (const std::size_t corner : handles()) {
        painter.drawEllipse(*m_view.screenOf(m_line[corner]), kCornerPixels, kCornerPixels);
    }
}

}  // namespace ui
