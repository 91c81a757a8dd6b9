#include "model/base/table.h"

#include <QTest>
#include <span>

class TableTest : public QObject {
    Q_OBJECT

private slots:
    void readsLikeAVector() {
        const base::Table<int> table{3, 1, 2};
        QCOMPARE(table.size(), std::size_t{3});
        QCOMPARE(table[1], 1);
        QCOMPARE(std::span(table).subspan(1).front(), 1);
        const std::vector<int>& rows = table;
        QCOMPARE(rows, (std::vector<int>{3, 1, 2}));
        QVERIFY(base::Table<int>{}.empty());
    }

    void copiesShareRowsUntilOneIsEdited() {
        base::Table<int> table{1, 2};
        table.push_back(3);
        const base::Table<int> copy = table;
        QVERIFY(copy.sharesRowsWith(table));
        table.edit()[0] = 7;
        QVERIFY(!copy.sharesRowsWith(table));
        QCOMPARE(copy[0], 1);
        QCOMPARE(table[0], 7);
        const int* rows = table.data();
        table.edit()[1] = 8;
        QCOMPARE(table.data(), rows);  // alone with its rows, it edits them in place
    }

    void whatAnotherWasMadeFromKeepsItsRows() {
        base::Table<int> table{1};
        const base::Table<int> taken = std::move(table);
        QCOMPARE(taken.size(), std::size_t{1});
        QCOMPARE(table.size(), std::size_t{1});  // NOLINT(bugprone-use-after-move): the class says so
    }
};

QTEST_APPLESS_MAIN(TableTest)
#include "table_test.moc"
