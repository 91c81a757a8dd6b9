#pragma once

#include <cstdint>
#include <span>
#include <string_view>

#include "model/board/document_builder.h"

namespace model::formats {

/// Fills the builder's current layer, which is drawn as what is not copper (Layer::isNegative): the outline of the
/// layer or the board, without copies of other steps, minus what `painted` leaves visible (painting.h). Its pieces have
/// the nets of the plated holes and pads in them. What was found is reported with `file` and `line`; without an outline
/// the layer stays empty. To be called when the profile and all holes are there.
void addNegativeLayer(DocumentBuilder& builder, LayerId layer, const Document& painted,
                      std::span<const std::uint8_t> negatives, std::string_view file, std::uint32_t line);

}  // namespace model::formats
