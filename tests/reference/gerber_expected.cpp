#include "tests/reference/gerber_expected.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

namespace reference {

namespace {

/// Where an aperture is flashed: scaled, mirrored, then rotated about its origin (paragraph 4.9.1).
struct Flash {
    double x = 0.0;
    double y = 0.0;
    double degrees = 0.0;  ///< counter-clockwise
    bool isMirroredX = false;
    bool isMirroredY = false;
    double scale = 1.0;

    [[nodiscard]] Point apply(Point p) const {
        const Point seen{(isMirroredX ? -p.x : p.x) * scale, (isMirroredY ? -p.y : p.y) * scale};
        const double turn = degrees * std::numbers::pi / 180.0;
        return {x + seen.x * std::cos(turn) - seen.y * std::sin(turn),
                y + seen.x * std::sin(turn) + seen.y * std::cos(turn)};
    }
};

/// Draws the parts of an aperture where it is flashed.
class Pen {
public:
    Pen(Raster& raster, const Flash& flash) : m_raster(raster), m_flash(flash) {}

    void polygon(const Contour& corners, bool isDark = true) const {
        Contour placed;
        for (const Point corner : corners) {
            placed.push_back(m_flash.apply(corner));
        }
        m_raster.fill({wound(placed, false)}, isDark);
    }
    void box(double left, double bottom, double right, double top, bool isDark = true) const {
        polygon({{left, bottom}, {right, bottom}, {right, top}, {left, top}}, isDark);
    }
    void disc(double x, double y, double diameter, bool isDark = true) const {
        m_raster.fill({circle(m_flash.apply({x, y}), diameter / 2 * m_flash.scale)}, isDark);
    }
    void line(Point a, Point b, double width) const {
        m_raster.fill(lineTrack(m_flash.apply(a), m_flash.apply(b), width * m_flash.scale), true);
    }
    void lines(const std::vector<Point>& corners, double width) const {
        for (std::size_t i = 0; i + 1 < corners.size(); ++i) {
            line(corners[i], corners[i + 1], width);
        }
    }
    void triangle(double diameter) const {
        Contour corners;
        for (const double degrees : {0.0, 120.0, 240.0}) {
            const double angle = degrees * std::numbers::pi / 180.0;
            corners.push_back({diameter / 2 * std::cos(angle), diameter / 2 * std::sin(angle)});
        }
        polygon(corners);
    }

private:
    Raster& m_raster;
    Flash m_flash;
};

void rotations(Raster& raster) {
    const std::vector<double> bars = {0, 30, 45, 60, 90};
    const std::vector<double> triangles = {0, 30, 60, 90, 120};
    for (std::size_t i = 0; i < bars.size(); ++i) {
        const double x = 2.0 + 4.0 * static_cast<double>(i);
        Pen(raster, {x, 2, bars[i]}).box(-1, -0.3, 1, 0.3);
        Pen(raster, {x, 6, triangles[i]}).triangle(2);
    }
}

void scales(Raster& raster) {
    for (const Flash& flash : {Flash{2, 2, 0, false, false, 0.5}, Flash{5, 2, 0, false, false, 0.75}, Flash{8, 2},
                               Flash{12, 2, 0, false, false, 1.5}, Flash{17, 2, 0, false, false, 2}}) {
        Pen(raster, flash).disc(0, 0, 1);
    }
    for (const Flash& flash : {Flash{2, 6, 0, false, false, 0.5}, Flash{5.5, 6}, Flash{9.5, 6, 0, false, false, 1.5},
                               Flash{14.5, 6, 0, false, false, 2}}) {
        Pen(raster, flash).box(-0.75, -0.25, 0.75, 0.25);
    }
}

void mirrors(Raster& raster) {
    for (const Flash& flash :
         {Flash{2, 2}, Flash{6, 2, 0, true}, Flash{10, 2, 0, false, true}, Flash{14, 2, 0, true, true}}) {
        const Pen shape(raster, flash);
        shape.box(-0.4, -0.2, 0.8, 0.2);
        shape.box(-0.6, -0.2, -0.2, 1.0);
        Flash above = flash;
        above.y = 6;
        Pen(raster, above).triangle(2);
    }
}

/// Four blocks, the whole row twice.
void blocks(Raster& raster) {
    for (const double y : {3.0, 9.0}) {
        const Pen cross(raster, {3, y});
        cross.line({-1, 0}, {1, 0}, 0.5);
        cross.line({0, -1}, {0, 1}, 0.5);
        raster.fill(arcTrack({10, y}, {10, y}, {10.5, y}, false, 0.5), true);
        Pen(raster, {9, y}).disc(0, 0, 0.3);
        const Pen triangle(raster, {15, y});
        triangle.lines({{-1, -0.5}, {1, -0.5}, {0, 1}, {-1, -0.5}}, 0.5);
        triangle.disc(0, 0, 0.3);
        const Pen frame(raster, {21, y});
        frame.lines({{-1.5, -1}, {1.5, -1}, {1.5, 1}, {-1.5, 1}, {-1.5, -1}}, 0.3);
        frame.disc(-1.5, 0, 0.6);
        frame.disc(1.5, 0, 0.6);
    }
}

void placedBlocks(Raster& raster) {
    const Flash flashes[] = {{5, 5},
                             {15, 5, 0, true, false},
                             {25, 5, 0, false, true},
                             {35, 5, 0, true, true},
                             {5, 15, 45},
                             {15, 15, 90},
                             {25, 15, 180},
                             {35, 15, 270},
                             {5, 25, 0, false, false, 0.5},
                             {15, 25, 0, false, false, 1.5},
                             {25, 25, 0, false, false, 2},
                             {35, 25, 30, true, false, 1.25}};
    for (const Flash& flash : flashes) {
        const Pen arrow(raster, flash);
        arrow.line({-1.5, 0}, {1.5, 0}, 0.3);
        arrow.lines({{0, 0}, {0, 1.5}, {-0.3, 1}}, 0.3);
        arrow.line({0, 1.5}, {0.3, 1}, 0.3);
        arrow.disc(-1, -1, 0.5);
    }
}

/// Clear parts of a block take away what lies under it; here that are parts of the block only.
void polarityOfBlocks(Raster& raster) {
    for (const double y : {5.0, 15.0}) {
        const Pen ring(raster, {5, y});
        ring.disc(0, 0, 2);
        ring.disc(0, 0, 1, false);
        const Pen square(raster, {15, y});
        square.box(-1.5, -1.5, 1.5, 1.5);
        square.disc(0, 0, 1, false);
        square.disc(0, 0, 0.3);
        const Pen pair(raster, {25, y});
        pair.box(-1, 0, 0, 1);
        pair.box(0, -1, 1, 0);
        const Pen cross(raster, {35, y});
        cross.box(-2, -2, 2, 2);
        cross.box(-0.5, -2, 0.5, 2, false);
        cross.box(-2, -0.5, 2, 0.5, false);
    }
}

void circles(Raster& raster) {
    Pen(raster, {2, 2}).disc(0, 0, 1.5);
    Pen(raster, {6, 2}).disc(0.5, 0.5, 0.8);
    Pen(raster, {10, 2, 45}).disc(1, 0, 0.6);
    const Pen five(raster, {2, 6});
    five.disc(0, 0, 0.5);
    for (const Point at : {Point{0.8, 0}, Point{-0.8, 0}, Point{0, 0.8}, Point{0, -0.8}}) {
        five.disc(at.x, at.y, 0.3);
    }
    const Pen donut(raster, {6, 6});
    donut.disc(0, 0, 1.5);
    donut.disc(0, 0, 0.8, false);
}

const ExpectedPicture kExpected[] = {
    {"macros/01_circle_primitive.gbr", "4.5.1.3: circles are rotated about the macro's origin; gerbv does not",
     circles},
    {"transforms/01_rotation.gbr", "4.9.4: LR rotates apertures; gerbv leaves them as they are", rotations},
    {"transforms/02_scaling.gbr", "4.9.5: LS scales apertures; gerbv leaves them as they are", scales},
    {"transforms/03_mirroring.gbr", "4.9.3: LM mirrors apertures; gerbv leaves them as they are", mirrors},
    {"blocks/01_block_aperture_basic.gbr", "4.11: AB defines a block; gerbv draws its parts where they are defined",
     blocks},
    {"blocks/02_block_aperture_transforms.gbr", "4.11, 4.9: the same, and blocks are mirrored, rotated and scaled",
     placedBlocks},
    {"blocks/03_block_aperture_polarity.gbr", "4.11: the same", polarityOfBlocks},
};

/// Pictures that differ from ours and that nobody has judged by the specification yet.
constexpr const char* kNotJudged[] = {
    "macros/07_macro_variables.gbr",
    "combined/all_features_comprehensive.gbr",
    "combined/comprehensive_test.gbr",
    "drill/01_drill_basic.drl",
    "drill/02_drill_slots.drl",
    "plotting/04_full_circles.gbr",
    "polarity/01_polarity_basic.gbr",
    "regions/03_regions_with_holes_polarity.gbr",
    "regions/04_regions_with_cutins.gbr",
    "regions/05_multiple_contours.gbr",
    // Their steps are millions of millimetres apart as the specification counts them; Copperscope reports it.
    "step-repeat/01_step_repeat_basic.gbr",
    "step-repeat/02_step_repeat_complex.gbr",
};

}  // namespace

bool isNotJudged(std::string_view file) {
    return std::ranges::find(kNotJudged, file) != std::end(kNotJudged);
}

const ExpectedPicture* expectedPicture(std::string_view file) {
    const auto* const found =
        std::ranges::find_if(kExpected, [&](const ExpectedPicture& one) { return file == one.file; });
    return found == std::end(kExpected) ? nullptr : found;
}

}  // namespace reference
