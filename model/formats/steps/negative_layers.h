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
    std::unique_ptr<DocumentBuilder> painted;  ///< none: the step does not draw on it
    std::vector<std::uint8_t> negatives;       ///< an entry per element of `painted` (painting.h)
    std::string file;                          ///< for messages on the layer
    std::uint32_t line = 0;
};

/// Is the step one that the user looks at, or one that others hold copies of?
enum class StepRole : std::uint8_t { Shown, Copied };

/// Fills the layers, in this order: each is the outline of the layer or the board, without copies of other steps, minus
/// what is painted, and minus what such copies clear around them (Layer::clearedAround, set here for copied steps). Its
/// pieces have the nets of the plated holes and pads in them. What was found is reported; without an outline a layer
/// stays empty. So does one that the step does not draw on, which hands on what its copies clear. To be called when the
/// profile and all holes are there. False: cancelled.
[[nodiscard]] bool addNegativeLayers(DocumentBuilder& builder, std::span<const NegativeLayer> layers, StepRole role,
                                     StepProgress& progress);

}  // namespace model::formats
