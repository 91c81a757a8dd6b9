#include "ui/search/location_mark.h"

#include <QPainter>

namespace ui {

namespace {

constexpr double kInnerPixels = 4.0;  // the location itself stays free to be seen
constexpr double kRingPixels = 9.0;
constexpr double kOuterPixels = 16.0;
constexpr QColor kInk(255, 221, 87);
constexpr QColor kRim(20, 20, 24, 220);

void strokeCross(QPainter& painter, QPointF at) {
    painter.drawEllipse(at, kRingPixels, kRingPixels);
    for (const QPointF way : {QPointF(1, 0), QPointF(-1, 0), QPointF(0, 1), QPointF(0, -1)}) {
        painter.drawLine(at + way * kInnerPixels, at + way * kOuterPixels);
    }
}

}  // namespace

LocationMark::LocationMark(BoardViews& views, Workspace& workspace, QObject* parent)
    : QObject(parent), m_views(views), m_workspace(workspace) {
    connect(&workspace, &Workspace::boardRead, this, &LocationMark::clear);
    for (BoardView* view : views.both()) {
        view->addPainter([this, view](QPainter& painter) { paint(painter, *view); });
        connect(&view->controller(), &CameraController::clicked, this, &LocationMark::clear);
    }
}

void LocationMark::set(base::PointD nm) {
    m_location = nm;
    m_views.requestOverlay();
}

bool LocationMark::clear() {
    const bool wasSet = m_location.has_value();
    m_location.reset();
    if (wasSet) {
        m_views.requestOverlay();
    }
    return wasSet;
}

void LocationMark::paint(QPainter& painter, const BoardView& view) const {
    if (!m_location || !view.hasScene()) {
        return;
    }
    glm::vec3 point = view.position().toModel(*m_location);
    point.z = view.seenFace(*m_workspace.board()->document);
    const std::optional<QPointF> at = view.controller().screenOf(point);
    if (!at) {
        return;
    }
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setBrush(Qt::NoBrush);
    for (const auto& [colour, width] : {std::pair(kRim, 4.5), std::pair(kInk, 1.8)}) {
        painter.setPen(QPen(colour, width, Qt::SolidLine, Qt::FlatCap));
        strokeCross(painter, *at);
    }
}

}  // namespace ui
