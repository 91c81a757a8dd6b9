#pragma once

#include <map>
#include <string>

#include "model/clearance/layer_geometry.h"
#include "model/clearance/rule_report.h"

namespace model {

/// Small drawings of where rules are broken on one step: what is nearby on the layer, the two sides in colours of their
/// own, all else grey, and the spacing with its dimension. Layers are prepared when they are drawn for the first time;
/// the document must outlive it.
class LocationPictures {
public:
    explicit LocationPictures(const Document& step) : m_step(step) {}

    /// An "<svg>" to stand in a page that has kStyle in its styles. A few kilobytes, however large the board is.
    [[nodiscard]] std::string svgOf(const RuleFinding& finding);

    /// CSS of the classes in the drawings.
    static const char* const kStyle;

private:
    struct Surroundings {
        LayerGeometry flat;   ///< copper, or openings
        LayerGeometry holes;  ///< through it
    };
    [[nodiscard]] const Surroundings& around(LayerId layer);
    /// The layer of the finding; of holes a copper layer that they pass.
    [[nodiscard]] LayerId shownLayer(const RuleFinding& finding) const;

    const Document& m_step;
    std::map<LayerId, Surroundings> m_layers;
};

}  // namespace model
