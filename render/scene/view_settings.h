#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "render/scene/section_plane.h"
#include "render/scene/z_scale.h"

namespace render {

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

/// The same in a plane of the board, as a camera sees it: what is opaque and nearer to the viewer hides it. It lies
/// under the overlay. As long as there is one, the depth of the board is kept beside its picture.
struct PlanePicture {
    Overlay pixels;  ///< of the size of the frame, else it is left out
    float z = 0.0F;  ///< of the plane, mm, as the board is drawn
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
    bool is2d = false;          ///< flat colours, seen straight down
    bool isFabricated = false;  ///< without what a fabricator mills away (model/solids/milling.h)
    bool isMono = false;        ///< white on black, unshaded, unsmoothed: a raster of the visible layers
    bool isSmoothed = true;     ///< 4x multisampling, where device and back end have it and the picture fits with it
    bool cull = true;           ///< frustum culling and level of detail
    LevelOfDetail levels = LevelOfDetail::Error;
    float explode = 0.0F;  ///< 0 = real stackup; 1 spreads the layers over about half the board's width
    ZScale zScale;         ///< thicknesses as drawn
    std::shared_ptr<const SectionCut> section;  ///< cuts the board open in 3D; none: it is whole
    float dim = 0.0F;  ///< by how much what does not stand out fades into the background; 1 = all
    bool isOutlined =
        false;  ///< outlines and nothing in them, in flat views; Impostor draws them, whatever `backend` says
    glm::vec3 background{0.10F, 0.11F, 0.13F};  ///< sRGB
    Overlay overlay;                            ///< none while it has no pixels
    PlanePicture inPlane;                       ///< likewise; in 3D
    bool cachesBoard = false;                   ///< caches the board as drawn, for a next frame of the same presenter
    bool isBoardCached = false;  ///< nothing but the overlay differs from the frame that cached it: draws that alone
};

struct FrameStats {
    double cpuMs = 0.0;               ///< recording and submitting
    double gpuMs = 0.0;               ///< by timestamps, without reading back; 0 if the device has none
    Backend backend = Backend::Auto;  ///< the one that drew
    bool isByDevice = false;          ///< the device drew it; else it is of tiles, or an older frame from elsewhere
    bool isOverlayAlone = false;      ///< the board was the cached one
    bool isPartial = false;           ///< parts of the board are missing, and come with a later frame
};

/// 8-bit sRGB RGBA, rows from the top.
struct Image {
    std::uint32_t width = 0;
    std::uint32_t height = 0;
    std::vector<std::uint8_t> rgba;
};

}  // namespace render
