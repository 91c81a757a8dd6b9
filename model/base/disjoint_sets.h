#pragma once

#include <algorithm>
#include <cstdint>
#include <numeric>
#include <vector>

namespace model {

/// Union-find over rows 0 .. size - 1. A set is named after its smallest row, so names do not depend on the order of
/// the joins.
class DisjointSets {
public:
    explicit DisjointSets(std::size_t size) : m_parent(size) { std::iota(m_parent.begin(), m_parent.end(), 0U); }

    [[nodiscard]] std::uint32_t find(std::uint32_t row) {
        while (m_parent[row] != row) {
            m_parent[row] = m_parent[m_parent[row]];
            row = m_parent[row];
        }
        return row;
    }
    void join(std::uint32_t a, std::uint32_t b) {
        const auto [small, large] = std::minmax({find(a), find(b)});
        m_parent[large] = small;
    }

private:
    std::vector<std::uint32_t> m_parent;
};

}  // namespace model
