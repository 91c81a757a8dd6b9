#include "tri/insertion_order.h"

#include <algorithm>
#include <array>
#include <bit>
#include <utility>

#include "model/base/radix_sort.h"

namespace tri {

namespace {

/// Hilbert curve, four bits of x and y at a time. The curve enters a square in one of four ways (states); in each it
/// visits the quadrants in its own order and enters them in its own ways.
struct Step {
    std::uint8_t index;  // where along the curve, 0..255
    std::uint8_t state;  // how the curve runs inside
};

constexpr Step hilbertStep(std::uint32_t state, std::uint32_t x, std::uint32_t y) {
    // State bit 0: x and y are exchanged; bit 1: both are mirrored.
    std::uint32_t index = 0;
    for (int bit = 3; bit >= 0; --bit) {
        std::uint32_t qx = (x >> bit & 1) ^ (state >> 1);
        std::uint32_t qy = (y >> bit & 1) ^ (state >> 1);
        if ((state & 1) != 0) {
            std::swap(qx, qy);
        }
        index = index << 2 | (qx != 0 ? (qy != 0 ? 2U : 3U) : qy);
        if (qy == 0) {
            state ^= qx != 0 ? 3U : 1U;
        }
    }
    return {static_cast<std::uint8_t>(index), static_cast<std::uint8_t>(state)};
}

constexpr std::array<Step, 1024> kHilbert = [] {
    std::array<Step, 1024> table{};
    for (std::uint32_t i = 0; i < 1024; ++i) {
        table[i] = hilbertStep(i >> 8, i >> 4 & 15, i & 15);
    }
    return table;
}();

constexpr std::uint32_t hilbertKey(std::uint32_t x, std::uint32_t y) {
    std::uint32_t key = 0;
    std::uint32_t state = 0;
    for (int shift = 12; shift >= 0; shift -= 4) {
        const Step step = kHilbert[state << 8 | (x >> shift & 15) << 4 | (y >> shift & 15)];
        key = key << 8 | step.index;
        state = step.state;
    }
    return key;
}

static_assert(hilbertKey(0, 0) == 0 && hilbertKey(65535, 0) == 0xFFFFFFFF, "from corner to corner of one side");

/// How many rounds before the last a point goes in: level k with probability 7/8 * 8^-k.
std::uint32_t levelOf(std::uint32_t index) {
    std::uint32_t hash = index * 0x9E3779B1U;
    hash = (hash ^ hash >> 15) * 0x85EBCA77U;
    hash ^= hash >> 13;
    return std::min(static_cast<std::uint32_t>(std::countr_zero(hash | 1U << 31)) / 3, kRounds - 1);
}

/// Key in the upper, index in the lower half: sorting by the whole word is stable.
void writeKeys(std::span<const Point> points, Cores cores, std::uint64_t* keys) {
    base::Box box;
    for (const Point& p : points) {
        box.include(p);
    }
    const HilbertGrid grid(box);
    const std::uint64_t pieces = piecesFor(cores);
    forEach(cores, pieces, [&](std::size_t piece) {
        const std::size_t end = points.size() * (piece + 1) / pieces;
        for (std::size_t i = points.size() * piece / pieces; i < end; ++i) {
            keys[i] = std::uint64_t{grid.keyOf(points[i])} << 32 | i;
        }
    });
}

/// Equal positions have equal keys. Sorts every run of equal keys by position and index, and drops repeats of a
/// position: `vertexOf` of a repeat becomes the *index* of the first. Returns how many are left.
std::size_t mergeEqual(std::span<const Point> points, std::uint64_t* keys, std::uint32_t* vertexOf,
                       std::vector<std::uint32_t>& mergedIndices) {
    const auto byPosition = [&](std::uint64_t a, std::uint64_t b) {
        const auto i = static_cast<std::uint32_t>(a);
        const auto j = static_cast<std::uint32_t>(b);
        return std::pair(points[i], i) < std::pair(points[j], j);
    };
    std::size_t kept = 0;
    for (std::size_t i = 0; i < points.size();) {
        std::size_t end = i + 1;
        while (end < points.size() && keys[end] >> 32 == keys[i] >> 32) {
            ++end;
        }
        if (end - i > 1) {
            std::sort(keys + i, keys + end, byPosition);
        }
        std::uint32_t first = static_cast<std::uint32_t>(keys[i]);
        keys[kept++] = keys[i];
        for (++i; i < end; ++i) {
            const auto index = static_cast<std::uint32_t>(keys[i]);
            if (points[index] == points[first]) {
                vertexOf[index] = first;
                mergedIndices.push_back(index);
            } else {
                first = index;
                keys[kept++] = keys[i];
            }
        }
    }
    return kept;
}

}  // namespace

HilbertGrid::HilbertGrid(const base::Box& box)
    : m_box(box),
      // 16 bits per axis: offset * factor < 2^48 for every offset up to the extent.
      m_factor((std::uint64_t{1} << 48) / (static_cast<std::uint64_t>(std::max(box.width(), box.height())) + 1)) {}

std::uint32_t HilbertGrid::keyOf(Point p) const {
    const auto cell = [&](base::Nm at, base::Nm low, base::Nm high) {
        const std::int64_t offset = std::int64_t{std::clamp(at, low, high)} - low;
        return static_cast<std::uint32_t>(static_cast<std::uint64_t>(offset) * m_factor >> 32);
    };
    return hilbertKey(cell(p.x, m_box.min.x, m_box.max.x), cell(p.y, m_box.min.y, m_box.max.y));
}

VertexOrder orderVertices(std::span<const Point> points, Cores cores, Mesh& mesh, std::uint32_t* vertexOf) {
    // There are no triangles yet: sort in their place (16 of their 48 bytes per vertex).
    static_assert(2 * sizeof(Triangle) >= 2 * sizeof(std::uint64_t) && alignof(Triangle) <= alignof(std::max_align_t));
    auto* keys = reinterpret_cast<std::uint64_t*>(mesh.triangles.data());
    writeKeys(points, cores, keys);
    keys = base::sortByKey(keys, keys + points.size(), points.size());
    VertexOrder order;
    std::vector<std::uint32_t>& merged = order.merged;
    const std::size_t count = mergeEqual(points, keys, vertexOf, merged);

    std::array<std::uint32_t, kRounds> slot{};
    for (std::size_t i = 0; i < count; ++i) {
        ++slot[kRounds - 1 - levelOf(static_cast<std::uint32_t>(keys[i]))];
    }
    std::uint32_t sum = 0;
    for (std::uint32_t round = 0; round < kRounds; ++round) {
        order.roundStart[round] = sum;
        sum += std::exchange(slot[round], sum);
    }
    order.roundStart[kRounds] = sum;
    for (std::size_t i = 0; i < count; ++i) {
        const auto index = static_cast<std::uint32_t>(keys[i]);
        const std::uint32_t vertex = slot[kRounds - 1 - levelOf(index)]++;
        mesh.points[vertex] = points[index];
        mesh.ids[vertex] = index;
        vertexOf[index] = vertex;
    }
    mesh.vertexCount = static_cast<std::uint32_t>(count);
    for (std::uint32_t& index : merged) {
        vertexOf[index] = vertexOf[vertexOf[index]];
        index = vertexOf[index];
    }
    std::ranges::sort(merged);
    merged.erase(std::unique(merged.begin(), merged.end()), merged.end());
    return order;
}

}  // namespace tri
