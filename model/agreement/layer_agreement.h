#pragma once

#include "model/agreement/agreement.h"

namespace model {

/// Layers of two boards that are the same layer; one of them is none where only one board has it.
struct LayerPair {
    Aspect aspect = Aspect::Copper;
    LayerId a;
    LayerId b;
};

/// Copper by its order from the top, where both have as many, else by name; solder mask, paste and silkscreen by side,
/// and there by name, then by order. Only layers on which one of the boards draws anything.
[[nodiscard]] std::vector<LayerPair> pairLayers(const Document& a, const Document& b);

/// A comparison for each pair of layers, and for the outline. Errors: Cancelled.
[[nodiscard]] base::Result<std::vector<Comparison>> compareLayers(const Document& a, const Document& b, Point shift,
                                                                  const AgreementRequest& request,
                                                                  base::Progress& progress);

}  // namespace model
