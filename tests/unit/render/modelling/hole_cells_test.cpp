#include "render/modelling/hole_cells.h"

#include <QtTest>
#include <random>

using base::Box;
using base::Nm;
using render::HoleFields;

namespace {

constexpr Nm kGap = 2;

Box square(Nm x, Nm y, Nm half) {
    return Box{{x, y}, {x, y}}.grownBy(half);
}

double areaOf(const Box& box) {
    return static_cast<double>(box.width()) * static_cast<double>(box.height());
}

bool overlap(const Box& a, const Box& b) {
    return a.min.x < b.max.x && b.min.x < a.max.x && a.min.y < b.max.y && b.min.y < a.max.y;
}

bool holds(const Box& outer, const Box& inner) {
    return outer.min.x <= inner.min.x && outer.min.y <= inner.min.y && outer.max.x >= inner.max.x &&
           outer.max.y >= inner.max.y;
}

/// Squares of several sizes that stand apart, in no order.
std::vector<Box> scattered(std::uint32_t seed, int tries) {
    std::mt19937 random(seed);
    std::vector<Box> squares;
    for (int i = 0; i < tries; ++i) {
        const auto any = [&] { return static_cast<Nm>(random() % 10'000U) - 5000; };
        const Box box = square(any(), any(), static_cast<Nm>(10 + random() % 90U));
        if (std::ranges::none_of(squares, [&](const Box& other) { return overlap(other, box.grownBy(kGap + 1)); })) {
            squares.push_back(box);
        }
    }
    return squares;
}

}  // namespace

class HoleCellsTest : public QObject {
    Q_OBJECT

private slots:
    void noSquaresHaveNoFields() { QVERIFY(HoleFields({}, kGap).fields().empty()); }

    void aGridIsOneField() {
        std::vector<Box> squares;
        for (Nm i = 0; i < 60; ++i) {
            squares.push_back(square(100 * (i % 6), 70 * (i / 6), 30));
        }
        const HoleFields fields(squares, kGap);
        QVERIFY(fields.fields()[0].isTiled);
        QCOMPARE(fields.fields()[0].box, (Box{{-30, -30}, {530, 660}}));
        fields.tile(fields.fields()[0], fields.fields()[0].box, [&](std::uint32_t row, const Box& part) {
            QVERIFY(part.width() <= 100 && part.height() <= 70 && holds(part, squares[row]));
        });
    }

    /// Parts of tiled fields cover them, overlap nowhere and hold a square each.
    void partsTileTheirField_data() {
        QTest::addColumn<std::uint32_t>("seed");
        for (std::uint32_t seed = 0; seed < 8; ++seed) {
            QTest::newRow(qPrintable(QString::number(seed))) << seed;
        }
    }
    void partsTileTheirField() {
        QFETCH(std::uint32_t, seed);
        const std::vector<Box> squares = scattered(seed, seed < 4 ? 40 : 120);
        const HoleFields fields(squares, kGap);
        std::size_t tiled = 0;
        for (const HoleFields::Field& field : fields.fields()) {
            if (!field.isTiled) {
                continue;
            }
            ++tiled;
            std::vector<Box> parts;
            double area = 0.0;
            fields.tile(field, field.box, [&](std::uint32_t row, const Box& part) {
                QVERIFY(holds(part, squares[row]) && holds(field.box, part));
                parts.push_back(part);
                area += areaOf(part);
            });
            QCOMPARE(parts.size(), field.count);
            QCOMPARE(area, areaOf(field.box));
            for (std::size_t i = 0; i < parts.size() && parts.size() < 200; ++i) {
                for (std::size_t k = 0; k < i; ++k) {
                    QVERIFY(!overlap(parts[i], parts[k]));
                }
            }
        }
        QVERIFY(tiled > 0);
    }

    void partsOfAFieldHoldItsSquaresAndKeepApart() {
        const std::vector<Box> squares = scattered(11, 120);
        const HoleFields fields(squares, kGap);
        QCOMPARE(fields.fields()[0].count, squares.size());
        for (const HoleFields::Field& field : fields.fields()) {
            std::uint32_t count = 0;
            for (std::uint32_t i = field.firstPart; i < field.firstPart + field.partCount; ++i) {
                const HoleFields::Field& part = fields.fields()[i];
                count += part.count;
                for (std::uint32_t k = field.firstPart; k < i; ++k) {
                    QVERIFY(!overlap(part.box.grownBy(kGap), fields.fields()[k].box));
                }
            }
            QVERIFY(field.partCount == 0 || count == field.count);
        }
    }

    void aWhirlIsAKnot() {
        // Each reaches past the end of the next: no straight line passes.
        const Box whirl[] = {{{0, 0}, {60, 30}}, {{70, 0}, {100, 60}}, {{40, 70}, {100, 100}}, {{0, 40}, {30, 100}}};
        const HoleFields fields(whirl, kGap);
        QCOMPARE(fields.fields().size(), 1U);
        QVERIFY(!fields.fields()[0].isTiled);
    }

    void squaresThatTouchAreAKnot() {
        const Box pair[] = {square(0, 0, 10), square(20 + kGap, 0, 10), square(100, 0, 10)};
        const HoleFields fields(pair, kGap);
        QVERIFY(!fields.fields()[0].isTiled);
        QCOMPARE(fields.fields()[0].partCount, 2U);
        QVERIFY(!fields.fields()[1].isTiled);
        QVERIFY(fields.fields()[2].isTiled);
    }

    /// Squares that peel off one by one end in a knot instead of in as many passes as there are squares.
    void stairsAreCutOnlySoDeep() {
        std::vector<Box> spiral;
        Box all = square(0, 0, 10);
        spiral.push_back(all);
        for (int i = 0; i < 120; ++i) {
            const Nm length = static_cast<Nm>(std::max(all.width(), all.height())) + 40;
            const Box next[] = {{{all.min.x, all.max.y + 10}, {all.min.x + length, all.max.y + 20}},
                                {{all.max.x + 10, all.min.y}, {all.max.x + 20, all.min.y + length}}};
            spiral.push_back(next[i % 2]);
            all.include(next[i % 2]);
        }
        const HoleFields fields(spiral, kGap);
        QVERIFY(!fields.fields()[0].isTiled);
        QVERIFY(std::ranges::all_of(fields.fields(), [](const HoleFields::Field& f) { return f.depth <= 24; }));
    }
};

QTEST_APPLESS_MAIN(HoleCellsTest)
#include "hole_cells_test.moc"
