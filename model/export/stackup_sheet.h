#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "model/base/length_writer.h"
#include "model/board/document.h"

/// The stackup as one sheet of rectangles, lines and texts: drawing, table, totals, holes and findings. Everything that
/// writes it (SVG here, PDF in the window) writes the same. Pixels of 1/96 inch, y down.
namespace model {

enum class SheetAlign : std::uint8_t { Left, Middle, Right };

struct SheetRect {
    double x = 0.0;
    double y = 0.0;
    double width = 0.0;
    double height = 0.0;
    std::uint32_t fill = 0xffffff;  ///< 0xRRGGBB
    std::uint32_t edge = 0x000000;
    double edgeWidth = 0.5;
};

/// From the right edge of a layer to its label: straight on, to the label's height, straight on.
struct SheetLeader {
    double x0 = 0.0;
    double y0 = 0.0;
    double x1 = 0.0;
    double y1 = 0.0;
};

struct SheetText {
    double x = 0.0;
    double y = 0.0;  ///< of the line that letters stand on
    std::string text;
    SheetAlign align = SheetAlign::Left;
    bool isBold = false;
    bool isItalic = false;  ///< assumed values
};

struct StackupSheet {
    double width = 0.0;
    double height = 0.0;
    double fontSize = 12.0;
    std::vector<SheetRect> rects;  ///< later ones lie on earlier ones
    std::vector<SheetLeader> leaders;
    std::vector<SheetText> texts;
};

/// An empty sheet for boards without a stackup. `write` says lengths.
[[nodiscard]] StackupSheet stackupSheet(const Document& document, bool isExaggerated, const LengthWriter& write = {});

}  // namespace model
