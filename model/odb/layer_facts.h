#pragma once

#include <string_view>

#include "model/document.h"
#include "model/odb/attributes.h"
#include "model/odb/matrix.h"

namespace model::odb {

/// What the attributes of a layer say about its build (odb-notes, Stack). On copper .layer_dielectric and
/// .dielectric_constant are about the dielectric under it; .copper_weight is ounces per square foot in inch files and
/// µm in mm files. Zero is "not set"; numbers that no material has are reported and left out.
[[nodiscard]] LayerFacts factsOf(const AttributeList& attributes, const MatrixLayer& layer, std::string_view path,
                                 Diagnostics& diagnostics);

/// What the matrix says about the material of a layer.
void addMatrixFacts(const MatrixLayer& layer, Material& material);

}  // namespace model::odb
