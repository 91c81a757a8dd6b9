#include "ui/views/element_outlines.h"

#include <QPainter>
#include <algorithm>
#include <iterator>

#include "model/figures/element_polygons.h"
#include "model/geometry/boolean.h"

namespace ui {

namespace {

constexpr QColor kHoverInk(255, 255, 255);
constexpr QColor kSelectedInk(255, 221, 87);
constexpr QColor kShadow(0, 0, 0, 140);
constexpr double kWidth = 1.6;
constexpr double kLeastOpening = 12.0;  ///< the rims of smaller ones, in pixels, would cover a plane full of vias
/// Track chains of more points than this are outlined one by one: uniting them would take too long.
constexpr std::size_t kMostToUnite = 4000;

model::PolygonSet loopsOf(const model::Document& step, model::ElementId element) {
    model::PolygonSet parts = model::discretise(step, element, {});
    return parts.polygons.size() > 1 && parts.points.size() <= kMostToUnite ? model::unite(parts) : parts;
}

}  // namespace

ElementOutlines::ElementOutlines(BoardViews& views, Workspace& workspace, QObject* parent)
    : QObject(parent), m_views(views), m_selection(workspace.selection()) {
    connect(&m_selection, &SelectionModel::hoverChanged, this, &ElementOutlines::updateHovered);
    connect(&m_selection, &SelectionModel::highlightChanged, this, &ElementOutlines::updateSelected);
    for (BoardView* view : views.both()) {
        view->addPainter([this, view](QPainter& painter) { paint(painter, *view); }, BoardView::Shown::OnCanvas);
    }
}

ElementOutlines::Outline ElementOutlines::outlineOf(const model::BoardElement& at) const {
    const model::Document& step = m_selection.stepOf(at);
    const model::StepCopy& copy = m_selection.tree().copies[at.copy];
    return {model::placed(loopsOf(step, at.element), copy.placement),
            step.layerOfCopy(step.elements.layer[at.element.row()], copy.isFlipped)};
}

void ElementOutlines::updateHovered() {
    const auto at = m_selection.hovered();
    m_hovered = at ? outlineOf(*at) : Outline();
    m_views.requestOverlay();
}

void ElementOutlines::updateSelected() {
    m_selected.clear();
    for (const auto* elements : {&m_selection.nearby(), &m_selection.selected()}) {
        if (elements->size() <= kMostOutlined) {
            std::ranges::transform(*elements, std::back_inserter(m_selected),
                                   [this](const model::BoardElement& at) { return outlineOf(at); });
        }
    }
    m_views.requestOverlay();
}

void ElementOutlines::paint(QPainter& painter, const BoardView& view) const {
    for (const Outline& outline : m_selected) {
        paintOutline(painter, view, outline, kSelectedInk);
    }
    paintOutline(painter, view, m_hovered, kHoverInk);
}

void ElementOutlines::paintOutline(QPainter& painter, const BoardView& view, const Outline& outline,
                                   const QColor& ink) const {
    if (outline.loops.points.empty()) {
        return;
    }
    const std::vector<render::ZRange> heights = view.drawnHeights();
    if (outline.layer.row() >= heights.size()) {
        return;
    }
    const bool isFromBelow = view.controller().camera().direction().z > 0.0F;
    const render::ZRange& height = heights[outline.layer.row()];
    const float z = isFromBelow ? height.z0 : height.z1;
    for (const model::PolygonSet::Polygon& polygon : outline.loops.polygons) {
        for (std::uint32_t loop = 0; loop < polygon.loopCount; ++loop) {
            const QPolygonF line = onScreen(view, outline.loops.loop(polygon.firstLoop + loop), z);
            const QSizeF size = line.boundingRect().size();
            if (loop > 0 && std::max(size.width(), size.height()) < kLeastOpening) {
                continue;
            }
            for (const auto& [colour, width] : {std::pair(kShadow, 2.0 * kWidth), std::pair(ink, kWidth)}) {
                painter.setPen(QPen(colour, width));
                painter.drawPolygon(line);
            }
        }
    }
}

QPolygonF ElementOutlines::onScreen(const BoardView& view, std::span<const base::Point> loop, float z) const {
    QPolygonF line;
    for (const base::Point& point : loop) {
        glm::vec3 at = view.position().toModel(base::toDouble(point));
        at.z = z;
        const auto pixel = view.controller().screenOf(at);
        // Points that fall on one pixel are one.
        if (pixel && (line.isEmpty() || (*pixel - line.back()).manhattanLength() >= 1.0)) {
            line += *pixel;
        }
    }
    return line;
}

}  // namespace ui
