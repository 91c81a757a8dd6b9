#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "model/diagnostics.h"

namespace model::odb {

/// A FID record: feature `feature` of layer `layer` belongs to net `net`.
struct NetFeature {
    std::uint32_t net = 0;      ///< row of EdaData::nets
    std::uint32_t layer = 0;    ///< row of EdaData::layers
    std::uint32_t feature = 0;  ///< ordinal in the layer's features file
    std::uint32_t line = 0;
};

struct EdaPackage {
    std::string name;
    std::vector<std::string> pins;
};

/// What `eda/data` says about nets and packages (odb-notes, Stack).
struct EdaData {
    std::string generator;            ///< HDR
    std::vector<std::string> layers;  ///< LYR
    std::vector<std::string> nets;    ///< in file order: components refer to these by number
    std::vector<NetFeature> netFeatures;
    std::vector<EdaPackage> packages;
};

/// The name that stands for "no net".
inline constexpr std::string_view kNoNet = "$NONE$";

/// `layerNames` are those of the matrix: LYR separates names by blanks, and names may hold blanks themselves, so the
/// longest known name wins.
[[nodiscard]] EdaData parseEda(std::string_view text, std::string_view path, const std::vector<std::string>& layerNames,
                               Diagnostics& diagnostics);

}  // namespace model::odb
