#pragma once

#include <algorithm>
#include <glm/glm.hpp>
#include <utility>
#include <vector>

#include "model/base/result.h"
#include "model/board/copies.h"

namespace render {

/// A box in the plane, mm; empty until something is in it.
struct Box2 {
    glm::vec2 min{1e30F};
    glm::vec2 max{-1e30F};

    void include(glm::vec2 point) { include(Box2{point, point}); }
    void include(const Box2& box) {
        min = glm::min(min, box.min);
        max = glm::max(max, box.max);
    }
};

struct FrameLayer {
    float z0 = 0.0F;  ///< lower face before explosion, mm
    float z1 = 0.0F;  ///< upper face
    bool hasAreas = false;
    bool isCopper = false;
    std::uint32_t growth = 0;   ///< kLayerGrowsUp or kLayerGrowsDown where heights differ on the layer, else 0
    model::LayerId opposite{};  ///< where the layer of a flipped copy lies; none: at its own mirror image
};

/// A step drawn somewhere on the board (model::StepCopy in the GPU's terms): p' = origin + turn * p, in the plane only.
/// A flipped copy lies on the opposite layers.
struct ModelCopy {
    std::uint32_t step = 0;    ///< 0 = the board itself, else 1 + row of its model's steps
    glm::dvec2 origin{0.0};    ///< mm, in the board's model coordinates
    glm::dmat2 rotation{1.0};  ///< rotation and mirror
    bool isMirrored = false;
    bool isFlipped = false;
};

/// Where a document lies in the renderer's coordinates, which are millimetres relative to `origin`. The same for both
/// pipelines.
struct BoardFrame {
    model::Point origin;  ///< nm, the centre of the board
    std::vector<FrameLayer> layers;
    std::vector<ModelCopy> copies = std::vector<ModelCopy>(1);  ///< rows as in model::StepTree: the board itself first
    glm::vec2 facesMm{0.0F};  ///< z of the board's lower and upper face: flipped, z is their sum minus z
    glm::vec3 boxMin{0.0F};   ///< of the board, mm
    glm::vec3 boxMax{0.0F};
};

/// Parts of the paper's modelling (Table 4).
struct ModelTimes {
    double createMs = 0.0;
    double discretiseMs = 0.0;
    double triangulateMs = 0.0;

    ModelTimes& operator+=(const ModelTimes& other);
};

/// Where copies lie, from nanometres in documents to millimetres in models; rows as in the tree.
[[nodiscard]] std::vector<ModelCopy> placeCopies(const model::StepTree& tree);

/// Of the document by itself: with no copies of steps.
[[nodiscard]] BoardFrame frameOf(const model::Document& document);

/// The model of a board with a model of every step that it places: `build(document)` makes one by itself or fails.
template <class Model, class Build>
base::Result<Model> buildWithSteps(const model::Document& document, const Build& build) {
    base::Result<Model> board = build(document);
    if (!board || document.instances.empty()) {
        return board;
    }
    const model::StepTree tree = model::unfoldCopies(document);
    for (std::size_t row = 1; row < tree.steps.size(); ++row) {
        base::Result<Model> step = build(*tree.steps[row]);
        if (!step) {
            return step;
        }
        for (std::size_t i = 0; i < std::min(board->layers.size(), step->layers.size()); ++i) {
            board->layers[i].hasAreas = board->layers[i].hasAreas || step->layers[i].hasAreas;
        }
        board->times += step->times;
        board->steps.push_back(std::move(*step));
    }
    board->copies = placeCopies(tree);
    return board;
}

/// The middle of a box; 0,0 of an empty one.
[[nodiscard]] model::Point centreOf(const model::Box& box);

/// Position in mm from `origin`.
[[nodiscard]] inline glm::vec2 toGpu(model::PointD point, model::Point origin) {
    return {static_cast<float>((point.x - origin.x) / base::kNmPerMm),
            static_cast<float>((point.y - origin.y) / base::kNmPerMm)};
}

}  // namespace render
