#include "model/formats/steps/elements_of_feature.h"

#include <algorithm>

namespace model::formats {

std::vector<ElementId> elementsOf(const Document& document, LayerId layer, std::size_t feature) {
    const Range range = document.layer(layer).elements;
    const auto features = std::span(document.elements.firstFeature).subspan(range.first, range.count);
    std::vector<ElementId> elements;
    const auto next = std::ranges::upper_bound(features, feature);
    for (auto row = next; row != features.begin() && (--row == next - 1 || *row == feature);) {
        const ElementId id{range.first + static_cast<std::size_t>(row - features.begin())};
        const bool isTrail = document.elements.kind[id.row()] == ElementKind::Trail;
        const std::size_t tracks = isTrail ? document.trails[document.elements.geometry[id.row()]].nodeCount - 1 : 1;
        if (feature >= *row + tracks) {
            break;
        }
        elements.insert(elements.begin(), id);
    }
    return elements;
}

}  // namespace model::formats
