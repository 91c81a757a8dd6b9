#pragma once

#include <glm/glm.hpp>
#include <vector>

#include "model/board/copies.h"

namespace render {

/// Where a document lies in the renderer's coordinates, which are millimetres relative to `origin`. The same for both
/// pipelines.
struct BoardFrame {
    model::Point origin;               ///< nm, the centre of the board
    std::vector<float> layerBottomMm;  ///< z0 and z1 per layer, before explosion
    std::vector<float> layerTopMm;
    std::vector<std::uint32_t>
        layerGrowth;             ///< kLayerGrowsUp or kLayerGrowsDown where heights differ on a layer, else 0
    std::vector<bool> isCopper;  ///< by layer
    float facesMm = 0.0F;        ///< z of the board's lower plus z of its upper face: flipped, z is this minus z
    glm::vec3 boxMin{0.0F};      ///< of the board, mm
    glm::vec3 boxMax{0.0F};
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

/// Where copies lie, from nanometres in documents to millimetres in models; rows as in the tree.
[[nodiscard]] std::vector<ModelCopy> placeCopies(const model::StepTree& tree);

[[nodiscard]] BoardFrame frameOf(const model::Document& document);

/// The middle of a box; 0,0 of an empty one.
[[nodiscard]] model::Point centreOf(const model::Box& box);

/// Position in mm from `origin`.
[[nodiscard]] inline glm::vec2 toGpu(model::PointD point, model::Point origin) {
    return {static_cast<float>((point.x - origin.x) / base::kNmPerMm),
            static_cast<float>((point.y - origin.y) / base::kNmPerMm)};
}

}  // namespace render
