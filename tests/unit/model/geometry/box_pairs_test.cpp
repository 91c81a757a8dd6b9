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
    /// Few are swept, many are looked up in an index.
    void everyPairOnce_data() {
        QTest::addColumn<std::size_t>("count");
        for (const std::size_t count :
             {std::size_t{0}, std::size_t{1}, std::size_t{50}, model::kMostSwept, std::size_t{900}}) {
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
};

QTEST_APPLESS_MAIN(BoxPairsTest)
#include "box_pairs_test.moc"
