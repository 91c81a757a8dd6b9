#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <vector>

/// The independent painter of the tests: areas by counting sample points. It shares no code with model/, so that what
/// both agree on is not a common mistake.
namespace reference {

/// Millimetres.
struct Point {
    double x = 0.0;
    double y = 0.0;
};
using Contour = std::vector<Point>;

/// A black and white picture of samples `pitch` mm apart. The rows are turned by an odd angle against the board, so
/// that no edge of a board runs along them: a sample is then inside or outside of a border by chance, and the error of
/// an area is about pitch^1.5 × √(border / 12), for 20 m of border and 20 µm 0.1 mm².
class Raster {
public:
    /// Covers all points whose coordinates lie between the corners.
    Raster(Point low, Point high, double pitch);

    enum class Rule : std::uint8_t {
        Winding,  ///< a winding number above zero; contours wind counter-clockwise around what they fill, clockwise
                  ///< around holes
        EvenOdd   ///< inside an odd number of contours, however they wind
    };
    /// Sets (or clears) all samples that lie inside.
    void fill(const std::vector<Contour>& contours, bool value, Rule rule = Rule::Winding);
    /// Sets (or clears) all samples no further than `reach` from `middle` that are inside.
    void fill(Point middle, double reach, const std::function<bool(Point)>& isInside, bool value);

    /// In mm².
    [[nodiscard]] double area() const;
    /// Of the samples that differ.
    [[nodiscard]] double difference(const Raster& other) const;
    /// Of the samples that differ with all samples around them, up to `around` rows and columns away: what is narrower
    /// than 2 `around` + 1 samples does not count.
    [[nodiscard]] double differenceWider(const Raster& other, std::size_t around) const;

private:
    [[nodiscard]] Point rotated(Point p) const;
    [[nodiscard]] Point board(std::size_t row, std::size_t column) const;
    void set(std::size_t row, std::size_t from, std::size_t end, bool value);
    /// First row (or column) whose sample is at or behind `at`, within the picture.
    [[nodiscard]] std::size_t sampleFrom(double at, double origin, std::size_t count) const;

    double m_pitch;
    double m_left = 0.0;
    double m_bottom = 0.0;
    std::size_t m_columns = 0;
    std::size_t m_rows = 0;
    std::size_t m_words = 0;  ///< per row
    std::vector<std::uint64_t> m_bits;
};

/// Points of an arc from `from` to `to` around `centre` without the last one; equal ends are a full circle. The radius
/// runs evenly from that of one end to that of the other. Chords stay within 0.05 µm.
void appendArc(Contour& contour, Point from, Point to, Point centre, bool isClockwise);
[[nodiscard]] Contour circle(Point centre, double radius);
/// Turned to wind counter-clockwise, or clockwise for a hole.
[[nodiscard]] Contour wound(Contour contour, bool isHole);

/// What a round pen covers: one contour per piece, each counter-clockwise, to be filled together.
[[nodiscard]] std::vector<Contour> lineTrack(Point a, Point b, double width);
[[nodiscard]] std::vector<Contour> arcTrack(Point from, Point to, Point centre, bool isClockwise, double width);

}  // namespace reference
