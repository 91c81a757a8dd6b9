#pragma once

#include <functional>
#include <limits>
#include <optional>

#include "model/figures/figures.h"

namespace model {

/// Largest spacing that counts as touching. Coordinates are whole nanometres, so two items that are apart are at least
/// 1 nm apart; less than half of that comes from rounding placed shapes and arcs.
inline constexpr double kTouchNm = 0.5;

/// The spacing between two figures of any kind; nothing if it is larger than `limit`. Items that touch or overlap have
/// a spacing of 0 at a location both cover. Figures may come from different tables.
[[nodiscard]] std::optional<Spacing> spacingBetween(const FigureTable& a, std::size_t rowA, const FigureTable& b,
                                                    std::size_t rowB,
                                                    double limit = std::numeric_limits<double>::infinity());

/// The spacing between the figures of two tables; nothing if one of them is empty or it is larger than `limit`.
[[nodiscard]] std::optional<Spacing> spacingBetween(const FigureTable& a, const FigureTable& b,
                                                    double limit = std::numeric_limits<double>::infinity());

/// Is the point inside of a filled figure? Never for tracks.
[[nodiscard]] bool isInside(const FigureTable& table, std::size_t row, PointD p);

/// The shortest line from a point to an edge of a figure, pen and inside left out of account; or any that is no longer
/// than `enough`.
[[nodiscard]] Spacing spacingToEdges(const FigureTable& table, std::size_t row, PointD p, double enough = 0.0);

/// Calls `visit` for the edges of a figure that may come into the box, and for some that lie beside it.
void visitEdges(const FigureTable& table, std::size_t row, const Box& box,
                const std::function<void(const Edge&)>& visit);

}  // namespace model
