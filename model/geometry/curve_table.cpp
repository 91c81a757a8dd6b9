#include "model/geometry/curve_table.h"

#include "model/base/assert.h"

namespace model {

std::uint32_t CurveTable::add(const NurbsView& curve) {
    if (!m_rows || m_rows.use_count() > 1) {
        m_rows = m_rows ? std::make_shared<Rows>(*m_rows) : std::make_shared<Rows>();
    }
    m_rows->curves.push_back({curve.degree, static_cast<std::uint32_t>(m_rows->knots.size()),
                              static_cast<std::uint32_t>(m_rows->controls.size()),
                              static_cast<std::uint32_t>(curve.controls.size())});
    m_rows->knots.insert(m_rows->knots.end(), curve.knots.begin(), curve.knots.end());
    m_rows->controls.insert(m_rows->controls.end(), curve.controls.begin(), curve.controls.end());
    return static_cast<std::uint32_t>(m_rows->curves.size() - 1);
}

NurbsView CurveTable::operator[](std::uint32_t row) const {
    ASSERT(row < size());
    const Curve& curve = m_rows->curves[row];
    const std::size_t knotCount = curve.controlCount + static_cast<std::size_t>(curve.degree) + 1;
    return {curve.degree, std::span(m_rows->knots).subspan(curve.firstKnot, knotCount),
            std::span(m_rows->controls).subspan(curve.firstControl, curve.controlCount)};
}

}  // namespace model
