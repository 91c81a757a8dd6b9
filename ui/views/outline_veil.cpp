#include "ui/views/outline_veil.h"

#include <QPainter>

#include "model/board/copies.h"
#include "model/geometry/discretise.h"
#include "model/solids/milling.h"

namespace ui {

namespace {

constexpr int kStrength = 175;  // of 255
constexpr QColor kEdge(168, 172, 184, 190);

QPainterPath pathOf(const model::PolygonSet& region, const BoardPosition& position) {
    QPainterPath path;
    for (std::size_t row = 0; row < region.loopCount(); ++row) {
        QPolygonF loop;
        for (const model::Point point : region.loop(row)) {
            const glm::vec3 mm = position.toModel(base::toDouble(point));
            loop << QPointF(static_cast<double>(mm.x), static_cast<double>(mm.y));
        }
        path.addPolygon(loop);
        path.closeSubpath();
    }
    return path;
}

QColor backgroundOf(const glm::vec3& colour) {
    return QColor::fromRgbF(colour.r, colour.g, colour.b, static_cast<float>(kStrength) / 255.0F);
}

}  // namespace

OutlineVeil::OutlineVeil(BoardView& view, Workspace& workspace, QObject* parent) : QObject(parent), m_view(view) {
    connect(&workspace, &Workspace::boardShown, this, &OutlineVeil::setBoard);
    view.addGroundPainter([this](QPainter& painter) { paint(painter); });
}

void OutlineVeil::setOn(bool isOn) {
    m_isOn = isOn;
    m_view.requestOverlay();
}

void OutlineVeil::setBoard(const LoadedBoard& board) {
    m_outline.clear();
    const model::Document& document = *board.document;
    m_isAnythingMilled = board.model && !board.model->milled.empty();
    if (document.profile.isValid()) {
        m_outline = pathOf(model::discretise(document.shapes, document.profile, {}), m_view.position());
    }
    m_cutouts.clear();
    for (const model::PolygonSet& cutouts : model::cutoutsOfCopies(model::unfoldCopies(document), {})) {
        m_cutouts.addPath(pathOf(cutouts, m_view.position()));
    }
}

std::optional<QTransform> OutlineVeil::toCanvas() const {
    const CameraController& controller = m_view.controller();
    const auto origin = controller.screenOf({0.0F, 0.0F, 0.0F});
    const auto right = controller.screenOf({1.0F, 0.0F, 0.0F});
    const auto up = controller.screenOf({0.0F, 1.0F, 0.0F});
    if (!origin || !right || !up) {
        return std::nullopt;
    }
    const QPointF x = *right - *origin;
    const QPointF y = *up - *origin;
    return QTransform(x.x(), x.y(), y.x(), y.y(), origin->x(), origin->y());
}

void OutlineVeil::fadeBeyond(QPainter& painter, const QPainterPath& outline, const QPainterPath& cutouts) const {
    QPainterPath beyond;  // odd-even: all of the canvas but the board
    if (m_isAnythingMilled) {
        beyond.addRect(QRectF({0.0, 0.0}, m_view.controller().viewport()));
        beyond.addPath(outline);
    }
    beyond.addPath(cutouts);
    painter.fillPath(beyond, backgroundOf(m_view.background()));
}

void OutlineVeil::paint(QPainter& painter) const {
    const std::optional<QTransform> transform = m_outline.isEmpty() || !m_view.hasScene() ? std::nullopt : toCanvas();
    if (!transform) {
        return;
    }
    const QPainterPath outline = transform->map(m_outline);
    const QPainterPath cutouts = transform->map(m_cutouts);
    if (m_isOn) {
        fadeBeyond(painter, outline, cutouts);
    }
    painter.setRenderHint(QPainter::Antialiasing);
    painter.strokePath(outline, QPen(kEdge, 1.0));
    painter.strokePath(cutouts, QPen(kEdge, 1.0));
}

}  // namespace ui
