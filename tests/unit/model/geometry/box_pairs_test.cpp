#include "model/geometry/box_pairs.h"

#include <QtTest>
#include <random>
#include <set>

using base::Box;
using Pairs = std::multiset<std::pair<std::uint32_t, std::uint32_t>>;

namespace {

std::vector<Box> randomBoxes(std::size_t count) {
    std::mt19937 random(static_cast<unsigned>(count));
    std::uniform_int_distribution<int> place(0, 1000);
    std::uniform_int_distribution<int> size(0, 60);
    std::vector<Box> boxes;
    for (std::size_t i = 0; i < count; ++i) {
        const base::Point p{place(random), place(random)};
        boxes.push_back({p, {p.x + size(random), p.y + size(random)}});
    }
    return boxes;
}

}  // namespace

class BoxPairsTest : public QObject {
    Q_OBJECT

private slots:
    /// Few are in one strip, many in several.
    void everyPairOnce_data() {
        QTest::addColumn<std::size_t>("count");
        for (const std::size_t count : {0U, 1U, 50U, 500U, 2000U}) {
            QTest::addRow("%zu", count) << count;
        }
    }
    void everyPairOnce() {
        QFETCH(std::size_t, count);
        const std::vector<Box> boxes = randomBoxes(count);
        for (const std::uint32_t step : {1u, 3u}) {
            const auto isWanted = [&](std::uint32_t row) { return row % step == 0; };
            Pairs expected;
            for (std::uint32_t i = 0; i < count; ++i) {
                for (std::uint32_t j = i + 1; j < count; ++j) {
                    if (boxes[i].meets(boxes[j]) && (isWanted(i) || isWanted(j))) {
                        expected.emplace(i, j);
                    }
                }
            }
            Pairs found;
            model::visitPairs(boxes, isWanted,
                              [&](std::uint32_t i, std::uint32_t j) { found.emplace(std::min(i, j), std::max(i, j)); });
            QVERIFY(found == expected);
            QVERIFY(count < 50 || !found.empty());
        }
    }

    void tallBoxesAreInFewStrips() {
        std::vector<Box> boxes;
        for (int i = 0; i < 10'000; ++i) {
            boxes.push_back({{10 * i, 0}, {10 * i + 1, 1'000'000}});
        }
        const model::BoxStrips strips(boxes);
        std::size_t rows = 0;
        for (std::size_t strip = 0; strip < strips.count(); ++strip) {
            rows += strips.rowsOf(strip).size();
        }
        QVERIFY(rows <= 4 * boxes.size());
        model::visitPairs(
            boxes, [](std::uint32_t) { return true; }, [](std::uint32_t, std::uint32_t) { QFAIL("none meet"); });
    }

    /// Tall ones on the left, wide ones one above the other on the right: no strip has few.
    void longBoxesOfBothKindsAreLookedUp() {
        std::vector<Box> boxes;
        for (int i = 0; i < 10'000; ++i) {
            boxes.push_back({{10 * i, 0}, {10 * i + 1, 1'000'000}});
            boxes.push_back({{200'000, 100 * i}, {900'000, 100 * i + 1}});
        }
        boxes.push_back({{99'985, 500}, {200'000, 501}});
        QVERIFY(model::BoxStrips(boxes).mostRows() > model::kMostSwept);
        Pairs found;
        model::visitPairs(
            boxes, [](std::uint32_t) { return true; },
            [&](std::uint32_t i, std::uint32_t j) { found.emplace(std::min(i, j), std::max(i, j)); });
        QVERIFY(found == (Pairs{{11, 20'000}, {19'998, 20'000}}));
    }

    void boxesAtTheEndsOfCoordinatesAreMet() {
        constexpr base::Nm kEnd = 2'147'483'647;
        const std::vector<Box> boxes{
            {{-kEnd, -kEnd}, {kEnd, kEnd}}, {{kEnd, kEnd}, {kEnd, kEnd}}, {}, {{-kEnd, 0}, {0, 0}}};
        Pairs found;
        model::visitPairs(
            boxes, [](std::uint32_t) { return true; },
            [&](std::uint32_t i, std::uint32_t j) { found.emplace(std::min(i, j), std::max(i, j)); });
        QVERIFY(found == (Pairs{{0, 1}, {0, 3}}));
    }
};

QTEST_APPLESS_MAIN(BoxPairsTest)
#include "box_pairs_test.moc"
