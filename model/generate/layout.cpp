#include "model/generate/layout.h"

#include <algorithm>
#include <cmath>

#include "model/base/units.h"
#include "model/generate/block_maker.h"

namespace model::generate {

namespace {

constexpr PaperModel kModels[] = {
    {"t1", {539, 0, 1395, 529, 823}, 3},           {"t2", {347, 132, 2457, 1126, 2964}, 3},
    {"t3", {1455, 0, 14583, 1334, 2814}, 17},      {"t4", {1057, 0, 22505, 3140, 3740}, 26},
    {"t5", {2401, 86, 33122, 2693, 5919}, 28},     {"t6", {7107, 332, 44168, 6542, 12601}, 25},
    {"t7", {10801, 580, 92936, 3105, 6438}, 78},   {"t8", {28900, 0, 291660, 26680, 56280}, 15},
    {"t9", {57800, 0, 583320, 53360, 112560}, 15},
};

constexpr std::int32_t kMarginUm = 2000;
constexpr std::int32_t kPlaneInsetUm = 50;
constexpr std::uint64_t kTileColumns = 8;  // blocks below one plane: 64 × 64 mm
constexpr std::uint64_t kTileRows = 16;
constexpr double kAspect = 4.0 / 3.0;

constexpr std::uint64_t ceilDiv(std::uint64_t a, std::uint64_t b) {
    return (a + b - 1) / b;
}

enum Kind : std::size_t { kLine, kArc, kCircle, kTrail, kArea };

/// As few blocks as hold all elements (BlockMaker's capacities).
std::uint64_t blocksFor(const Counts& counts) {
    return std::max({std::uint64_t{1}, ceilDiv(counts[kLine], BlockMaker::kMaxLines),
                     ceilDiv(counts[kArc], BlockMaker::kMaxArcs), ceilDiv(counts[kCircle], BlockMaker::kMaxCircles),
                     ceilDiv(counts[kTrail], BlockMaker::kMaxTrails), ceilDiv(counts[kArea], BlockMaker::kMaxPads)});
}

/// SplitMix64: a good number for each block, whatever the seed.
std::uint64_t mixed(std::uint64_t seed, std::uint64_t index) {
    std::uint64_t z = seed + (index + 1) * 0x9E3779B97F4A7C15U;
    z = (z ^ (z >> 30U)) * 0xBF58476D1CE4E5B9U;
    z = (z ^ (z >> 27U)) * 0x94D049BB133111EBU;
    return z ^ (z >> 31U);
}

}  // namespace

const PaperModel* findPaperModel(std::string_view name) {
    const auto found = std::ranges::find(kModels, name, &PaperModel::name);
    return found == std::end(kModels) ? nullptr : found;
}

Layout::Layout(const Wanted& wanted) : m_wanted(wanted), m_blocks(blocksFor(wanted.counts)) {
    const double area = static_cast<double>(m_blocks) * BlockMaker::kWidthUm * BlockMaker::kHeightUm;
    m_columns = std::max<std::uint64_t>(
        1, static_cast<std::uint64_t>(std::lround(std::sqrt(area * kAspect) / BlockMaker::kWidthUm)));
    m_rows = ceilDiv(m_blocks, m_columns);
    m_tileColumns = ceilDiv(m_columns, kTileColumns);
    const std::uint64_t tiles = m_tileColumns * ceilDiv(m_rows, kTileRows);
    // A tile has a plane on two layers; a board of hardly any areas has fewer.
    m_tilesWithPour = std::min(tiles, wanted.counts[kArea] / 2);
    m_pads = wanted.counts[kArea] - 2 * m_tilesWithPour;
}

std::uint64_t Layout::share(std::uint64_t total, std::uint64_t block) const {
    return total * (block + 1) / m_blocks - total * block / m_blocks;
}

PointUm Layout::cornerOf(std::uint64_t block) const {
    const auto column = static_cast<std::int32_t>(block % m_columns);
    const auto row = static_cast<std::int32_t>(block / m_columns);
    return {min().x + kMarginUm + column * BlockMaker::kWidthUm, min().y + kMarginUm + row * BlockMaker::kHeightUm};
}

Block Layout::block(std::uint64_t index) const {
    BlockShare share_;
    share_.lines = static_cast<int>(share(m_wanted.counts[kLine], index));
    share_.arcs = static_cast<int>(share(m_wanted.counts[kArc], index));
    share_.circles = static_cast<int>(share(m_wanted.counts[kCircle], index));
    share_.trails = static_cast<int>(share(m_wanted.counts[kTrail], index));
    share_.pads = static_cast<int>(share(m_pads, index));
    share_.tracksPerTrail = m_wanted.tracksPerTrail;
    share_.random = mixed(m_wanted.seed, index);
    return BlockMaker(cornerOf(index), share_).make();
}

Tile Layout::tile(std::uint64_t index) const {
    const std::uint64_t firstColumn = index % m_tileColumns * kTileColumns;
    const std::uint64_t firstRow = index / m_tileColumns * kTileRows;
    const std::uint64_t endColumn = std::min(firstColumn + kTileColumns, m_columns);
    const std::uint64_t endRow = std::min(firstRow + kTileRows, m_rows);
    Tile tile;
    const PointUm low = cornerOf(firstRow * m_columns + firstColumn);
    const PointUm high = cornerOf((endRow - 1) * m_columns + endColumn - 1);
    tile.min = {low.x + kPlaneInsetUm, low.y + kPlaneInsetUm};
    tile.max = {high.x + BlockMaker::kWidthUm - kPlaneInsetUm, high.y + BlockMaker::kHeightUm - kPlaneInsetUm};
    for (std::uint64_t row = firstRow; row < endRow; ++row) {
        for (std::uint64_t column = firstColumn; column < endColumn; ++column) {
            if (row * m_columns + column < m_blocks) {
                tile.blocks.push_back(row * m_columns + column);
            }
        }
    }
    return tile;
}

PointUm Layout::min() const {
    const PointUm high = max();
    return {-high.x, -high.y};
}

PointUm Layout::max() const {
    return {static_cast<std::int32_t>(m_columns) * BlockMaker::kWidthUm / 2 + kMarginUm,
            static_cast<std::int32_t>(m_rows) * BlockMaker::kHeightUm / 2 + kMarginUm};
}

bool Layout::fits() const {
    constexpr std::uint64_t kMost = base::kMaxCoordinate / 1000 - kMarginUm;
    return m_columns * BlockMaker::kWidthUm / 2 <= kMost && m_rows * BlockMaker::kHeightUm / 2 <= kMost;
}

}  // namespace model::generate
