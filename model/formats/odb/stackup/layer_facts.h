#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "model/board/document.h"
#include "model/formats/odb/stackup/matrix.h"
#include "model/formats/odb/text/attributes.h"
#include "model/formats/odb/text/job_tree.h"

namespace model::odb {

/// What the attributes of a layer say about its build (odb-notes, Stack). On copper .layer_dielectric and
/// .dielectric_constant are about the dielectric under it; .copper_weight is ounces per square foot in inch files and
/// µm in mm files. Zero is "not set"; numbers that no material has are reported and left out.
[[nodiscard]] LayerFacts factsOf(const AttributeList& attributes, const MatrixLayer& layer, std::string_view path,
                                 Diagnostics& diagnostics);

/// The .board_thickness of a file, in nm; nothing if there is no such file or it does not say.
[[nodiscard]] std::optional<double> boardThicknessIn(const formats::FileTree& tree, const std::string& path,
                                                     Unit defaultUnit, Diagnostics& diagnostics);

/// What the matrix says about the material of a layer.
void addMatrixFacts(const MatrixLayer& layer, Material& material);

}  // namespace model::odb
