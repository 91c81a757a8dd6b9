#include "ui/messages/message_location.h"

namespace ui {

std::optional<render::Box3> locationOf(const model::Diagnostic& message, const model::Document& document,
                                       const render::BoardFrame& frame) {
    model::Box box;
    float bottom = frame.boxMin.z;
    float top = frame.boxMax.z;
    if (message.element.isValid()) {
        const std::size_t layer = document.elements.layer[message.element.row()].row();
        box = document.boxOf(message.element);
        bottom = frame.layers[layer].z0;
        top = frame.layers[layer].z1;
    } else if (message.location) {
        box.include(*message.location);
    } else {
        return std::nullopt;
    }
    const glm::vec2 low = render::toGpu(base::toDouble(box.min), frame.origin);
    const glm::vec2 high = render::toGpu(base::toDouble(box.max), frame.origin);
    return render::Box3{{low, bottom}, {high, top}};
}

}  // namespace ui
