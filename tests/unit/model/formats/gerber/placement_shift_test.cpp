#include "model/formats/gerber/placement_shift.h"

#include <QtTest>
#include <algorithm>
#include <vector>

using model::Point;
using model::gerber::PlacedPins;
using model::gerber::placementShift;

namespace {

constexpr Point kOrigin{31'000'000, -7'000'000};

/// `at` is what a program calls the part's place, on the board; the file counts from `origin`.
PlacedPins part(Point at, std::vector<Point> pins, Point origin = kOrigin) {
    for (Point& pin : pins) {
        pin = {at.x + pin.x, at.y + pin.y};
    }
    return {base::toDouble({at.x - origin.x, at.y - origin.y}), pins};
}

/// Resistors that stand on their first pin, all alike, and capacitors that are placed by their middle.
std::vector<PlacedPins> board(Point origin) {
    std::vector<PlacedPins> parts;
    for (int i = 0; i < 12; ++i) {
        parts.push_back(part({i * 7'000'000, i * i * 300'000}, {{0, 0}, {10'160'000, 0}}, origin));
    }
    for (int i = 0; i < 8; ++i) {
        parts.push_back(part({i * i * 1'100'000, 40'000'000 + i * 900'000}, {{-950'000, 0}, {950'000, 0}}, origin));
    }
    return parts;
}

}  // namespace

class PlacementShiftTest : public QObject {
    Q_OBJECT

private slots:
    void partsOnTheirFirstPinShiftNothing() {
        QCOMPARE(placementShift(board({})), std::optional<Point>(Point{}));
        QCOMPARE(placementShift(board(kOrigin)), std::optional<Point>(kOrigin));
    }

    void roundingIsTakenOff() {
        std::vector<PlacedPins> parts = board(kOrigin);
        for (std::size_t i = 0; i < parts.size(); ++i) {
            parts[i].place.x += i % 3 == 0 ? 2'540 : 0;
        }
        QCOMPARE(placementShift(parts), std::optional<Point>(kOrigin));
    }

    void placesBesideTheirPinsTellNothing() {
        std::vector<PlacedPins> parts;
        for (int i = 0; i < 6; ++i) {
            parts.push_back(part({i * i * 3'000'000, i * 2'000'000}, {{5'000'000 + i * 2'000'000, 0}}));
        }
        QVERIFY(!placementShift(parts));
        QVERIFY(!placementShift({}));
    }

    void shiftsBeyondTheLargestCoordinateAreNone() {
        const std::vector<PlacedPins> parts = {{{-1.0 * base::kMaxCoordinate, 0.0}, {{base::kMaxCoordinate, 0}}},
                                               {{-1.0 * base::kMaxCoordinate, 9.0}, {{base::kMaxCoordinate, 9}}}};
        QVERIFY(!placementShift(parts));
    }
};

QTEST_APPLESS_MAIN(PlacementShiftTest)
#include "placement_shift_test.moc"
