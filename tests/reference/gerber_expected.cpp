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
    void regular(int corners, double diameter) const {
        Contour contour;
        for (int i = 0; i < corners; ++i) {
            const double angle = 2 * std::numbers::pi * i / corners;
            contour.push_back({diameter / 2 * std::cos(angle), diameter / 2 * std::sin(angle)});
        }
        polygon(contour);
    }
    void triangle(double diameter) const { regular(3, diameter); }
    void rectangle(double width, double height) const { box(-width / 2, -height / 2, width / 2, height / 2); }
    void ring(double outer, double inner) const {
        disc(0, 0, outer);
        disc(0, 0, inner, false);
    }
    void roundedRectangle(double width, double height, double radius) const {
        rectangle(width, height - 2 * radius);
        rectangle(width - 2 * radius, height);
        for (const double x : {radius - width / 2, width / 2 - radius}) {
            disc(x, radius - height / 2, 2 * radius);
            disc(x, height / 2 - radius, 2 * radius);
        }
    }
    void thermal(double outer, double inner, double gap) const {
        ring(outer, inner);
        box(-outer, -gap / 2, outer, gap / 2, false);
        box(-gap / 2, -outer, gap / 2, outer, false);
    }
    void arc(Point from, Point to, Point centre, bool isClockwise, double width) const {
        m_raster.fill(arcTrack(m_flash.apply(from), m_flash.apply(to), m_flash.apply(centre), isClockwise, width),
                      true);
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

void macroVariables(Raster& raster) {
    Pen(raster, {3, 3}).ring(2, 1.2);
    Pen(raster, {8, 3}).ring(1.5, 0.9);
    Pen(raster, {12, 3}).ring(1, 0.6);
    Pen(raster, {3, 8}).rectangle(2, 1.5);
    Pen(raster, {3, 8}).disc(0, 0, 0.8, false);
    Pen(raster, {8, 8}).rectangle(1.5, 2);
    Pen(raster, {8, 8}).disc(0, 0, 0.6, false);
    Pen(raster, {3, 14}).roundedRectangle(3, 2, 0.3);
    Pen(raster, {10, 14}).roundedRectangle(2, 3, 0.5);
    for (const Flash& flash : {Flash{3, 20}, Flash{8, 20, 45}, Flash{13, 20, 90}}) {
        Pen(raster, flash).box(-0.5, 0, 0.5, 1.2);
        Pen(raster, flash).polygon({{-0.5, 1.2}, {0.5, 1.2}, {0, 2}});
    }
    Pen(raster, {3, 26}).rectangle(2.5, 0.5);
    Pen(raster, {3, 26}).rectangle(0.5, 2.5);
    Pen(raster, {8, 26}).rectangle(2, 0.3);
    Pen(raster, {8, 26}).rectangle(0.3, 2);
    Pen(raster, {15, 26}).disc(0, 0, 7);  // 1 + 2 x 3
}

void combined(Raster& raster) {
    Pen(raster, {2, 2}).disc(0, 0, 0.5);
    Pen(raster, {5, 2}).disc(0, 0, 1);
    Pen(raster, {8, 2}).ring(1.5, 0.6);
    Pen(raster, {11, 2}).rectangle(1.5, 0.8);
    Pen(raster, {14, 2}).rectangle(1, 1);
    Pen(raster, {14, 2}).disc(0, 0, 0.4, false);
    Pen(raster, {17, 2}).line({-0.5, 0}, {0.5, 0}, 1);
    Pen(raster, {20, 2}).regular(6, 1.5);
    Pen(raster, {23, 2, 45}).regular(4, 1.5);
    Pen(raster, {2, 5}).ring(1.5, 0.8);
    Pen(raster, {2, 5}).rectangle(2.4, 0.15);
    Pen(raster, {2, 5}).rectangle(0.15, 2.4);
    Pen(raster, {6, 5}).thermal(2, 1.2, 0.3);
    Pen(raster, {10, 5})
        .polygon({{-0.8, 0.25}, {0.2, 0.25}, {0.2, 0.5}, {0.8, 0}, {-0.2, -0.5}, {0.2, -0.25}, {-0.8, -0.25}});
    const Pen board(raster, {});
    board.lines({{2, 8}, {8, 8}, {8, 10}, {2, 10}, {2, 8}}, 0.5);
    board.arc({14, 9}, {14, 9}, {12, 9}, true, 0.5);
    board.arc({22, 9}, {18, 9}, {20, 9}, false, 0.5);
    board.polygon({{2, 13}, {6, 13}, {4, 16}});
    board.box(17, 13, 22, 17);
    board.disc(19.5, 15, 2, false);
    for (const Flash& flash : {Flash{3, 20}, Flash{7, 20, 45}, Flash{11, 20, 90}, Flash{15, 20, 0, false, false, 0.7},
                               Flash{19, 20, 0, false, false, 1.3}}) {
        Pen(raster, flash).rectangle(1.5, 0.8);
    }
}

void selfCrossingRegion(Raster& raster) {
    Pen(raster, {}).box(7.9, 12.9, 14.1, 16.1);
}

void allFeatures(Raster& raster) {
    Pen(raster, {5, 5}).rectangle(1.2, 0.6);
    Pen(raster, {8, 5}).rectangle(1.2, 0.6);
    Pen(raster, {11, 5}).rectangle(0.8, 1.5);
    Pen(raster, {15, 5}).disc(0, 0, 0.6);
    Pen(raster, {18, 5}).ring(0.6, 0.3);
    Pen(raster, {22, 5}).regular(8, 1.5);
    Pen(raster, {27, 5}).ring(2, 1);
    Pen(raster, {5, 12, 45}).thermal(0.8, 0.5, 0.1);
    Pen(raster, {10, 12}).ring(1.2, 0.72);
    Pen(raster, {16, 12}).roundedRectangle(2, 1.2, 0.2);
    Pen(raster, {22, 12}).rectangle(1.5, 0.4);
    Pen(raster, {22, 12}).rectangle(0.4, 1.5);
    Pen(raster, {27, 12}).line({-1, 0}, {1, 0}, 0.5);
    Pen(raster, {27, 12}).line({0, -1}, {0, 1}, 0.5);
    const Pen board(raster, {});
    board.lines({{5, 5}, {5, 8}, {15, 8}, {15, 5}}, 0.25);
    board.arc({5, 20}, {10, 20}, {7.5, 20}, true, 0.5);
    board.arc({10, 20}, {15, 20}, {12.5, 20}, false, 0.5);
    board.arc({22, 20}, {22, 20}, {25, 20}, true, 0.5);
    board.line({30, 18}, {32, 18}, 0.25);
    board.line({34, 20}, {36, 20}, 0.25);
    board.line({38, 22}, {40, 22}, 0.25);
    board.box(5, 28, 12, 33);
    board.disc(10, 30.5, 3, false);
    Pen(raster, {20.5, 30.5}).roundedRectangle(9, 5, 2);
    board.disc(38, 30.5, 6);
    board.disc(36.5, 30.5, 3, false);
    Pen(raster, {5, 42, 45}).rectangle(1.2, 0.6);
    Pen(raster, {12, 42, 90}).rectangle(1.2, 0.6);
    Pen(raster, {20, 42}).roundedRectangle(2, 1.2, 0.2);
    Pen(raster, {28, 42}).roundedRectangle(2, 1.2, 0.2);
    Pen(raster, {36, 42}).ring(0.6, 0.36);
    Pen(raster, {42, 42}).ring(1.8, 1.08);
    Pen(raster, {5, 50}).disc(0, 0, 1);
}

/// Two arcs whose ends are 1 mm and 2.24 mm from their centre.
void unevenArcs(Raster& raster) {
    Pen(raster, {}).box(31.8, 17.4, 34.5, 20.3);
    Pen(raster, {}).box(34, 19.4, 38.5, 23.5);
}

/// The first of each row: I and J are decimals, and the next lie 3,000 km and more away.
void firstSteps(Raster& raster) {
    Pen(raster, {2, 2}).disc(0, 0, 1);
    Pen(raster, {25, 2}).rectangle(1.5, 0.8);
    Pen(raster, {2, 12}).line({0, 0}, {0, 2}, 0.3);
    for (const Flash& flash : {Flash{2, 20}, Flash{4, 20}, Flash{3, 22}}) {
        Pen(raster, flash).disc(0, 0, 1);
    }
}

void firstComplexSteps(Raster& raster) {
    const Pen board(raster, {});
    board.box(1, 1, 2, 2);
    board.arc({1.5, 20}, {1.5, 20}, {2.5, 20}, false, 0.5);
    Pen(raster, {30, 2}).ring(0.8, 0.4);
    board.disc(2, 30, 1.2);
    board.disc(8, 30, 1.2);
    Pen(raster, {5, 33}).rectangle(2, 1);
    board.lines({{2, 30}, {5, 30}, {5, 33}}, 0.25);
    board.line({5, 30}, {8, 30}, 0.25);
}

void drilledSlots(Raster& raster) {
    const Pen board(raster, {});
    for (const double x : {2.0, 6.0, 10.0}) {
        board.disc(x, 2, 0.8);
    }
    board.line({2, 5}, {6, 5}, 0.8);
    board.line({10, 4}, {10, 7}, 0.8);
    board.line({2, 8}, {5, 11}, 0.8);
    board.line({8, 8}, {12, 8}, 1);
    board.line({8, 10}, {8, 13}, 1);
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
    {"macros/07_macro_variables.gbr", "4.5.4.2: a minus may stand before a variable; gerbv leaves it out",
     macroVariables},
    {"combined/comprehensive_test.gbr",
     "4.9: the same as transforms/; 4.10.3: a contour that crosses itself is invalid", combined, selfCrossingRegion},
    {"combined/all_features_comprehensive.gbr",
     "4.9, 4.11, 4.12: the same as transforms/, blocks/ and step-repeat/; 4.1: comments that end with % are invalid, "
     "and gerbv swallows the commands behind them; 4.7.2: both ends of an arc are equally far from its centre",
     allFeatures, unevenArcs},
    {"step-repeat/01_step_repeat_basic.gbr", "4.12: I and J are decimals, in mm; gerbv draws 32-bit overflows",
     firstSteps},
    {"step-repeat/02_step_repeat_complex.gbr", "4.12: the same", firstComplexSteps},
    {"drill/02_drill_slots.drl",
     "Excellon has no G85 in front of both ends, but the file's comments say which slots these are; gerbv misreads "
     "them",
     drilledSlots},
};

}  // namespace

const ExpectedPicture* expectedPicture(std::string_view file) {
    const auto* const found =
        std::ranges::find_if(kExpected, [&](const ExpectedPicture& one) { return file == one.file; });
    return found == std::end(kExpected) ? nullptr : found;
}

}  // namespace reference
