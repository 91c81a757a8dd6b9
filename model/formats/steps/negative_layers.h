#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "model/board/document_builder.h"
#include "model/formats/steps/step_progress.h"

namespace model::formats {

/// What the features of a layer draw that is drawn as what is not copper (Layer::isNegative).
struct NegativeLayer {
    LayerId layer;
    std::unique_ptr<DocumentBuilder> painted;
    std::vector<std::uint8_t> negatives;  ///< an entry per element of `painted` (painting.h)
    std::string file;                     ///< for messages on the layer
    std::uint32_t line = 0;
};

/// Fills the layers, in this order: each is the outline of the layer or the board, without copies of other steps, minus
/// what is painted. Its pieces have the nets of the plated holes and pads in them. What was found is reported; without
/// an outline a layer stays empty. To be called when the profile and all holes are there. False: cancelled.
[[nodiscard]] bool addNegativeLayers(DocumentBuilder& builder, std::span<const NegativeLayer> layers,
                                     StepProgress& progress);

}  // namespace model::formats
