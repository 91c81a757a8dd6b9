#include "ui/views/milled_away.h"

#include <algorithm>

#include "model/geometry/vectors.h"

namespace ui {

MilledAway::MilledAway(const LoadedBoard& board) {
    if (board.model && !board.model->milled.empty()) {
        const model::Document& document = *board.document;
        m_elements = board.model->milled;
        m_outline.emplace(model::discretise(document.shapes, document.profile, {}));
    }
}

bool MilledAway::has(const model::BoardElement& at, base::PointD location) const {
    return m_outline && at.copy == 0 && std::ranges::binary_search(m_elements, at.element) &&
           !m_outline->contains({model::toNm(location.x), model::toNm(location.y)});
}

}  // namespace ui
