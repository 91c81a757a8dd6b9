#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "model/base/point.h"
#include "model/formats/kicad/text/tree.h"

namespace model::kicad {

/// Numbers as KiCad writes them, whatever the locale. None for what is no number.
[[nodiscard]] std::optional<double> numberOf(std::string_view word);
/// Millimetres as nanometres, rounded to the grid. None for what is no number or beyond a kilometre.
[[nodiscard]] std::optional<double> lengthOf(std::string_view word);

/// The first value of a list by its head, (width 0.1); the other value where it is not there.
[[nodiscard]] double length(const Item& list, std::string_view head, double otherwise = 0.0);
[[nodiscard]] double number(const Item& list, std::string_view head, double otherwise = 0.0);
/// The two values behind the head of a list as a point of the board: nanometres, y turned up.
[[nodiscard]] std::optional<base::PointD> pointOf(const Item& list);
/// The same of a list inside, (start 1 2).
[[nodiscard]] std::optional<base::PointD> point(const Item& list, std::string_view head);
/// (size 1 2): both positive as written. One value counts for both.
[[nodiscard]] std::optional<base::PointD> size(const Item& list, std::string_view head);

/// {slash}, {brace} … of names.
[[nodiscard]] std::string nameOf(std::string_view escaped);

}  // namespace model::kicad
