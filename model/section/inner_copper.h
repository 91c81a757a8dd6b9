#pragma once

#include <map>
#include <utility>
#include <vector>

#include "model/section/intervals.h"
#include "model/section/section_piece.h"

namespace model {

/// Copper that lies among the dielectrics of a board. A dielectric fills the space beside it (dielectricBandsOf), and
/// ends where copper begins: no two of them have the same height at one location.
class InnerCopper {
public:
    /// All level copper of these pieces; heights are those of its layers.
    explicit InnerCopper(const std::vector<SectionPiece>& pieces);

    /// What copper leaves of a level piece of a dielectric: beside copper over all of its height, else above and below.
    [[nodiscard]] std::vector<SectionPiece> leftOf(const SectionPiece& dielectric) const;

private:
    std::map<std::pair<Nm, Nm>, Intervals> m_byHeight;  ///< bottom and top
};

}  // namespace model
