#include "model/base/parallel.h"

#include <QtTest>
#include <atomic>
#include <chrono>
#include <stdexcept>
#include <thread>

class ParallelTest : public QObject {
    Q_OBJECT

private slots:
    void everyRowIsDoneOnce_data();
    void everyRowIsDoneOnce();
    void rowsRiseInOneThread();
    void neighboursGoToDifferentThreads();
    void whatATaskThrowsComesOut();
    void tasksMayHaveTasks();
    void largestComeFirst();
};

void ParallelTest::everyRowIsDoneOnce_data() {
    QTest::addColumn<int>("count");
    for (const int count : {0, 1, 2, 3, 1023, 1025, 100'000}) {
        QTest::addRow("%d", count) << count;
    }
}

void ParallelTest::everyRowIsDoneOnce() {
    QFETCH(int, count);
    std::vector<std::atomic<int>> done(static_cast<std::size_t>(count));
    base::parallelFor(done.size(), [&](std::size_t row) { ++done[row]; });
    for (const std::atomic<int>& times : done) {
        QCOMPARE(times.load(), 1);
    }
}

void ParallelTest::rowsRiseInOneThread() {
    const base::ThreadLimit limit(1);
    std::vector<std::size_t> rows;
    base::parallelFor(5000, [&](std::size_t row) { rows.push_back(row); });
    QCOMPARE(rows.size(), std::size_t{5000});
    QVERIFY(std::ranges::is_sorted(rows));
}

// The largest tasks come first and are handed out one by one: the first waits until another thread took the second.
void ParallelTest::neighboursGoToDifferentThreads() {
    if (std::thread::hardware_concurrency() < 2) {
        QSKIP("needs two processors");
    }
    std::atomic<bool> isSecondTaken = false;
    bool wasSecondTaken = false;
    base::parallelFor(1000, [&](std::size_t row) {
        if (row == 1) {
            isSecondTaken = true;
        }
        const auto end = std::chrono::steady_clock::now() + std::chrono::seconds(20);
        while (row == 0 && !isSecondTaken && std::chrono::steady_clock::now() < end) {
            std::this_thread::yield();
        }
        if (row == 0) {
            wasSecondTaken = isSecondTaken;
        }
    });
    QVERIFY(wasSecondTaken);
}

void ParallelTest::whatATaskThrowsComesOut() {
    std::atomic<int> done = 0;
    const auto failing = [&](std::size_t row) {
        ++done;
        if (row == 10) {
            throw std::out_of_range("row 10");
        }
    };
    QVERIFY_THROWS_EXCEPTION(std::out_of_range, base::parallelFor(1'000'000, failing));
    QVERIFY(done < 1'000'000);  // the rest is dropped
}

void ParallelTest::tasksMayHaveTasks() {
    std::atomic<int> sum = 0;
    base::parallelFor(20, [&](std::size_t) { base::parallelFor(50, [&](std::size_t) { ++sum; }); });
    QCOMPARE(sum.load(), 1000);
}

void ParallelTest::largestComeFirst() {
    const std::vector<std::size_t> sizes{3, 9, 1, 9, 4};
    QCOMPARE(base::largestFirst(sizes.size(), [&](std::size_t row) { return sizes[row]; }),
             (std::vector<std::uint32_t>{1, 3, 4, 0, 2}));
}

QTEST_GUILESS_MAIN(ParallelTest)
#include "parallel_test.moc"
