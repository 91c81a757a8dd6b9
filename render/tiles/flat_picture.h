#pragma once

#include <deque>
#include <future>
#include <map>
#include <memory>
#include <optional>
#include <span>
#include <tuple>
#include <vector>

#include "render/scene/camera.h"
#include "render/scene/scene_layers.h"
#include "render/tiles/budget.h"
#include "render/tiles/flat_board.h"
#include "render/tiles/rough_picture.h"
#include "render/tiles/tile_painter.h"

namespace render {

/// A frame of a flat view.
struct FlatRequest {
    const SceneLayers* layers = nullptr;
    std::span<const std::vector<ElementState>> states;  ///< per step of the board, the board itself first
    Camera camera;
    ViewSettings settings;  ///< of these what changes a flat picture of the board; always smoothed
    int width = 0;
    int height = 0;  ///< pixels
};

/// Flat pictures of a board from tiles that are kept: which samples of each layer are covered, on a grid that lies
/// still on the board, and what they look like together. Moving the view draws what is new at its edges, another look
/// only paints anew; at another scale the last picture serves until the tiles for it are there.
///
/// Draws by itself what the device draws with the impostor back end, smoothed, to a level of 255 in all but few pixels
/// (tests/gpu/flat_picture_test.cpp). What it cannot draw it says: outlines, tilted or turned views, bodies, flipped
/// copies of steps, more colours by translucent layers than 255. All cores draw, and but for what the
/// constructor begins nothing goes on after a call.
class FlatPicture {
public:
    /// Comes back at once: what of the model it needs is made in the background.
    /// `maxBytes` for tiles; those used longest ago go first. A frame that needs more alone is not drawn.
    explicit FlatPicture(std::shared_ptr<const BoardModel> model, std::uint64_t maxBytes = kMaxBytes);

    enum class Quality {
        None,   ///< nothing was drawn: this frame is for the device
        Rough,  ///< what was there already, scaled, or what stands out without its dark edge; `refine` goes on
        Exact
    };
    /// Draws `pixels`. Takes `budgetMs` or a little longer for tiles that are missing (0: as long as it takes), and no
    /// time for those of a scale that may be gone with the next frame. Until what the constructor began is there, that
    /// is background.
    [[nodiscard]] Quality draw(const FlatRequest& request, double budgetMs);
    using Pixels = std::vector<std::uint32_t>;
    /// The last frame, width * height of 0xffRRGGBB, rows from the top. The next `draw` may paint over it, but who
    /// holds it may read it as long as they like.
    [[nodiscard]] std::shared_ptr<const Pixels> pixels() const { return m_isLastShown ? m_last.pixels : m_rough; }
    /// Where its tiles are missing there was nothing to stretch: that is background.
    [[nodiscard]] bool isPartial() const { return m_isBare; }
    /// Goes on with the last frame for about `budgetMs`. True: another `draw` would show more than the last one did.
    [[nodiscard]] bool refine(double budgetMs);
    /// After a frame that was exact: for about `budgetMs` what the next ones may need, tiles around what is seen and
    /// the whole board in small. True: there is nothing left to do.
    [[nodiscard]] bool prepare(double budgetMs);
    [[nodiscard]] std::uint64_t bytes() const;

    static constexpr std::uint64_t kMaxBytes = 256ULL << 20U;

private:
    /// Tiles of one scale that meet at whole pixels: pixel = scale * mm - phase.
    struct Tiling {
        std::uint32_t id = 0;
        glm::dvec2 scale{0.0};
        glm::dvec2 phase{0.0};  ///< 0 to 1
    };
    /// What stands out, as it is or widened and with a dark edge, as far as it is drawn.
    struct OverWork {
        std::uint64_t look = 0;
        std::size_t step = 0;
        MaskTile mask{};
        std::unique_ptr<PixelTile> samples = std::make_unique<PixelTile>();
        bool isUsed = false;  ///< something was drawn in either
    };
    struct Tile {
        std::vector<std::unique_ptr<MaskTile>> masks;  ///< by layer
        std::vector<std::uint8_t> isDrawn;             ///< likewise
        std::shared_ptr<const PixelTile> over;
        std::vector<std::uint32_t> overRows;  ///< of what stands out, those with something here
        std::unique_ptr<OverWork> work;       ///< while it, or then its dark edge, is drawn
        bool isOutlined = false;              ///< `over` has all that it gets
        std::unique_ptr<PixelTile> samples;   ///< what is seen of the layers
        std::unique_ptr<PixelTile> picture;   ///< the same in colours, with what stood out
        std::shared_ptr<const PixelTile> paintedOver;
        std::uint64_t overLook = 0;
        std::uint64_t stack = 0;
        std::uint64_t pictureLook = 0;
        TilePart seen{glm::ivec2(0), glm::ivec2(0)};     ///< of the samples
        TilePart painted{glm::ivec2(0), glm::ivec2(0)};  ///< of the picture
        std::uint64_t lastUse = 0;
    };
    using Key = std::tuple<std::uint32_t, int, int>;
    /// Tiles that a rectangle of pixels needs, from `origin` of their tiling on.
    struct Window {
        Tiling tiling;
        glm::ivec2 origin{0};
        glm::ivec2 size{0};
    };
    /// A picture, and where it lies.
    struct Sheet {
        PlaneMap map;
        glm::ivec2 size{0};
        std::shared_ptr<Pixels> pixels = std::make_shared<Pixels>();
        std::uint64_t look = 0;
        std::uint64_t overLook = 0;
    };
    /// What stands out: an own byte per state and brightness.
    struct OverPaint {
        std::uint32_t layer = 0;
        bool isBore = false;
        ElementState state = kPlain;
        std::uint8_t byte = 0;
    };

    [[nodiscard]] const FlatBoard& board() const { return m_board.get(); }
    [[nodiscard]] bool isReadyWithin(double budgetMs) const;
    [[nodiscard]] bool setLook(const FlatRequest& request, const FramePlan& plan);
    void setStates(std::span<const std::vector<ElementState>> states);
    void dropEmptyBores(std::vector<Paint>& paints) const;
    bool setOver(const FlatRequest& request, std::vector<glm::vec3>& colours);
    [[nodiscard]] Window windowOf(const FramePlan& plan, const FlatRequest& request);
    [[nodiscard]] Window overviewWindow() const;
    template <class Visit>
    void forTiles(const Window& window, const Visit& visit);
    [[nodiscard]] PlaneMap mapOf(const Tiling& tiling, glm::ivec2 tile) const;
    [[nodiscard]] bool isFilled(const Window& window);
    [[nodiscard]] bool isEmpty(const Window& window);
    void makeRoomForOver();
    struct Filled {
        bool isWhole = false;   ///< nothing is missing
        bool isEnough = false;  ///< something was drawn, and no time is left: what comes next waits
    };
    Filled fill(const Window& window, const Budget& budget);
    bool fillOver(const Window& window, const Budget& budget, bool isOutlined);
    [[nodiscard]] bool isOverviewThere() const;
    bool fillOverview(const Budget& budget);
    void fillLayer(Tile& tile, const PlaneMap& map, std::uint32_t layer) const;
    void drawOver(Tile& tile, const PlaneMap& map) const;
    [[nodiscard]] OverWork& workOn(Tile& tile) const;
    void takeOver(Tile& tile) const;
    void outlineOver(Tile& tile, const PlaneMap& map) const;
    void paint(const Window& window, const RoughPicture* behind, std::uint32_t* pixels);
    void bringUpToDate(Tile& tile, const TilePart& part) const;
    void paintAnew(Tile& tile, const TilePart& part) const;
    [[nodiscard]] bool isLastUsable() const;
    void paintWhole();
    void paintRough(const Budget& budget);
    void paintBackground(const FlatRequest& request, const glm::vec3& background);
    void evict();
    [[nodiscard]] static std::uint64_t bytesOf(const Tile& tile);
    void clearTiles();

    std::shared_future<FlatBoard> m_board;
    std::uint64_t m_maxBytes;
    std::map<Key, Tile> m_tiles;
    std::deque<Tiling> m_tilings;
    std::uint32_t m_lastTiling = 0;
    std::uint64_t m_use = 0;
    std::uint64_t m_stack = 1;      ///< of what hides what
    std::uint64_t m_look = 1;       ///< of what is painted, and in which colours
    std::uint64_t m_overLook = 1;   ///< of what stands out
    std::uint64_t m_edgedLook = 1;  ///< the same, as of the frame before
    std::vector<Paint> m_paints;
    std::vector<glm::vec3> m_overColours;
    std::vector<glm::vec3> m_inksOfTiles;  ///< the last of those that were any: pictures of tiles may still have them
    std::vector<OverPaint> m_over;
    glm::vec3 m_background{0.0F};
    std::optional<SampleColours> m_colours;
    std::vector<std::vector<ElementState>> m_states;
    bool m_isAnyHidden = false;
    std::size_t m_standingOut = 0;         ///< so many elements do, of all copies of steps
    std::vector<ElementState> m_standing;  ///< the states that stand out, each once
    bool m_isFabricated = false;
    std::optional<Window> m_window;  ///< of the last frame
    std::uint32_t m_settled = 0;     ///< the tiling that was last shown exactly
    bool m_isExact = true;           ///< its tiles meet its pixels
    bool m_isResting = false;        ///< `refine` was called since
    bool m_isOverShown = false;      ///< the last frame showed all that stands out
    bool m_isBare = false;           ///< the last frame had nothing to stretch
    Sheet m_last;                    ///< the last frame that its tiles drew
    std::shared_ptr<Pixels> m_rough = std::make_shared<Pixels>();
    bool m_isLastShown = false;
    Sheet m_overview;
};

}  // namespace render
