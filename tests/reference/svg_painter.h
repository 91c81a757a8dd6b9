#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "tests/reference/raster.h"

namespace reference {

/// A picture of one colour on white, as programs that draw with cairo write it in SVG: paths that are filled or stroked
/// with round or butt ends, and groups that are used once. White takes away what lies under it. In millimetres, y up,
/// the picture's upper left corner at 0, 0; a pixel is 1/72 inch.
class SvgPicture {
public:
    /// Text that is no such picture leaves words in `unknown`.
    explicit SvgPicture(std::string_view svg);

    /// Paints all shapes in their order, shifted.
    void paint(Raster& raster, Point shift) const;
    /// The corners of what is drawn dark, covered or not; low above high if there is nothing.
    [[nodiscard]] std::pair<Point, Point> corners() const;
    /// Elements and values that are not understood.
    [[nodiscard]] const std::vector<std::string>& unknown() const { return m_unknown; }

private:
    struct Shape {
        std::vector<Contour> contours;
        bool isDark = true;
        Raster::Rule rule = Raster::Rule::EvenOdd;
    };
    class Reader;

    std::vector<Shape> m_shapes;
    std::vector<std::string> m_unknown;
};

}  // namespace reference
