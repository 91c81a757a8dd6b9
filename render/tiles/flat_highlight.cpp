// What stands out in a FlatPicture, and in its tiles: as it is, then with its dark edge.
#include <algorithm>
#include <array>
#include <cstring>
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

/// What is moved to so many sides at once, as nothing interrupts a step.
constexpr std::size_t kSidesPerStep = 4;
constexpr std::size_t kStepsPerDistance = std::size(kSides) / kSidesPerStep;

std::array<glm::dvec2, kSidesPerStep> movesOf(std::span<const double> distances, std::size_t step) {
    std::array<glm::dvec2, kSidesPerStep> moves;
    const auto sides = std::span(kSides).subspan(step % kStepsPerDistance * kSidesPerStep, kSidesPerStep);
    std::ranges::transform(sides, moves.begin(),
                           [&](const glm::dvec2& side) { return distances[step / kStepsPerDistance] * side; });
    return moves;
}

/// How often each step is drawn, the board itself first.
std::vector<std::size_t> copiesOfSteps(const BoardModel& board) {
    std::vector<std::size_t> counts(board.steps.size() + 1);
    for (const ModelCopy& copy : board.copies) {
        ++counts[copy.step];
    }
    return counts;
}

/// By state how many elements are in it, each as often as `copies` says of its list. Most follow many in the same
/// state: eight are looked at together.
std::array<std::size_t, 256> countStates(std::span<const std::vector<ElementState>> lists,
                                         std::span<const std::size_t> copies) {
    std::array<std::size_t, 256> counts{};
    for (std::size_t row = 0; row < lists.size(); ++row) {
        const std::vector<ElementState>& list = lists[row];
        for (std::size_t from = 0; from < list.size();) {
            std::array<ElementState, 8> eight{};
            eight.fill(list[from]);
            std::size_t to = from + 1;
            while (to + eight.size() <= list.size() && std::memcmp(&list[to], eight.data(), sizeof(eight)) == 0) {
                to += eight.size();
            }
            while (to < list.size() && list[to] == list[from]) {
                ++to;
            }
            counts[list[from]] += copies[row] * (to - from);
            from = to;
        }
    }
    return counts;
}

}  // namespace

/// Hidden elements are left out of tiles, what stands out lies over them.
void FlatPicture::setStates(std::span<const std::vector<ElementState>> states) {
    if (std::ranges::equal(states, m_states)) {
        return;
    }
    m_states.assign(states.begin(), states.end());
    const std::array<std::size_t, 256> counts = countStates(m_states, copiesOfSteps(board().model()));
    const bool wasAnyHidden = m_isAnyHidden;
    m_isAnyHidden = false;
    m_standingOut = 0;
    m_standing.clear();
    for (std::size_t row = 0; row < counts.size(); ++row) {
        const auto state = static_cast<ElementState>(row);
        const bool isHidden = (state & kHidden) != 0;
        m_isAnyHidden = m_isAnyHidden || (isHidden && counts[row] > 0);
        if (counts[row] > 0 && standsOut(state)) {
            m_standingOut += counts[row];
            if (!isHidden) {
                m_standing.push_back(state);
            }
        }
    }
    if (wasAnyHidden || m_isAnyHidden) {
        clearTiles();
    }
    ++m_overLook;
}

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

/// A step of the dark edge, or of what is widened over it: one of its layers, moved to some of the eight sides.
void FlatPicture::outlineOver(Tile& tile, const PlaneMap& map) const {
    constexpr std::size_t kEdgeSteps = std::size(kOutlinePx) * kStepsPerDistance;
    constexpr std::size_t kWideSteps = std::size(kWidenPx) * kStepsPerDistance;
    OverWork& work = workOn(tile);
    work.isUsed = true;
    const auto draw = [&](const OverPaint& paint, std::span<const glm::dvec2> moves) {
        (void)board().drawStandingOut(paint.layer, map, {m_isFabricated, m_states}, paint.state, moves, work.mask);
    };
    const std::size_t edge = kEdgeSteps * tile.overRows.size();
    const std::size_t step = work.step++;
    if (step < edge) {
        if (const OverPaint& paint = m_over[tile.overRows[step / kEdgeSteps]]; !paint.isBore) {
            draw(paint, movesOf(kOutlinePx, step % kEdgeSteps));
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
    draw(paint, movesOf(kWidenPx, own % kWideSteps));
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
