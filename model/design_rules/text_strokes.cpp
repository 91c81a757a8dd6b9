#include "model/design_rules/text_strokes.h"

#include <algorithm>

namespace model {

std::vector<bool> textStrokesOf(const Document& document) {
    std::vector<bool> isText(document.elements.size());
    for (std::size_t row = 0; row < isText.size(); ++row) {
        const AttributeValues& values = document.attributesOf(ElementId{row});
        isText[row] = std::ranges::any_of(
            values, [](const auto& value) { return value.first == ".string" || value.first == "string"; });
    }
    for (const ElementGroup& group : document.groups) {
        for (std::uint32_t i = 0; document.text(group.type) == "TEXT" && i < group.elements.count; ++i) {
            isText[document.groupElements[group.elements.first + i].row()] = true;
        }
    }
    return isText;
}

}  // namespace model
