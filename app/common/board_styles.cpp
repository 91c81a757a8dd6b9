#include "app/common/board_styles.h"

namespace app {

void showComponents(const model::Document& document, std::vector<render::LayerStyle>& styles) {
    for (std::size_t row = 0; row < styles.size(); ++row) {
        styles[row].isVisible |= document.layers[row].type == model::LayerType::ComponentBody;
    }
}

}  // namespace app
