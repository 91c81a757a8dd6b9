#pragma once

#include <cstdint>
#include <memory>

#include "model/geometry/nurbs.h"

namespace model {

/// The NURBS curves that edges of shapes are, in flat rows that a PathNode names by their number. Copies share them
/// until a curve is added to one; a table without curves takes no memory.
class CurveTable {
public:
    /// Returns the curve's row. Not for curves of this very table.
    std::uint32_t add(const NurbsView& curve);
    /// Good until a curve is added.
    [[nodiscard]] NurbsView operator[](std::uint32_t row) const;
    [[nodiscard]] std::size_t size() const { return m_rows ? m_rows->curves.size() : 0; }

private:
    struct Curve {
        int degree;
        std::uint32_t firstKnot;
        std::uint32_t firstControl;
        std::uint32_t controlCount;
    };
    struct Rows {
        std::vector<Curve> curves;
        std::vector<double> knots;
        std::vector<ControlPoint> controls;
    };
    std::shared_ptr<Rows> m_rows;  ///< null while there are none
};

}  // namespace model
