#include "render/tiles/flat_picture.h"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cmath>
#include <utility>

#include "model/base/parallel.h"
#include "render/culling/frame_plan.h"

namespace render {

namespace {

constexpr std::uint32_t kOverviewTiling = 0;
constexpr int kOverviewPixels = 1000;  // along the longer side of the board
constexpr float kOverviewRoom = 1.1F;
/// Tilings that meet the pixels of a frame to this much of a pixel are those of its picture.
constexpr double kExactPx = 0.002;
/// While a view moves, its picture may lie this far beside it.
constexpr double kMovingPx = 0.51;
constexpr std::size_t kMostTilings = 32;

constexpr glm::vec3 kSilhouette(0.0015F);  // as in highlight_pass.cpp

bool isUneven(const shader::LayerState& state) {
    return (state.flags & shader::kLayerVisible) != 0 &&
           (state.flags & (shader::kLayerGrowsUp | shader::kLayerGrowsDown)) != 0;
}

/// Straight down, x and y of the board along those of the picture, in pixels of one size.
bool isLevel(const FramePlan& plan) {
    const glm::mat4& clip = plan.data.clipFromBoard;
    const double x = double{clip[0][0]} * plan.data.width;
    const double y = double{clip[1][1]} * plan.data.height;
    return isFlatView(plan) && std::abs(std::abs(x) - std::abs(y)) < 1e-5 * std::abs(x) &&
           std::abs(clip[1][0]) < 1e-6F * std::abs(clip[0][0]) && std::abs(clip[0][1]) < 1e-6F * std::abs(clip[1][1]);
}

/// But for their colours.
bool isAlike(const Paint& a, const Paint& b) {
    return a.layer == b.layer && a.isBore == b.isBore && a.isOpaque() == b.isOpaque();
}

glm::vec3 colourOf(const ElementColours& palette, ElementState state) {
    const std::uint32_t row = state & shader::kElementColourMask;
    const glm::vec3 colour = palette[row == 0 ? shader::kHighlightRow : row - 1];
    const bool isLit = (state & shader::kElementHighlighted) != 0;
    return isLit ? colour / std::max({colour.r, colour.g, colour.b, 1e-3F}) : colour;
}

std::size_t pixelCount(glm::ivec2 size) {
    return static_cast<std::size_t>(size.x) * static_cast<std::size_t>(size.y);
}

/// Who holds pixels of another size keeps them as they are.
void makeRoom(glm::ivec2 size, std::shared_ptr<FlatPicture::Pixels>& pixels) {
    if (pixels->size() != pixelCount(size)) {
        pixels = std::make_shared<FlatPicture::Pixels>(pixelCount(size));
    }
}

}  // namespace

FlatPicture::FlatPicture(std::shared_ptr<const BoardModel> model, std::uint64_t maxBytes)
    : m_board(std::async([shared = std::move(model)] { return FlatBoard(shared); })), m_maxBytes(maxBytes) {}

PlaneMap FlatPicture::mapOf(const Tiling& tiling, glm::ivec2 tile) const {
    return {tiling.scale, -tiling.phase - glm::dvec2(tile * kTilePixels)};
}

template <class Visit>
void FlatPicture::forTiles(const Window& window, const Visit& visit) {
    const auto tileOf = [](int pixel) {
        return pixel >= 0 ? pixel / kTilePixels : -((kTilePixels - 1 - pixel) / kTilePixels);
    };
    const glm::ivec2 end = window.origin + window.size;
    for (int y = tileOf(window.origin.y); y * kTilePixels < end.y; ++y) {
        for (int x = tileOf(window.origin.x); x * kTilePixels < end.x; ++x) {
            const glm::ivec2 corner = glm::ivec2(x, y) * kTilePixels;
            Tile& tile = m_tiles[{window.tiling.id, x, y}];
            tile.lastUse = m_use;
            tile.masks.resize(board().model().layers.size());
            tile.isDrawn.resize(board().model().layers.size());
            visit(tile, glm::ivec2(x, y),
                  TilePart{glm::max(window.origin - corner, 0), glm::min(end - corner, kTilePixels)});
        }
    }
}

void FlatPicture::clearTiles() {
    m_tiles.clear();
    m_settled = 0;
    m_last = {};
    m_rough = std::make_shared<Pixels>();
    m_isLastShown = false;
    m_overview = {};
}

void FlatPicture::dropEmptyBores(std::vector<Paint>& paints) const {
    std::erase_if(paints, [&](const Paint& paint) { return paint.isBore && !board().withBores()[paint.layer]; });
}

/// What stands out in which order and colours. True: it is other than before.
bool FlatPicture::setOver(const FlatRequest& request, std::vector<glm::vec3>& colours) {
    std::vector<OverPaint> over;
    if (!m_standing.empty()) {
        const FramePlan plan =
            planFrame(*request.layers, request.camera, request.settings, static_cast<std::uint32_t>(request.width),
                      static_cast<std::uint32_t>(request.height), Subject::StandingOut);
        colours.push_back(kSilhouette);
        std::vector<std::pair<ElementState, float>> known;
        std::vector<Paint> paints = paintsStandingOut(plan);
        dropEmptyBores(paints);
        for (const Paint& paint : paints) {
            for (const ElementState state : m_standing) {
                const std::pair<ElementState, float> key(state, paint.light.r);
                const auto at = static_cast<std::size_t>(std::ranges::find(known, key) - known.begin());
                if (at == known.size()) {
                    known.push_back(key);
                    colours.push_back(colourOf(request.layers->palette, state) * paint.light);
                }
                over.push_back({paint.layer, paint.isBore, state, static_cast<std::uint8_t>(at + 2)});
            }
        }
    }
    const auto isSame = [](const OverPaint& a, const OverPaint& b) {
        return a.layer == b.layer && a.isBore == b.isBore && a.state == b.state && a.byte == b.byte;
    };
    const bool isOther = !std::ranges::equal(over, m_over, isSame);
    m_over = std::move(over);
    return isOther;
}

bool FlatPicture::isReadyWithin(double budgetMs) const {
    const std::chrono::duration<double, std::milli> patience(budgetMs);
    return budgetMs <= 0.0 || m_board.wait_for(patience) != std::future_status::timeout;
}

bool FlatPicture::setLook(const FlatRequest& request, const FramePlan& plan) {
    if (m_isFabricated != request.settings.isFabricated) {
        clearTiles();
        m_isFabricated = request.settings.isFabricated;
    }
    setStates(request.states);
    std::vector<glm::vec3> overColours;
    m_overLook += setOver(request, overColours) ? 1 : 0;
    std::vector<Paint> paints = paintsOf(plan);
    dropEmptyBores(paints);
    if (m_colours && paints == m_paints && overColours == m_overColours && plan.data.background == m_background) {
        return true;
    }
    std::optional<SampleColours> colours = SampleColours::make(plan.data.background, paints, overColours);
    const bool isStackSame =
        colours && m_colours && std::ranges::equal(paints, m_paints, isAlike) && colours->after() == m_colours->after();
    m_stack += isStackSame ? 0 : 1;
    // What begins or ends to stand out is painted where it lies, on pixels that stay as they are.
    const bool isOverAlone = isStackSame && paints == m_paints && plan.data.background == m_background &&
                             (overColours.empty() || m_inksOfTiles.empty() || overColours == m_inksOfTiles);
    m_look += isOverAlone ? 0 : 1;
    if (!isOverAlone || !overColours.empty()) {
        m_inksOfTiles = overColours;
    }
    m_paints = std::move(paints);
    m_overColours = std::move(overColours);
    m_background = plan.data.background;
    m_colours = std::move(colours);
    return m_colours.has_value();
}

FlatPicture::Window FlatPicture::windowOf(const FramePlan& plan, const FlatRequest& request) {
    const glm::dvec2 size(request.width, request.height);
    const glm::dvec2 scale(plan.data.clipFromBoard[0][0] * size.x / 2.0, plan.data.clipFromBoard[1][1] * size.y / 2.0);
    const glm::dvec2 origin = scale * glm::dvec2(plan.data.centre) - size / 2.0;
    // As far as sums of many moves, and zooms there and back, stray by rounding it is the same scale.
    const glm::dvec2 extent = glm::abs(origin) + size;
    const Tiling* best = nullptr;
    double least = kMovingPx;
    for (const Tiling& tiling : m_tilings) {
        const glm::dvec2 off = origin - tiling.phase;
        const glm::dvec2 away = glm::abs(off - glm::round(off));
        const glm::dvec2 stretch = glm::abs(tiling.scale / scale - 1.0) * extent;
        if (std::max(stretch.x, stretch.y) < kExactPx / 2.0 && std::max(away.x, away.y) < least) {
            best = &tiling;
            least = std::max(away.x, away.y);
        }
    }
    const bool isSettled = best != nullptr && (least < kExactPx || best->id == m_settled);
    if (!isSettled || (least >= kExactPx && m_isResting)) {
        m_tilings.push_back({++m_lastTiling, scale, origin - glm::floor(origin)});
        best = &m_tilings.back();
        least = 0.0;
    }
    if (m_tilings.size() > kMostTilings) {
        const std::uint32_t oldest = m_tilings.front().id;
        m_tilings.pop_front();
        std::erase_if(m_tiles, [&](const auto& entry) { return std::get<0>(entry.first) == oldest; });
    }
    m_isExact = least < kExactPx;
    return {*best, glm::ivec2(glm::round(origin - best->phase)), {request.width, request.height}};
}

FlatPicture::Window FlatPicture::overviewWindow() const {
    const BoardModel& model = board().model();
    const glm::dvec2 low(model.boxMin);
    const glm::dvec2 high(model.boxMax);
    const glm::dvec2 room = (high - low) * double{kOverviewRoom - 1.0F} / 2.0;
    const double longer = std::max({high.x - low.x, high.y - low.y, 1e-3});
    const glm::dvec2 scale = glm::sign(m_window->tiling.scale) * (kOverviewPixels / longer);
    const glm::dvec2 a = (low - room) * scale;
    const glm::dvec2 b = (high + room) * scale;
    const glm::ivec2 from(glm::floor(glm::min(a, b)));
    return {{kOverviewTiling, scale, glm::dvec2(0.0)}, from, glm::ivec2(glm::ceil(glm::max(a, b))) - from};
}

void FlatPicture::fillLayer(Tile& tile, const PlaneMap& map, std::uint32_t layer) const {
    auto mask = std::make_unique<MaskTile>();
    const bool isAnything = board().draw(layer, map, {m_isFabricated, m_states}, *mask) &&
                            std::ranges::any_of(*mask, [](std::uint8_t bits) { return bits != 0; });
    tile.masks[layer] = isAnything ? std::move(mask) : nullptr;
    tile.isDrawn[layer] = 1;
}

bool FlatPicture::isFilled(const Window& window) {
    bool isAll = true;
    forTiles(window, [&](Tile& tile, glm::ivec2, const TilePart&) {
        isAll =
            isAll && std::ranges::all_of(m_paints, [&](const Paint& paint) { return tile.isDrawn[paint.layer] != 0; });
    });
    return isAll;
}

bool FlatPicture::isEmpty(const Window& window) {
    bool isEmpty = true;
    forTiles(window, [&](Tile& tile, glm::ivec2, const TilePart&) {
        isEmpty = isEmpty && std::ranges::none_of(tile.isDrawn, [](std::uint8_t drawn) { return drawn != 0; });
    });
    return isEmpty;
}

/// The first piece is drawn however little time there is.
FlatPicture::Filled FlatPicture::fill(const Window& window, const Budget& budget) {
    struct Task {
        Tile* tile;
        PlaneMap map;
        std::uint32_t layer;
    };
    std::vector<Task> tasks;
    forTiles(window, [&](Tile& tile, glm::ivec2 at, const TilePart&) {
        for (const Paint& paint : m_paints) {
            if (tile.isDrawn[paint.layer] == 0 && !paint.isBore) {
                tasks.push_back({&tile, mapOf(window.tiling, at), paint.layer});
            }
        }
    });
    std::atomic<std::size_t> done = 0;
    base::parallelFor(tasks.size(), [&](std::size_t i) {
        if (i == 0 || !budget.isSpent()) {
            fillLayer(*tasks[i].tile, tasks[i].map, tasks[i].layer);
            ++done;
        }
    });
    if (done > 0) {
        evict();
    }
    return {done == tasks.size(), done > 0 && budget.isSpent()};
}

/// Draws what stands out, everywhere as it is before anywhere `isOutlined`; of both a piece in any case.
bool FlatPicture::fillOver(const Window& window, const Budget& budget, bool isOutlined) {
    struct Task {
        Tile* tile;
        PlaneMap map;
    };
    const auto tasksOf = [&](const auto& isMissing) {
        std::vector<Task> tasks;
        forTiles(window, [&](Tile& tile, glm::ivec2 at, const TilePart&) {
            if (isMissing(tile)) {
                tasks.push_back({&tile, mapOf(window.tiling, at)});
            }
        });
        return tasks;
    };
    const auto isStale = [&](const Tile& tile) { return tile.overLook != m_overLook; };
    const std::vector<Task> stale = tasksOf(isStale);
    base::parallelFor(stale.size(), [&](std::size_t i) {
        for (bool isFirst = i == 0; isStale(*stale[i].tile) && (isFirst || !budget.isSpent()); isFirst = false) {
            drawOver(*stale[i].tile, stale[i].map);
        }
    });
    if (std::ranges::any_of(stale, [&](const Task& task) { return isStale(*task.tile); })) {
        return false;
    }
    if (!isOutlined) {
        return true;
    }
    const std::vector<Task> bare = tasksOf([](const Tile& tile) { return !tile.isOutlined; });
    base::parallelFor(bare.size(), [&](std::size_t i) {
        for (bool isFirst = i == 0; !bare[i].tile->isOutlined && (isFirst || !budget.isSpent()); isFirst = false) {
            outlineOver(*bare[i].tile, bare[i].map);
        }
    });
    return std::ranges::all_of(bare, [](const Task& task) { return task.tile->isOutlined; });
}

/// Where a tile is missing, what lies `behind`, if anything does.
void FlatPicture::paint(const Window& window, const RoughPicture* behind, std::uint32_t* pixels) {
    struct Task {
        Tile* tile;
        glm::ivec2 at;
        TilePart part;
        bool isReady;
    };
    std::vector<Task> tasks;
    forTiles(window, [&](Tile& tile, glm::ivec2 at, const TilePart& part) {
        const bool isReady =
            std::ranges::all_of(m_paints, [&](const Paint& paint) { return tile.isDrawn[paint.layer] != 0; });
        tasks.push_back({&tile, at, part, isReady});
    });
    base::parallelFor(tasks.size(), [&](std::size_t i) {
        const auto& [tile, at, part, isReady] = tasks[i];
        const glm::ivec2 corner = at * kTilePixels - window.origin;
        if (isReady) {
            bringUpToDate(*tile, part);
            for (int y = part.from.y; y < part.to.y; ++y) {
                const std::uint32_t* row = tile->picture->data() + y * kTilePixels;
                std::copy(row + part.from.x, row + part.to.x,
                          pixels + static_cast<std::ptrdiff_t>(corner.y + y) * window.size.x + corner.x + part.from.x);
            }
        } else if (behind != nullptr) {
            behind->paint(corner + part.from, corner + part.to, pixels);
        }
    });
}

/// The picture of a tile whose layers are drawn.
void FlatPicture::bringUpToDate(Tile& tile, const TilePart& part) const {
    if (tile.overLook != m_overLook) {
        tile.over.reset();  // of what stood out before
    }
    if (tile.pictureLook != m_look || !tile.painted.holds(part)) {
        paintAnew(tile, part);
    } else if (tile.paintedOver != tile.over) {
        repaintPixels(*m_colours, *tile.samples, tile.paintedOver.get(), tile.over.get(), tile.painted, *tile.picture);
    }
    tile.paintedOver = tile.over;
}

void FlatPicture::paintAnew(Tile& tile, const TilePart& part) const {
    const bool isNew = tile.pictureLook != m_look;
    tile.painted = isNew ? part : TilePart{};
    tile.pictureLook = m_look;
    if (tile.samples == nullptr) {
        tile.samples = std::make_unique<PixelTile>();
        tile.picture = std::make_unique<PixelTile>();
    }
    if (tile.stack != m_stack || !tile.seen.holds(tile.painted)) {
        tile.seen = tile.stack != m_stack ? tile.painted : TilePart{};
        tile.stack = m_stack;
        paintSamples(m_paints, *m_colours, tile.masks, tile.seen, *tile.samples);
    }
    paintPixels(*m_colours, *tile.samples, tile.over.get(), tile.painted, *tile.picture);
}

/// Is the small picture of the whole board there, as it looks now?
bool FlatPicture::isOverviewThere() const {
    return m_overview.look == m_look && m_overview.overLook == m_overLook &&
           glm::sign(m_overview.map.scale) == glm::sign(m_window->tiling.scale);
}

bool FlatPicture::fillOverview(const Budget& budget) {
    if (isOverviewThere()) {
        return true;
    }
    const Window all = overviewWindow();
    if (glm::sign(m_overview.map.scale) != glm::sign(m_window->tiling.scale)) {
        std::erase_if(m_tiles, [](const auto& entry) { return std::get<0>(entry.first) == kOverviewTiling; });
        m_overview = {};
        m_overview.map = {all.tiling.scale, -glm::dvec2(all.origin)};
    }
    if (!fill(all, budget).isWhole || !fillOver(all, budget, false)) {
        return false;
    }
    m_overview = {{all.tiling.scale, -glm::dvec2(all.origin)}, all.size, m_overview.pixels, m_look, m_overLook};
    makeRoom(all.size, m_overview.pixels);
    paint(all, nullptr, m_overview.pixels->data());
    return true;
}

bool FlatPicture::prepare(double budgetMs) {
    if (!m_window || !m_isLastShown) {
        return true;
    }
    const Budget budget(budgetMs);
    if (!fillOverview(budget)) {
        return false;
    }
    const Window around{m_window->tiling, m_window->origin - kTilePixels, m_window->size + 2 * kTilePixels};
    std::vector<glm::ivec2> places;
    forTiles(around, [&](Tile& tile, glm::ivec2 at, const TilePart&) {
        if (tile.pictureLook != m_look || tile.overLook != m_overLook || tile.paintedOver != tile.over ||
            !tile.painted.holds(TilePart{})) {
            places.push_back(at);
        }
    });
    for (const glm::ivec2& at : places) {
        if (bytes() + board().model().layers.size() * sizeof(MaskTile) + 3 * sizeof(PixelTile) > m_maxBytes) {
            return true;
        }
        const Window one{m_window->tiling, at * kTilePixels, glm::ivec2(kTilePixels)};
        const Filled filled = fill(one, budget);
        if (!filled.isWhole || filled.isEnough || !fillOver(one, budget, true)) {
            return false;
        }
        forTiles(one, [&](Tile& tile, glm::ivec2, const TilePart& part) { bringUpToDate(tile, part); });
        if (budget.isSpent()) {
            return false;
        }
    }
    makeRoomForOver();
    return true;
}

/// What is highlighted next needs memory for each tile, which takes longer to get than to fill.
void FlatPicture::makeRoomForOver() {
    std::uint64_t left = m_maxBytes - std::min(bytes(), m_maxBytes);
    forTiles(*m_window, [&](Tile& tile, glm::ivec2, const TilePart&) {
        constexpr std::uint64_t kBytes = sizeof(OverWork) + sizeof(PixelTile);
        if (tile.work == nullptr && left > kBytes) {
            tile.work = std::make_unique<OverWork>();
            left -= kBytes;
        }
    });
}

bool FlatPicture::isLastUsable() const {
    return m_last.look == m_look && m_last.overLook == m_overLook &&
           glm::sign(m_last.map.scale) == glm::sign(m_window->tiling.scale);
}

void FlatPicture::paintWhole() {
    const Window& window = *m_window;
    m_settled = window.tiling.id;
    m_last.map = {window.tiling.scale, -window.tiling.phase - glm::dvec2(window.origin)};
    m_last.size = window.size;
    m_last.look = m_look;
    m_last.overLook = m_overLook;
    makeRoom(window.size, m_last.pixels);
    paint(window, nullptr, m_last.pixels->data());
    m_isLastShown = true;
}

void FlatPicture::paintRough(const Budget& budget) {
    const Window& window = *m_window;
    const bool isOverview = isLastUsable() ? isOverviewThere() : fillOverview(budget);
    const PlaneMap map{window.tiling.scale, -window.tiling.phase - glm::dvec2(window.origin)};
    m_isBare = !isOverview && !isLastUsable();
    const RoughSource overview{isOverview ? m_overview.pixels->data() : nullptr, m_overview.size, m_overview.map};
    const RoughSource last{isLastUsable() ? m_last.pixels->data() : nullptr, m_last.size, m_last.map};
    const RoughPicture behind(last, overview, m_colours->pixel(0), map, window.size);
    makeRoom(window.size, m_rough);
    paint(window, &behind, m_rough->data());
    m_isLastShown = false;
}

/// Nothing is there yet.
void FlatPicture::paintBackground(const FlatRequest& request, const glm::vec3& background) {
    m_window.reset();
    m_isBare = true;
    m_isLastShown = false;
    makeRoom({request.width, request.height}, m_rough);
    std::ranges::fill(*m_rough, SampleColours::make(background, {}, {})->pixel(SampleColours::kBackground));
}

void FlatPicture::evict() {
    std::uint64_t all = bytes();
    while (all > m_maxBytes) {
        const auto oldest =
            std::ranges::min_element(m_tiles, {}, [](const auto& entry) { return entry.second.lastUse; });
        if (oldest == m_tiles.end() || oldest->second.lastUse == m_use) {
            return;
        }
        all -= bytesOf(oldest->second);
        m_tiles.erase(oldest);
    }
}

std::uint64_t FlatPicture::bytesOf(const Tile& tile) {
    const auto masks = std::ranges::count_if(tile.masks, [](const auto& mask) { return mask != nullptr; });
    const std::size_t overs = (tile.over ? 1U : 0U) + (tile.paintedOver && tile.paintedOver != tile.over ? 1U : 0U);
    return static_cast<std::uint64_t>(masks) * sizeof(MaskTile) +
           (overs + (tile.picture ? 2U : 0U)) * sizeof(PixelTile) +
           (tile.work ? sizeof(OverWork) + sizeof(PixelTile) : 0U);
}

std::uint64_t FlatPicture::bytes() const {
    std::uint64_t all = (m_last.pixels->size() + m_overview.pixels->size() + m_rough->size()) * sizeof(std::uint32_t);
    for (const auto& [key, tile] : m_tiles) {
        all += bytesOf(tile);
    }
    return all;
}

bool FlatPicture::refine(double budgetMs) {
    if (!m_window) {
        return true;
    }
    m_isResting = true;
    ++m_use;
    if (!m_isExact) {
        return true;
    }
    const Budget budget(budgetMs);
    if (m_isBare) {
        return fillOverview(budget);
    }
    const Filled filled = fill(*m_window, budget);
    if (!filled.isWhole || filled.isEnough || !fillOver(*m_window, budget, false)) {
        return false;
    }
    return !m_isOverShown || fillOver(*m_window, budget, true);
}

FlatPicture::Quality FlatPicture::draw(const FlatRequest& request, double budgetMs) {
    const FramePlan plan =
        planFrame(*request.layers, request.camera, request.settings, static_cast<std::uint32_t>(request.width),
                  static_cast<std::uint32_t>(request.height));
    const bool hasOutlines = (plan.data.flags & (shader::kFrameOutlines | shader::kFrameMono)) != 0;
    if (!isReadyWithin(budgetMs)) {
        paintBackground(request, plan.data.background);
        return Quality::Rough;
    }
    if (!board().isDrawable() || hasOutlines || !isLevel(plan) || std::ranges::any_of(plan.upright.states, isUneven) ||
        !setLook(request, plan)) {
        m_window.reset();
        return Quality::None;
    }
    ++m_use;
    m_window = windowOf(plan, request);
    // A hand that zooms goes on to the next scale: tiles of this one would be drawn for nothing.
    const bool isPassing = budgetMs > 0.0 && !m_isResting && m_window->tiling.id != m_settled && isLastUsable();
    m_isResting = false;
    const Budget budget(budgetMs);
    m_isBare = false;
    // Where nothing is there at all, all of the board in small comes first.
    const bool isFirst = budgetMs > 0.0 && !isLastUsable() && !isOverviewThere() && isEmpty(*m_window);
    const bool isWhole = isPassing || isFirst ? isFilled(*m_window) : fill(*m_window, budget).isWhole;
    m_isOverShown = isWhole && fillOver(*m_window, budget, false);
    // What only now stands out is shown first, its dark edge with a later frame.
    const bool isNew = budgetMs > 0.0 && std::exchange(m_edgedLook, m_overLook) != m_overLook && !m_standing.empty();
    const bool isOutlined = m_isOverShown && !isNew && fillOver(*m_window, budget, true);
    if (isWhole) {
        paintWhole();
    } else {
        paintRough(budget);
    }
    evict();
    if (bytes() > m_maxBytes) {
        clearTiles();
        m_window.reset();
        return Quality::None;
    }
    return isOutlined && m_isExact ? Quality::Exact : Quality::Rough;
}

}  // namespace render
