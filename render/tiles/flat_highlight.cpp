// What stands out in a tile of a FlatPicture: as it is, then with its dark edge.
#include <algorithm>
#include <array>
#include <utility>

#include "render/tiles/flat_picture.h"

namespace render {

namespace {

// As in highlight_pass.cpp.
constexpr double kOutlinePx[] = {1.4, 1.8};
constexpr double kWidenPx[] = {0.4, 0.8};
constexpr std::size_t kMostOutlined = 2'000;
constexpr glm::dvec2 kSides[] = {{-1, -1}, {0, -1}, {1, -1}, {-1, 0}, {1, 0}, {-1, 1}, {0, 1}, {1, 1}};
constexpr std::uint8_t kSilhouetteByte = 1;

std::array<glm::dvec2, std::size(kSides)> movesTo(double distance) {
    std::array<glm::dvec2, std::size(kSides)> moves;
    std::ranges::transform(kSides, moves.begin(), [&](const glm::dvec2& side) { return distance * side; });
    return moves;
}

}  // namespace

/// Begun anew when other things stand out, in the same memory.
FlatPicture::OverWork& FlatPicture::workOn(Tile& tile) const {
    if (tile.work == nullptr) {
        tile.work = std::make_unique<OverWork>();
        tile.work->look = m_overLook;
    }
    if (OverWork& work = *tile.work; work.look != m_overLook) {
        work.look = m_overLook;
        work.step = 0;
        if (std::exchange(work.isUsed, false)) {
            work.mask.fill(0);
            work.samples->fill(0);
        }
    }
    return *tile.work;
}

/// A step of it as it is, without its dark edge: one of its paints.
void FlatPicture::drawOver(Tile& tile, const PlaneMap& map) const {
    constexpr std::array<glm::dvec2, 1> kUnmoved{{{0.0, 0.0}}};
    OverWork& work = workOn(tile);
    if (work.step == 0) {
        tile.overRows.clear();
    }
    if (work.step < m_over.size()) {
        const auto row = static_cast<std::uint32_t>(work.step++);
        const OverPaint& paint = m_over[row];
        if (board().drawStandingOut(paint.layer, map, {m_isFabricated, m_states}, paint.state, kUnmoved, work.mask)) {
            work.isUsed = true;
            tile.overRows.push_back(row);
            stamp(work.mask, paint.isBore, paint.byte, *work.samples);
            work.mask.fill(0);
        }
    }
    if (work.step == m_over.size()) {
        takeOver(tile);
    }
}

void FlatPicture::takeOver(Tile& tile) const {
    tile.overLook = m_overLook;
    if (tile.overRows.empty()) {
        tile.over.reset();  // what it was drawn in serves the next ones
    } else {
        tile.over = std::move(tile.work->samples);
        tile.work.reset();
    }
    tile.isOutlined = tile.overRows.empty() || m_standingOut > kMostOutlined;
}

/// A step of the dark edge, or of what is widened over it: one of its layers, moved to the eight sides.
void FlatPicture::outlineOver(Tile& tile, const PlaneMap& map) const {
    constexpr std::size_t kEdgeSteps = std::size(kOutlinePx);
    constexpr std::size_t kWideSteps = std::size(kWidenPx);
    OverWork& work = workOn(tile);
    work.isUsed = true;
    const auto draw = [&](const OverPaint& paint, std::span<const glm::dvec2> moves) {
        (void)board().drawStandingOut(paint.layer, map, {m_isFabricated, m_states}, paint.state, moves, work.mask);
    };
    const std::size_t edge = kEdgeSteps * tile.overRows.size();
    const std::size_t step = work.step++;
    if (step < edge) {
        if (const OverPaint& paint = m_over[tile.overRows[step / kEdgeSteps]]; !paint.isBore) {
            draw(paint, movesTo(kOutlinePx[step % kEdgeSteps]));
        }
        if (work.step == edge) {
            stamp(work.mask, false, kSilhouetteByte, *work.samples);
            stamp(work.mask, true, kSilhouetteByte, *work.samples);
            work.mask.fill(0);
        }
        return;
    }
    const std::size_t own = step - edge;
    const OverPaint& paint = m_over[tile.overRows[own / kWideSteps]];
    if (own % kWideSteps == 0) {
        draw(paint, std::array<glm::dvec2, 1>{});
    }
    draw(paint, movesTo(kWidenPx[own % kWideSteps]));
    if (own % kWideSteps == kWideSteps - 1) {
        stamp(work.mask, paint.isBore, paint.byte, *work.samples);
        work.mask.fill(0);
    }
    if (own + 1 == kWideSteps * tile.overRows.size()) {
        tile.over = std::move(work.samples);
        tile.work.reset();
        tile.isOutlined = true;
    }
}

}  // namespace render
