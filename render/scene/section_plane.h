#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <optional>
#include <vector>

#include "model/base/result.h"
#include "model/index/board_index.h"

namespace render {

/// The section plane, which is upright. What lies to the left of its line is cut away.
struct SectionPlane {
    glm::dvec2 start{0.0};           ///< mm, in the model's coordinates (BoardFrame::origin)
    glm::dvec2 direction{1.0, 0.0};  ///< of length 1
    bool operator==(const SectionPlane&) const = default;
};

/// A trapezoid with level edges of what the plane cuts: a rectangle, but for the walls of laser vias.
struct SectionFace {
    model::LayerId layer;
    double from = 0.0;  ///< along the plane from its start, mm
    double to = 0.0;
    double leanFrom = 0.0;  ///< by so much the upper edge begins and ends farther along than the lower one
    double leanTo = 0.0;
    float bottom = 0.0F;  ///< of its layer: 0 the lower, 1 the upper face; so it stays when the stackup changes
    float top = 1.0F;
    bool isMirrored = false;  ///< of flipped copies: of the mirror image of the layer, which has no counterpart
    bool isInside = false;    ///< may lie in a substrate, and is then seen
    std::optional<std::uint32_t> colour;  ///< of dielectrics by their material, 0xRRGGBB; none: of the layer
    /// Other layers than its own at whose height it lies: solder mask beside the copper of this layer, drawn while the
    /// mask lies right on that copper.
    model::LayerId beside;
};

/// A board cut by a section plane: nothing of its geometry changes, fragments on the one side are left out and the cut
/// is filled.
struct SectionCut {
    SectionPlane plane;
    std::vector<SectionFace> faces;
};

/// Cuts along the straight line through two locations (nm, board coordinates), from one edge of the board to the other;
/// what was to the left on the line from `a` to `b` goes. `origin` is BoardFrame::origin. The faces are those of
/// model::makeSection with SectionRequest::isAsSolid; `milled` is that of the request, empty where the view shows what
/// is milled away (ViewSettings::isFabricated). Errors: BadUsage for places that are not apart or off the coordinates
/// of boards.
[[nodiscard]] base::Result<SectionCut> makeSectionCut(const model::BoardIndex& index, model::Point origin,
                                                      model::PointD a, model::PointD b,
                                                      std::vector<std::vector<model::ElementId>> milled = {});

}  // namespace render
