#include "ui/views/milled_away.h"

#include <algorithm>

#include "model/board/copies.h"
#include "model/geometry/vectors.h"
#include "model/solids/milling.h"

namespace ui {

MilledAway::MilledAway(const LoadedBoard& board) {
    if (!board.model) {
        return;
    }
    const model::Document& document = *board.document;
    if (!board.model->milled.empty()) {
        const model::PolygonSet outline = model::discretise(document.shapes, document.profile, {});
        m_copies.emplace(0, Copy{board.model->milled, model::EdgeStrips(outline)});
    }
    const model::StepTree tree = model::unfoldCopies(document);
    const std::vector<model::PolygonSet> cutouts = model::cutoutsOfCopies(tree, {});
    for (std::uint32_t row = 1; row < tree.copies.size(); ++row) {
        const render::BoardModel& step = board.model->steps[tree.copies[row].step - 1];
        if (!step.milled.empty()) {
            m_copies.emplace(row, Copy{step.milled, model::EdgeStrips(cutouts[row])});
        }
    }
}

bool MilledAway::has(const model::BoardElement& at, base::PointD location) const {
    const auto found = m_copies.find(at.copy);
    if (found == m_copies.end() || !std::ranges::binary_search(found->second.elements, at.element)) {
        return false;
    }
    const bool isInside = found->second.outline.contains({model::toNm(location.x), model::toNm(location.y)});
    return isInside == (at.copy != 0);
}

}  // namespace ui
