#include "tri/predicates.h"

#include <QtTest>
#include <algorithm>
#include <array>
#include <random>

using tri::inCircle;
using tri::Int128;
using tri::isInPerturbedCircle;
using tri::orient;
using tri::Point;
using tri::Site;

namespace {

/// Largest coordinate plus the margin of the bounding corners.
constexpr int kReach = (1 << 30) + (1 << 28);

int sign(Int128 value) {
    return (value > 0) - (value < 0);
}

}  // namespace

class PredicatesTest : public QObject {
    Q_OBJECT

private slots:
    void orientKnowsLeftFromRight() {
        QCOMPARE(orient({0, 0}, {10, 0}, {3, 1}), 10);
        QCOMPARE(orient({0, 0}, {10, 0}, {3, -1}), -10);
        QCOMPARE(orient({0, 0}, {3, 1}, {-3'000, -1'000}), 0);
    }

    void predicatesAreExactAtFullReach() {
        const Point a{-kReach, -kReach}, b{kReach, -kReach}, c{kReach, kReach}, d{-kReach, kReach};
        const std::int64_t side = 2 * std::int64_t{kReach};
        QCOMPARE(orient(a, b, c), side * side);
        QCOMPARE(orient(a, c, {kReach - 1, kReach - 1}), 0);
        QVERIFY(inCircle(a, b, c, d) == 0);
        QVERIFY(inCircle(a, b, c, {-kReach + 1, kReach}) > 0);
        QVERIFY(inCircle(a, b, {kReach, kReach - 1}, d) < 0);
        // The largest determinant: a point in the middle of one side of the square, seen from the other three corners.
        QVERIFY(inCircle(a, b, c, {0, 0}) == Int128{side} * side / 2 * side * side);
    }

    void inCircleDependsOnTheCircleOnly() {
        const std::array<Point, 5> circle{{{25, 0}, {24, 7}, {15, 20}, {-7, 24}, {-20, -15}}};
        for (const Point& d : circle) {
            QVERIFY(inCircle(circle[0], circle[2], circle[4], d) == 0);
        }
        QVERIFY(inCircle({25, 0}, {15, 20}, {-7, 24}, {1, 1}) > 0);
        QVERIFY(inCircle({25, 0}, {15, 20}, {-7, 24}, {26, 0}) < 0);
    }

    void inCircleChangesSignWithEveryExchange() {
        std::mt19937 random(5);
        const auto point = [&] { return Point{static_cast<int>(random() >> 1), static_cast<int>(random() >> 1)}; };
        for (int i = 0; i < 1000; ++i) {
            const Point a = point(), b = point(), c = point(), d = point();
            const Int128 value = inCircle(a, b, c, d);
            QVERIFY(inCircle(b, c, a, d) == value);
            QVERIFY(inCircle(b, a, c, d) == -value);
            QVERIFY(inCircle(a, b, d, c) == -value);
            QVERIFY(inCircle(d, b, c, a) == -value);
        }
    }

    void theEyeSeesTheSameNumber() {
        std::mt19937 random(9);
        const auto number = [&] {
            const std::int64_t offset =
                random() % 4 == 0 ? 2 * std::int64_t{kReach} * (random() % 2) : random() % (2 * std::int64_t{kReach});
            return static_cast<int>(offset - kReach);
        };
        const auto point = [&] { return Point{number(), number()}; };
        for (int i = 0; i < 10'000; ++i) {
            const Point eye = point(), a = point(), b = point(), d = point();
            const auto seenA = tri::Seen<std::uint64_t>::from(eye, a);
            const auto seenB = tri::Seen<std::uint64_t>::from(eye, b);
            const auto seenD = tri::Seen<std::uint64_t>::from(eye, d);
            QCOMPARE(tri::orientation(seenA, seenB), orient(eye, a, b));
            QVERIFY(tri::outsideCircleOfEye(seenA, seenB, seenD, tri::orientation(seenA, seenB),
                                            tri::orientation(seenB, seenD),
                                            tri::orientation(seenA, seenD)) == -inCircle(eye, a, b, d));
        }
    }

    void compactPointsGiveTheSameNumber() {
        std::mt19937 random(8);
        for (int i = 0; i < 10'000; ++i) {
            // The corners of the largest compact square, and anything in it.
            constexpr std::int64_t kSide = tri::kCompactExtent - 1;
            const auto number = [&] {
                const std::int64_t offset = random() % 3 == 0 ? kSide * (random() % 2) : random() % kSide;
                return static_cast<int>(offset - kSide / 2);
            };
            const auto point = [&] { return Point{number(), number()}; };
            const Point a = point(), b = point(), c = point(), d = point();
            QVERIFY(inCircle<std::int64_t>(a, b, c, d) == inCircle(a, b, c, d));
        }
    }

    void perturbationNeverTiesAndIsConsistent() {
        // Four corners of a square in every order of ids: exactly one diagonal is right, whoever asks.
        const std::array<Point, 4> square{{{0, 0}, {10, 0}, {10, 10}, {0, 10}}};
        std::array<std::uint32_t, 4> id{0, 1, 2, 3};
        do {
            const auto site = [&](std::size_t i) { return Site{square[i % 4], id[i % 4]}; };
            const bool flips02 = isInPerturbedCircle(site(0), site(1), site(2), site(3));
            for (std::size_t i = 0; i < 4; ++i) {
                const bool flips = isInPerturbedCircle(site(i), site(i + 1), site(i + 2), site(i + 3));
                QCOMPARE(flips, i % 2 == 0 ? flips02 : !flips02);
                QCOMPARE(isInPerturbedCircle(site(i + 1), site(i + 2), site(i), site(i + 3)), flips);
            }
            // The lowest id is lifted out of the others' circle, so no edge ends there but those of the square.
            const bool isLowestOn02 = std::min(id[0], id[2]) < std::min(id[1], id[3]);
            QCOMPARE(flips02, isLowestOn02);
        } while (std::ranges::next_permutation(id).found);
    }

    void perturbationIsAnActualLift() {
        // Where there is no tie, it changes nothing.
        std::mt19937 random(6);
        for (int i = 0; i < 1000; ++i) {
            const auto site = [&](std::uint32_t id) {
                return Site{{static_cast<int>(random() % 50), static_cast<int>(random() % 50)}, id};
            };
            const Site a = site(3), b = site(1), c = site(2), d = site(0);
            const Int128 exact = inCircle(a.at, b.at, c.at, d.at);
            if (sign(exact) != 0) {
                QCOMPARE(isInPerturbedCircle(a, b, c, d), exact > 0);
            }
        }
    }
};

QTEST_APPLESS_MAIN(PredicatesTest)
#include "predicates_test.moc"
