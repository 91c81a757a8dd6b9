#include "ui/section/section_plane_tool.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace ui {

namespace {

const base::Box& boxOf(const model::Document& document) {
    return document.board.isEmpty() ? document.extent : document.board;
}

}  // namespace

void SectionPlaneTool::setBoard(const LoadedBoard& board, bool isReadAnew) {
    m_index = board.index;
    m_origin = board.model->origin;
    m_milled = render::milledOfSteps(*board.model);
    m_pointer.reset();
    m_isOn = m_isOn && isReadAnew && m_index != nullptr;
    apply();
}

void SectionPlaneTool::setHeights(std::shared_ptr<const model::BoardIndex> index) {
    m_index = std::move(index);
    apply();
}

void SectionPlaneTool::setAsDesigned(bool isOn) {
    m_isAsDesigned = isOn;
    apply();
}

void SectionPlaneTool::setOn(bool isOn) {
    m_isOn = isOn && m_index != nullptr;
    const bool isPointed = m_isOn && m_pointer && isOver(board(), *m_pointer);
    m_through = isPointed ? *m_pointer : seenMiddle();
    m_angle = 0.0;
    m_eighths = 0;
    m_isAlongLine = false;
    apply();
}

/// Beside the board a plane would cut nothing, or all of it away.
bool SectionPlaneTool::isOver(const model::Document& board, base::PointD location) {
    const base::Box& box = boxOf(board);
    return location.x > box.min.x && location.x < box.max.x && location.y > box.min.y && location.y < box.max.y;
}

base::PointD SectionPlaneTool::seenMiddle() const {
    const CameraController& camera = m_views.solid().controller();
    const QRectF canvas({}, camera.viewport());
    const std::optional<QPointF> middle = camera.screenOf({});
    const std::optional<glm::vec3> seen = camera.boardPointAt(canvas.center());
    const bool isInSight = middle && canvas.contains(*middle);
    return isInSight || !seen ? base::toDouble(m_origin) : m_views.solid().position().toJob(*seen);
}

void SectionPlaneTool::cutAlong(base::PointD from, base::PointD to) {
    m_isOn = m_index != nullptr;
    m_through = from;
    m_angle = std::atan2(to.y - from.y, to.x - from.x);
    m_eighths = 0;
    m_isAlongLine = true;
    apply();
}

base::PointD SectionPlaneTool::direction() const {
    // Against x at first: what lies to the left of that, nearer to the eye of an isometric view, goes.
    const double angle = m_angle + m_eighths * std::numbers::pi / 4.0;
    return {-std::cos(angle), -std::sin(angle)};
}

void SectionPlaneTool::rotate() {
    m_isAlongLine = false;
    m_eighths = (m_eighths + 1) % 8;
    apply();
}

void SectionPlaneTool::move(double part) {
    const base::Box& box = boxOf(board());
    const double distance = part * static_cast<double>(std::max(box.width(), box.height()));
    const base::PointD forward = this->forward();
    put({m_through.x + forward.x * distance, m_through.y + forward.y * distance});
}

void SectionPlaneTool::put(base::PointD through) {
    const base::PointD forward = this->forward();
    const auto along = [&](base::PointD p) { return p.x * forward.x + p.y * forward.y; };
    double least = along(m_through);  // a plane beside the board may stay there
    double most = least;
    const base::Box& box = boxOf(board());
    for (const base::Nm x : {box.min.x, box.max.x}) {
        for (const base::Nm y : {box.min.y, box.max.y}) {
            least = std::min(least, along(base::toDouble(base::Point{x, y})));
            most = std::max(most, along(base::toDouble(base::Point{x, y})));
        }
    }
    const double wanted = along(through);
    const double back = std::clamp(wanted, least, most) - wanted;
    m_through = {through.x + back * forward.x, through.y + back * forward.y};
    apply();
}

base::PointD SectionPlaneTool::middle() const {
    const base::Box& box = boxOf(board());
    return nearestTo({(double{1} * box.min.x + box.max.x) / 2, (double{1} * box.min.y + box.max.y) / 2});
}

base::PointD SectionPlaneTool::nearestTo(base::PointD location) const {
    const base::PointD direction = this->direction();
    const double along = (location.x - m_through.x) * direction.x + (location.y - m_through.y) * direction.y;
    return {m_through.x + along * direction.x, m_through.y + along * direction.y};
}

/// To the right of its direction.
base::PointD SectionPlaneTool::forward() const {
    const base::PointD direction = this->direction();
    return {direction.y, -direction.x};
}

void SectionPlaneTool::apply() {
    std::shared_ptr<const render::SectionCut> cut;
    if (m_isOn) {
        const base::PointD direction = this->direction();
        const base::PointD ahead = {m_through.x + direction.x * base::kNmPerMm,
                                    m_through.y + direction.y * base::kNmPerMm};
        if (base::Result<render::SectionCut> made =
                render::makeSectionCut(*m_index, m_origin, m_through, ahead,
                                       m_isAsDesigned ? std::vector<std::vector<model::ElementId>>() : m_milled)) {
            cut = std::make_shared<const render::SectionCut>(std::move(*made));
        }
    }
    m_views.setCut(std::move(cut));
}

}  // namespace ui
