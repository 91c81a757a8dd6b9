#pragma once

#include <functional>
#include <optional>
#include <string>

#include "tests/reference/raster.h"

namespace reference {

/// A symbol as a question: is this point (mm, from the symbol's middle) inside?
struct Symbol {
    std::function<bool(Point)> isInside;
    double reach = 0.0;     ///< no inside point is further from the middle
    double penWidth = 0.0;  ///< of round symbols: they can draw strokes
};

/// A standard symbol from its name; `unit` is a thousandth of the file's unit in mm. Nothing for other names.
[[nodiscard]] std::optional<Symbol> standardSymbol(const std::string& name, double unit);

}  // namespace reference
