#include "model/base/radix_sort.h"

#include <QtTest>
#include <algorithm>
#include <random>
#include <vector>

class RadixSortTest : public QObject {
    Q_OBJECT

private slots:
    void rowsComeInTheOrderOfTheirKeys_data() {
        QTest::addColumn<std::size_t>("count");
        QTest::addColumn<std::uint32_t>("keys");
        for (const std::size_t count : {0U, 1U, 2U, 1024U, 1025U, 50'000U}) {
            for (const std::uint32_t keys : {1U, 7U, 5000U, 0xffffffffU}) {
                QTest::addRow("%zu rows, %u keys", count, keys) << count << keys;
            }
        }
    }
    void rowsComeInTheOrderOfTheirKeys() {
        QFETCH(std::size_t, count);
        QFETCH(std::uint32_t, keys);
        std::mt19937 random(7);
        std::vector<std::uint64_t> words(count);
        for (std::size_t i = 0; i < count; ++i) {
            words[i] = std::uint64_t{static_cast<std::uint32_t>(random()) % keys} << 32U | i;
        }
        std::vector<std::uint64_t> expected = words;
        std::ranges::sort(expected);
        std::vector<std::uint64_t> spare(count);
        const std::uint64_t* sorted = base::sortByKey(words.data(), spare.data(), count);
        QVERIFY(std::equal(expected.begin(), expected.end(), sorted));
    }
};

QTEST_APPLESS_MAIN(RadixSortTest)
#include "radix_sort_test.moc"
