#include "ui/section/section_plane_tool.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace ui {

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
    m_through = isOverBoard() ? *m_pointer : base::toDouble(m_origin);
    m_angle = 0.0;
    m_eighths = 0;
    m_isAlongLine = false;
    apply();
}

/// Beside the board a plane would cut nothing, or all of it away.
bool SectionPlaneTool::isOverBoard() const {
    if (!m_pointer || m_index == nullptr) {
        return false;
    }
    const model::Document& document = *m_index->board;
    const base::Box& board = document.board.isEmpty() ? document.extent : document.board;
    return m_pointer->x > board.min.x && m_pointer->x < board.max.x && m_pointer->y > board.min.y &&
           m_pointer->y < board.max.y;
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
    if (!m_isOn) {
        return;
    }
    const base::Box& board = m_index->board->board;
    const double distance = part * static_cast<double>(std::max(board.width(), board.height()));
    const base::PointD direction = this->direction();
    m_through = {m_through.x + direction.y * distance, m_through.y - direction.x * distance};  // to its right
    apply();
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
