#pragma once

#include <array>
#include <cstddef>
#include <vector>

namespace model {

/// Rows for the length of one calculation: in place up to `kFixed` of them, in memory of its own above. They start
/// undefined.
template <class Row, std::size_t kFixed>
class Scratch {
public:
    explicit Scratch(std::size_t count) {
        if (count > kFixed) {
            m_more.resize(count);
            m_rows = m_more.data();
        } else {
            m_rows = m_fixed.data();
        }
    }
    Scratch(const Scratch&) = delete;
    Scratch& operator=(const Scratch&) = delete;

    [[nodiscard]] Row& operator[](std::size_t row) { return m_rows[row]; }

private:
    std::array<Row, kFixed> m_fixed;
    std::vector<Row> m_more;
    Row* m_rows;
};

}  // namespace model
