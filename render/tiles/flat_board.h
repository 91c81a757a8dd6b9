#pragma once

#include <memory>
#include <span>
#include <vector>

#include "render/modelling/board_model.h"
#include "render/scene/element_state.h"
#include "render/tiles/area_outlines.h"
#include "render/tiles/sample_scan.h"

namespace render {

/// From millimetres of the board to pixels of a tile, y down: pixel = scale * mm + offset. Both axes have one scale but
/// for their signs.
struct PlaneMap {
    glm::dvec2 scale{1.0};
    glm::dvec2 offset{0.0};
};

/// What of a layer is drawn.
struct Drawn {
    bool isFabricated = false;  ///< ViewSettings::isFabricated
    /// A list of states per step of the board (0 = the board itself), which may be shorter than its elements.
    std::span<const std::vector<ElementState>> states;
};

/// A board seen straight down, drawn by processors: which samples each of its layers covers, as the impostor back end
/// draws them (backends_test holds both against each other). Read only once it is made; any thread may draw.
class FlatBoard {
public:
    explicit FlatBoard(std::shared_ptr<const BoardModel> model);

    /// Copies that are flipped lie on other layers: such boards are left to the device.
    [[nodiscard]] bool isDrawable() const { return m_isDrawable; }
    [[nodiscard]] const BoardModel& model() const { return *m_model; }
    /// Layers with insides of holes, by row.
    [[nodiscard]] const std::vector<bool>& withBores() const { return m_withBores; }
    /// Adds what lies in a tile of this layer, without hidden elements. False: nothing does.
    bool draw(std::uint32_t layer, const PlaneMap& map, const Drawn& drawn, MaskTile& tile) const;
    /// Adds the elements of one state that stand out (render::standsOut), drawn once for each of `moves` (pixels).
    bool drawStandingOut(std::uint32_t layer, const PlaneMap& map, const Drawn& drawn, ElementState state,
                         std::span<const glm::dvec2> moves, MaskTile& tile) const;

private:
    struct Step {
        const BoardModel* model = nullptr;
        AreaOutlines outlines;
        std::vector<Box2> boxOfInstance;  ///< in the step; empty where another piece of its shape has the outlines
    };
    class Drawing;

    static Step stepOf(const BoardModel& model);
    template <class Wanted>
    bool drawWanted(std::uint32_t layer, const PlaneMap& map, const Drawn& drawn, const Wanted& isWanted,
                    std::span<const glm::dvec2> moves, MaskTile& tile) const;

    std::shared_ptr<const BoardModel> m_model;
    std::vector<Step> m_steps;  ///< the board itself first
    std::vector<bool> m_withBores;
    bool m_isDrawable = true;
};

}  // namespace render
