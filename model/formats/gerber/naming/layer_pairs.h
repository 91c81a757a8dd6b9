#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace model::gerber {

/// A row of Altium's export of layer pairs (.LDP): which copper layers the drills of a file pass.
struct LayerPair {
    std::string drillFile;             ///< without folders, upper case
    std::vector<std::string> endings;  ///< of the images of those layers, upper case, from the first to the last

    /// Is one of them an internal plane (GP1), which Altium counts by themselves?
    [[nodiscard]] bool namesPlanes() const;
};

/// "LayersSetName=Top_Bot|DrillFile=b-roundholes.txt|DrillLayers=gtl,g1,gbl": is there such a row at the beginning?
[[nodiscard]] bool looksLikeLayerPairs(std::string_view head);
/// All rows; those that cannot be read are left out.
[[nodiscard]] std::vector<LayerPair> parseLayerPairs(std::string_view text);

}  // namespace model::gerber
