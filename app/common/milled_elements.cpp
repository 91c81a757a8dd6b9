#include "app/common/milled_elements.h"

#include <algorithm>
#include <iterator>

#include "model/solids/milling.h"

namespace app {

MilledElements milledElementsOf(const model::Document& board) {
    const model::MilledBoard milled = model::findMilled(board, {}, {});
    MilledElements found{{}, milled.isOutlineDoubtful};
    std::ranges::transform(milled.elements, std::back_inserter(found.elements), &model::MilledElement::element);
    return found;
}

}  // namespace app
