#include "render/tiles/outline_scan.h"

#include <algorithm>

#include "render/tiles/sample_rows.h"

namespace render {

namespace {

constexpr std::size_t kRows = std::size_t{kRowsPerPixel} * kTilePixels;
constexpr std::size_t kFew = 64;  // are sorted at once

}  // namespace

void OutlineScan::edge(glm::dvec2 from, glm::dvec2 to) {
    const Corner a = Corner::near(from);
    const Corner b = Corner::near(to);
    const bool isDown = a.y < b.y;
    int row = firstRow(isDown ? a.y : b.y);
    const int end = firstRow(isDown ? b.y : a.y);
    if (row >= end) {
        return;
    }
    const SampleEdge edge = SampleEdge::between(a, b);
    const bool isIn = isDown != m_isMirrored;
    for (; row < end; ++row) {
        const int column = edge.column(heightOf(row), kSamplePlaces[static_cast<std::size_t>(row % kRowsPerPixel)].x);
        if (column < kTilePixels) {
            m_crossings.emplace_back(row, std::max(column, 0), isIn);
        }
    }
}

void OutlineScan::edgesOnTheLeft(glm::dvec2 first, glm::dvec2 last) {
    const Corner a = Corner::near(first);
    const Corner b = Corner::near(last);
    const bool isDown = a.y < b.y;
    const int row = firstRow(isDown ? a.y : b.y);
    const int end = firstRow(isDown ? b.y : a.y);
    if (row >= end) {
        return;
    }
    if (m_leftSteps.empty()) {
        m_leftSteps.assign(kRows + 1, 0);
    }
    const int step = isDown != m_isMirrored ? 1 : -1;
    m_leftSteps[static_cast<std::size_t>(row)] += step;
    m_leftSteps[static_cast<std::size_t>(end)] -= step;
}

void OutlineScan::fill() {
    sort();
    const bool hasLeft = !m_leftSteps.empty();
    int insideAtLeft = 0;
    std::size_t i = 0;
    const int end = hasLeft ? static_cast<int>(kRows) : m_crossings.empty() ? 0 : m_crossings.back().row() + 1;
    for (int row = hasLeft || m_crossings.empty() ? 0 : m_crossings.front().row(); row < end; ++row) {
        insideAtLeft += hasLeft ? m_leftSteps[static_cast<std::size_t>(row)] : 0;
        const std::size_t first = i;
        while (i < m_crossings.size() && m_crossings[i].row() == row) {
            ++i;
        }
        fillRow(row, insideAtLeft, std::span(m_crossings).subspan(first, i - first));
    }
    m_crossings.clear();
    m_leftSteps.clear();
}

/// Many are dealt out to their rows first.
void OutlineScan::sort() {
    if (m_crossings.size() <= kFew) {
        std::ranges::sort(m_crossings);
        return;
    }
    m_endOfRow.assign(kRows + 1, 0);
    for (const Crossing& crossing : m_crossings) {
        ++m_endOfRow[static_cast<std::size_t>(crossing.row()) + 1];
    }
    for (std::size_t row = 0; row < kRows; ++row) {
        m_endOfRow[row + 1] += m_endOfRow[row];
    }
    m_sorted.resize(m_crossings.size());
    for (const Crossing& crossing : m_crossings) {
        m_sorted[m_endOfRow[static_cast<std::size_t>(crossing.row())]++] = crossing;
    }
    std::uint32_t from = 0;
    for (std::size_t row = 0; row < kRows; ++row) {
        std::sort(m_sorted.begin() + from, m_sorted.begin() + m_endOfRow[row]);
        from = m_endOfRow[row];
    }
    std::swap(m_crossings, m_sorted);
}

void OutlineScan::fillRow(int row, int insideAtLeft, std::span<const Crossing> crossings) {
    const auto sample = static_cast<std::size_t>(row % kRowsPerPixel);
    int inside = insideAtLeft;  // so many lines wind around it
    int from = 0;
    const auto cover = [&](int to) { coverSamples(*m_tile, row / kRowsPerPixel, sample, {from, to}); };
    for (const Crossing& crossing : crossings) {
        const bool wasInside = inside > 0;
        inside += crossing.isIn() ? 1 : -1;
        if (wasInside && inside <= 0) {
            cover(crossing.column());
        } else if (!wasInside && inside > 0) {
            from = crossing.column();
        }
    }
    if (inside > 0) {
        cover(kTilePixels);
    }
}

}  // namespace render
