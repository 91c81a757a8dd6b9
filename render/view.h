#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "model/base/ids.h"
#include "model/base/result.h"
#include "render/board_model.h"
#include "render/camera.h"
#include "render/cut.h"
#include "render/element_state.h"
#include "render/explosion.h"
#include "render/layer_style.h"
#include "render/standard_model.h"
#include "render/z_scale.h"

/// The renderer's face to app/ and ui/: a scene on a device, and two ways to present a view of it.
namespace render {

namespace gpu {
class Device;
}

/// What draws (backend_choice.cpp says what Auto takes and why). Standard is no choice: it is what draws a scene of the
/// standard pipeline.
enum class Backend { Auto, Mesh, Pull, Impostor, Raster, Standard };
/// In lower case, as the command line has it.
[[nodiscard]] const char* nameOf(Backend backend);

/// A picture laid over the board pixel by pixel, from the upper left corner: grids, names, rubber bands. Rows from the
/// top, sRGB RGBA of 8 bits, multiplied by alpha; read while a frame is recorded.
struct Overlay {
    std::uint32_t width = 0;
    std::uint32_t height = 0;
    const std::uint8_t* rgba = nullptr;
};

/// How finely round things are drawn.
enum class LevelOfDetail {
    Error,  ///< outlines stray less than a third of a pixel
    Paper,  ///< the paper's fixed three levels by size: 64, 32 or 16 vertices
    Coarse  ///< outlines stray up to two pixels: for frames while a slow view moves
};

/// Everything that changes from frame to frame. None of it rebuilds geometry.
struct ViewSettings {
    Backend backend = Backend::Auto;
    bool is2d = false;       ///< flat colours, seen straight down
    bool isMono = false;     ///< white on black, unshaded, unsmoothed: a raster of the visible layers
    bool isSmoothed = true;  ///< 4x multisampling, where device and back end have it and the picture fits with it
    bool cull = true;        ///< frustum culling and level of detail
    LevelOfDetail levels = LevelOfDetail::Error;
    float explode = 0.0F;            ///< 0 = real stack; 1 spreads the layers over about half the board's width
    ZScale zScale;                   ///< thicknesses as drawn
    std::shared_ptr<const Cut> cut;  ///< cuts the board open in 3D; none: it is whole
    float dim = 0.0F;                ///< by how much what does not stand out is darkened; 1 = to black
    bool isOutlined =
        false;  ///< outlines and nothing in them, in flat views; Impostor draws them, whatever `backend` says
    glm::vec3 background{0.10F, 0.11F, 0.13F};  ///< sRGB
    Overlay overlay;                            ///< none while it has no pixels
    bool keepsBoard = false;   ///< puts the board as drawn aside, for a next frame of the same presenter
    bool isBoardKept = false;  ///< nothing but the overlay differs from the frame that kept it: draws that alone
};

struct FrameStats {
    double cpuMs = 0.0;               ///< recording and submitting
    double gpuMs = 0.0;               ///< by timestamps, 0 if the device has none
    Backend backend = Backend::Auto;  ///< the one that drew
    bool isOverlayAlone = false;      ///< the board was the one kept before
};

/// 8-bit sRGB RGBA, rows from the top.
struct Image {
    std::uint32_t width = 0;
    std::uint32_t height = 0;
    std::vector<std::uint8_t> rgba;
};

/// A board model on the GPU, every step of a panel once. One per document; every view draws from it.
class BoardScene {
public:
    /// Where there is no room for it, tries with short lists of what is seen, which only makes frames slower. Errors:
    /// DeviceFailed, saying what there was no room for, or that the device was lost on the way.
    [[nodiscard]] static base::Result<BoardScene> make(gpu::Device& device, const BoardModel& model);
    [[nodiscard]] static base::Result<BoardScene> make(gpu::Device& device, const StandardModel& model);

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
    /// How elements of the board itself or of a step it places (0 = the board, else 1 + row of BoardModel::steps) look
    /// in all its copies, by row; those beyond the list are plain. What did not change is not sent again.
    void setStates(std::span<const ElementState> states, std::uint32_t step = 0);
    /// The colours that states name, sRGB; shader::kElementColourCount at most.
    void setPalette(std::span<const glm::vec3> colours);
    /// Grows with what is different on the board, not with the number of copies.
    [[nodiscard]] std::uint64_t geometryBytes() const;
    /// With the lists of what is seen, which grow with the copies up to their limit.
    [[nodiscard]] std::uint64_t gpuBytes() const;

    struct Impl;
    [[nodiscard]] Impl& impl() { return *m_impl; }

private:
    std::unique_ptr<Impl> m_impl;
};

/// Draws to memory: command line, tests, screenshots, and windows on platforms without a Vulkan surface.
class OffscreenPresenter {
public:
    explicit OffscreenPresenter(gpu::Device& device);
    ~OffscreenPresenter();
    OffscreenPresenter(OffscreenPresenter&&) noexcept;
    OffscreenPresenter& operator=(OffscreenPresenter&&) noexcept;

    /// Draws one frame and waits for it. `width` and `height` up to the device's largest image.
    /// Errors: BadUsage (size), DeviceFailed.
    [[nodiscard]] base::Result<Image> render(BoardScene& scene, const Camera& camera, const ViewSettings& settings,
                                             std::uint32_t width, std::uint32_t height);
    [[nodiscard]] FrameStats stats() const;

private:
    struct Impl;
    std::unique_ptr<Impl> m_impl;
};

/// Writes a PNG. Errors: OutputFailed with the path and the system's reason; a partial file is removed.
[[nodiscard]] base::Status writePng(const Image& image, const std::string& path);

}  // namespace render
