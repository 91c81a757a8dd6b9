#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "model/base/result.h"
#include "render/modelling/board_model.h"
#include "render/scene/element_state.h"
#include "render/scene/explosion.h"
#include "render/scene/layer_style.h"
#include "render/scene/view_settings.h"

namespace render {

namespace gpu {
class Device;
}
struct StandardModel;

/// A board model on the GPU, every step of a panel once. One per document; every view draws from it.
class BoardScene {
public:
    /// Where there is no room for it, tries with short lists of what is seen, which only makes frames slower. Errors:
    /// DeviceFailed, saying what there was no room for, or that the device was lost on the way.
    [[nodiscard]] static base::Result<BoardScene> make(gpu::Device& device, const BoardModel& model);
    [[nodiscard]] static base::Result<BoardScene> make(gpu::Device& device, const StandardModel& model);
    /// One that says how the board looks, and is on the device once it is loaded: by presenters before they draw it, if
    /// nobody did before.
    [[nodiscard]] static BoardScene makeUnloaded(gpu::Device& device, std::shared_ptr<const BoardModel> model);
    /// Does nothing where that was done. On a software device, where it is no work for the queue, any thread may do it,
    /// and whoever does not draw may use the scene meanwhile. Errors: those of `make`; the scene stays as it is.
    [[nodiscard]] base::Status load();

    /// Both throw gpu::OutOfMemory (render/gpu/check.h).
    ///
    /// Lists of what is seen take `mostListBytes` at most, unless one copy alone needs more; where that is too little
    /// for all copies in view, they are drawn in several groups.
    BoardScene(gpu::Device& device, const BoardModel& model, std::uint64_t mostListBytes = 128ULL << 20U);
    /// The same board in the pipeline that the hybrid one is compared with; FrameStats::backend is then Standard.
    BoardScene(gpu::Device& device, const StandardModel& model);
    ~BoardScene();
    BoardScene(BoardScene&&) noexcept;
    BoardScene& operator=(BoardScene&&) noexcept;

    void setStyles(std::span<const LayerStyle> styles);
    /// Other heights of the same layers (model::restack); geometry stays as it is.
    void setHeights(const BoardFrame& frame);
    /// Lower and upper face of every layer as a view with these settings and the styles set last draws it, mm.
    [[nodiscard]] std::vector<ZRange> drawnHeights(const ViewSettings& settings) const;
    /// Likewise the board's lower plus its upper face, mm: flipped copies are mirrored at half of that where a layer
    /// has no counterpart.
    [[nodiscard]] float drawnFaces(const ViewSettings& settings) const;
    /// How elements of the board itself or of a step it places (0 = the board, else 1 + row of BoardModel::steps) look
    /// in all its copies, by row; those beyond the list are plain. What did not change is not sent again, what did
    /// comes with the next frame of the board.
    void setStates(std::span<const ElementState> states, std::uint32_t step = 0);
    /// The colours that states name, sRGB; shader::kHighlightRow at most.
    void setPalette(std::span<const glm::vec3> colours);
    /// Grows with what is different on the board, not with the number of copies. 0 until it is loaded.
    [[nodiscard]] std::uint64_t geometryBytes() const;
    /// With the lists of what is seen, which grow with the copies up to their limit.
    [[nodiscard]] std::uint64_t gpuBytes() const;

    struct Impl;
    [[nodiscard]] Impl& impl() { return *m_impl; }

private:
    explicit BoardScene(std::unique_ptr<Impl> impl);

    std::unique_ptr<Impl> m_impl;
};

}  // namespace render
