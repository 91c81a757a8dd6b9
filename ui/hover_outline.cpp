#include "ui/hover_outline.h"

#include <QPainter>

#include "model/geometry/boolean.h"

namespace ui {

namespace {

constexpr QColor kInk(255, 255, 255);
constexpr QColor kShadow(0, 0, 0, 140);
constexpr double kWidth = 1.6;
/// Strokes of more points than this are outlined one by one: uniting them would take too long.
constexpr std::size_t kMostToUnite = 4000;

model::PolygonSet outlineOf(const model::Document& step, model::ElementId element) {
    model::PolygonSet parts = model::discretise(step, element, {});
    return parts.polygons.size() > 1 && parts.points.size() <= kMostToUnite ? model::unite(parts) : parts;
}

}  // namespace

HoverOutline::HoverOutline(BoardViews& views, models::SelectionModel& selection, QObject* parent)
    : QObject(parent), m_views(views), m_selection(selection) {
    connect(&selection, &models::SelectionModel::hoverChanged, this, &HoverOutline::update);
    for (BoardView* view : views.both()) {
        view->addPainter([this, view](QPainter& painter) { paint(painter, *view); }, BoardView::Shown::OnCanvas);
    }
}

void HoverOutline::update() {
    m_outline = {};
    if (const auto at = m_selection.hovered()) {
        const model::Document& step = m_selection.stepOf(*at);
        const model::StepCopy& copy = m_selection.tree().copies[at->copy];
        m_outline = model::placed(outlineOf(step, at->element), copy.placement);
        m_layer = step.layerOfCopy(step.elements.layer[at->element.row()], copy.isFlipped);
    }
    m_views.requestOverlay();
}

void HoverOutline::paint(QPainter& painter, const BoardView& view) const {
    if (m_outline.points.empty()) {
        return;
    }
    const std::vector<render::ZRange> heights = view.drawnHeights();
    if (m_layer.row() >= heights.size()) {
        return;
    }
    const bool isFromBelow = view.controller().camera().direction().z > 0.0F;
    const float z = isFromBelow ? heights[m_layer.row()].z0 : heights[m_layer.row()].z1;
    for (std::size_t loop = 0; loop < m_outline.loopCount(); ++loop) {
        QPolygonF line;
        for (const base::Point& point : m_outline.loop(loop)) {
            glm::vec3 at = m_place.toModel(base::toDouble(point));
            at.z = z;
            const auto onScreen = view.controller().screenOf(at);
            // Points that fall on one pixel are one.
            if (onScreen && (line.isEmpty() || (*onScreen - line.back()).manhattanLength() >= 1.0)) {
                line += *onScreen;
            }
        }
        for (const auto& [colour, width] : {std::pair(kShadow, 2.0 * kWidth), std::pair(kInk, kWidth)}) {
            painter.setPen(QPen(colour, width));
            painter.drawPolygon(line);
        }
    }
}

}  // namespace ui
