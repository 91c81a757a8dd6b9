#include "model/base/large_pages.h"

#include <QtTest>
#include <algorithm>
#include <vector>

class LargePagesTest : public QObject {
    Q_OBJECT

private slots:
    void tablesOfEverySizeAreResized_data() {
        QTest::addColumn<std::size_t>("count");
        for (const std::size_t count : {0U, 1U, 1U << 18U, (1U << 19U) + 1U, 5'000'000U}) {
            QTest::addRow("%zu rows", count) << count;
        }
    }
    void tablesOfEverySizeAreResized() {
        QFETCH(std::size_t, count);
        std::vector<int> table;
        base::resizeLarge(table, count);
        QCOMPARE(table.size(), count);
        QVERIFY(std::ranges::all_of(table, [](int row) { return row == 0; }));
    }

    void whatLiesAroundAndWithinStays() {
        std::vector<char> memory(std::size_t{5} << 20U);
        for (std::size_t i = 0; i < memory.size(); ++i) {
            memory[i] = static_cast<char>(i * 31);
        }
        const std::vector<char> before = memory;
        base::preferLargePages(std::as_bytes(std::span(memory)).subspan(7, memory.size() - 13));
        QCOMPARE(memory, before);
    }
};

QTEST_APPLESS_MAIN(LargePagesTest)
#include "large_pages_test.moc"
