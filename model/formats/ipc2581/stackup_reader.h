#pragma once

#include <string_view>
#include <vector>

#include "model/formats/ipc2581/layer_list.h"

namespace model::ipc2581 {

/// A Stackup: the layers of a part of the board, from the top.
struct Stack {
    std::string_view name;
    std::vector<std::size_t> layers;  ///< rows of the LayerList
};

/// What all Stackups of the file say together.
struct Stackups {
    std::vector<Stack> stacks;
    std::vector<std::size_t> order;  ///< all their layers from the top, each once
    std::optional<double> boardNm;   ///< thickness of the one with most copper, without its masks
};

/// Reads thicknesses and materials into the layers' facts. Rows are sorted by their sequence, which counts through all
/// groups. Of several stackups (rigid-flex) the one with most copper gives the order, and the layers of others are put
/// beside the neighbours they share with it; what these have outside of their copper is coverlay, adhesive and
/// stiffener.
[[nodiscard]] Stackups readStackups(Reading& reading, const Specs& specs, LayerList& layers);

}  // namespace model::ipc2581
