#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "model/board/document.h"

namespace model::odb {

/// A row of the matrix: what a layer is, before anything of it is read (odb-notes, Stack).
struct MatrixLayer {
    int row = 0;
    LayerContext context = LayerContext::Board;
    LayerType type = LayerType::Other;
    std::string name;
    bool isNegative = false;
    std::string startName;  ///< drill span, either end first; empty for "through all copper"
    std::string endName;
    LayerUse use = LayerUse::Plain;
    std::string useName;         ///< ADD_TYPE in capitals: "BACKDRILL", "SIGNAL_FLEX"; empty if there is none
    std::string form;            ///< "RIGID" or "FLEX", if stated
    std::string dielectricType;  ///< "CORE" or "PREPREG", if stated
    std::string dielectricName;  ///< of the material
    std::uint32_t line = 0;

    [[nodiscard]] bool isCopper() const {
        return type == LayerType::Signal || type == LayerType::PowerGround || type == LayerType::Mixed;
    }
    [[nodiscard]] bool isHoles() const { return type == LayerType::Drill || type == LayerType::Rout; }
};

struct Matrix {
    std::vector<std::string> steps;   ///< by column
    std::vector<MatrixLayer> layers;  ///< by row

    /// Row of the first layer of that name (case does not matter); the number of layers if there is none. A name may be
    /// listed twice (a dielectric of two plies); its folder belongs to the first row.
    [[nodiscard]] std::size_t rowOf(std::string_view name) const;
};

/// Rows beyond base::kMostLayers are left out and reported.
[[nodiscard]] Matrix parseMatrix(std::string_view text, std::string_view path, Diagnostics& diagnostics);

/// Does the layer mark an area (bend, flexible, rigid) or a process step (what is plated, or covered meanwhile) instead
/// of being made of something?
[[nodiscard]] bool isMarker(const MatrixLayer& layer);

/// Is the layer a part of the stackup: copper, dielectric, mask, paste or silk of the board, and no marker?
[[nodiscard]] bool isPhysical(const MatrixLayer& layer);

/// Rows of `layers` in the order a document holds them: first the layers that make up the board, from the top, then the
/// rest as listed. Copper listed below the bottom side (odb-notes, Stack: inner layers after the drills) is put back
/// above the bottom copper and reported.
[[nodiscard]] std::vector<std::size_t> physicalOrder(const std::vector<MatrixLayer>& layers, std::string_view path,
                                                     Diagnostics& diagnostics);

}  // namespace model::odb
