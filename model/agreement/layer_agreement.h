#pragma once

#include "model/agreement/agreement.h"

namespace model {

/// Copper by its order from the top, where both have as many, else by name; solder mask, paste and silkscreen by side,
/// and there by name, then by order. Only layers on which one of the boards draws anything.
[[nodiscard]] std::vector<LayerPair> pairLayers(const Document& a, const Document& b);

/// A comparison for each pair of layers, and for the outline. Errors: Cancelled.
[[nodiscard]] base::Result<std::vector<Comparison>> compareLayers(const Document& a, const Document& b, Point shift,
                                                                  const AgreementRequest& request,
                                                                  base::Progress& progress);

/// What within `box` only the first and only the second board draws on a layer (of Aspect::Outline: has within its
/// outline), in the coordinates of the first. Curves are chords that lie within 1 µm of them.
[[nodiscard]] std::array<PolygonSet, 2> onlyDrawn(const Document& a, const Document& b, Point shift,
                                                  const LayerPair& pair, const Box& box);

}  // namespace model
