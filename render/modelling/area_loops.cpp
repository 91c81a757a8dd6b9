#include "render/modelling/area_loops.h"

#include "render/modelling/board_model.h"

namespace render {
namespace {

glm::vec2 placed(const shader::AreaInstance& instance, glm::vec2 p) {
    const glm::vec2 cs = instance.cosSin;
    const glm::vec2 rotated{cs.x * p.x + cs.y * p.y, -cs.y * p.x + cs.x * p.y};
    return instance.origin + glm::vec2(instance.isMirrored != 0 ? -rotated.x : rotated.x, rotated.y);
}

}  // namespace

void forLoops(const BoardModel& model, const shader::AreaInstance& instance,
              const std::function<void(const Loop&)>& visit) {
    const AreaShape& shape = model.shapes[instance.shape];
    std::vector<std::uint8_t> isDone(shape.vertexCount, 0);
    Loop loop;
    for (std::uint32_t i = 0; i < shape.vertexCount; ++i) {
        loop.clear();
        for (std::uint32_t v = i; isDone[v] == 0 && model.next[shape.firstVertex + v] != shape.firstVertex + v;
             v = model.next[shape.firstVertex + v] - shape.firstVertex) {
            isDone[v] = 1;
            loop.push_back(placed(instance, model.vertices[shape.firstVertex + v]));
        }
        if (!loop.empty()) {
            visit(loop);
        }
    }
}

}  // namespace render
