#include "model/packages/designator.h"

#include <array>
#include <cmath>
#include <numbers>

#include "model/formats/common/text_layout.h"

namespace model {

namespace {

/// Heights of capitals that are used.
constexpr std::array<Nm, 10> kHeights{4'000'000, 2'800'000, 2'000'000, 1'400'000, 1'000'000,
                                      700'000,   500'000,   350'000,   250'000,   180'000};
/// From one character to the next, and the width of the pen, over the height of capitals.
constexpr double kAdvance = 0.8;
constexpr double kPen = 0.14;
/// A name is no higher than this part of the room for it, and no longer than that: the mark of pin 1 has room beside
/// it.
constexpr double kMostOfWidth = 0.5;
constexpr double kMostOfLength = 0.9;

/// The largest height at which so many characters fit; 0: none.
Nm fittingHeight(std::size_t characters, const Box& label, bool isUpright) {
    const double along = static_cast<double>(isUpright ? label.height() : label.width());
    const double across = static_cast<double>(isUpright ? label.width() : label.height());
    const auto fits = [&](Nm height) {
        return static_cast<double>(characters) * kAdvance * static_cast<double>(height) <= kMostOfLength * along &&
               static_cast<double>(height) <= kMostOfWidth * across;
    };
    const auto* const found = std::ranges::find_if(kHeights, fits);
    return found != kHeights.end() ? *found : 0;
}

/// The direction of text along a body, counter-clockwise as seen from outside: readable from below or from the right.
double angleOf(const Placement& placement, bool isBottom, bool isUpright) {
    const Placement rotation{{}, placement.clockwiseDeg, placement.isMirrored};
    const PointD along = rotation.apply(isUpright ? PointD{0.0, 1.0} : PointD{1.0, 0.0});
    const double angle = std::atan2(along.y, isBottom ? -along.x : along.x) * 180.0 / std::numbers::pi;
    constexpr double kSlack = 1e-6;
    return angle > 90.0 + kSlack ? angle - 180.0 : angle <= -90.0 + kSlack ? angle + 180.0 : angle;
}

/// A track with round ends, by chords.
void addStroke(const formats::TextStroke& stroke, double halfPen, PolygonSet& polygons) {
    constexpr int kChords = 4;  // of an end
    const double direction = std::atan2(stroke.b.y - stroke.a.y, stroke.b.x - stroke.a.x);
    std::vector<Point> points;
    for (const bool isEnd : {true, false}) {
        const PointD centre = isEnd ? stroke.b : stroke.a;
        for (int i = 0; i <= kChords; ++i) {
            const double angle =
                direction + std::numbers::pi * (static_cast<double>(i) / kChords + (isEnd ? -0.5 : 0.5));
            points.push_back({static_cast<Nm>(std::lround(centre.x + halfPen * std::cos(angle))),
                              static_cast<Nm>(std::lround(centre.y + halfPen * std::sin(angle)))});
        }
    }
    polygons.beginPolygon();
    polygons.addLoop(points);
}

}  // namespace

std::vector<PrintedCharacter> printDesignator(const Component& component, const BodyPlan& plan) {
    std::vector<PrintedCharacter> printed;
    const std::u32string text = formats::codePoints(component.refdes);
    if (plan.label.isEmpty() || text.empty()) {
        return printed;
    }
    const bool isUpright = plan.label.height() > plan.label.width();
    const Nm height = fittingHeight(text.size(), plan.label, isUpright);
    if (height == 0) {
        return printed;
    }
    const Placement placement = component.package.isValid() ? component.placement : Placement{};
    const bool isBottom = component.side == LayerSide::Bottom;
    const Placement line{placement.apply(plan.label.middle()), -angleOf(placement, isBottom, isUpright), isBottom};
    const double advance = kAdvance * static_cast<double>(height);
    double x = -0.5 * advance * static_cast<double>(text.size()) + 0.5 * kPen * static_cast<double>(height);
    for (const char32_t character : text) {
        const Point corner{static_cast<Nm>(std::lround(x)), -height / 2};
        printed.push_back({character, height, {line.apply(corner), line.clockwiseDeg, line.isMirrored}});
        x += advance;
    }
    return printed;
}

PolygonSet characterStrokes(char32_t character, Nm height) {
    formats::TextLine line;
    if (character < 0x80) {
        line.text = static_cast<char>(character);
    }
    line.xSize = static_cast<Nm>(std::lround(kAdvance * static_cast<double>(height)));
    line.ySize = height;
    line.widthFactor = 1.0;
    PolygonSet polygons;
    for (const formats::TextStroke& stroke : formats::layOut(line, formats::standInFont()).strokes) {
        addStroke(stroke, 0.5 * kPen * static_cast<double>(height), polygons);
    }
    return polygons;
}

}  // namespace model
