#include <QtTest>

#include "app/bench/triangulation_run.h"
#include "tri/verify.h"

using tri::Triangulator;
using tri::bench::Set;

class BenchSetsTest : public QObject {
    Q_OBJECT

private slots:
    void setsHaveTheSizeTheyAreNamedFor() {
        QCOMPARE(tri::bench::areas("a", 40).shapes.size(), 40U);
        const Set plane = tri::bench::plane("p", 1000);
        const std::size_t loops = plane.shapes.front().loopStart.size() - 1;
        QVERIFY(loops > 900 && loops < 1100);
        QVERIFY(tri::bench::pour("q", 300).shapes.front().loopStart.size() > 300);
    }

    void allTriangulatorsAgreeAndAreVerified() {
        tri::bench::Options options;
        options.repeats = 1;
        for (const Set& set :
             {tri::bench::areas("areas", 200), tri::bench::plane("plane", 1000), tri::bench::pour("pour", 600)}) {
            const tri::bench::SetReport report = tri::bench::measure(set, options);
            QCOMPARE(report.runs.size(), 6U);
            for (const tri::bench::Run& run : report.runs) {
                QVERIFY2(run.isVerified, set.name.c_str());
                QCOMPARE(run.hash, report.runs.front().hash);
                QVERIFY(run.ms > 0.0);
            }
        }
    }

    void faultsAreNotReportedAsVerified() {
        Set set{"bow tie", {{}}};
        set.shapes[0].add({{0, 0}, {100, 100}, {100, 0}, {0, 70}});
        tri::bench::Options options;
        options.repeats = 1;
        for (const tri::bench::Run& run : tri::bench::measure(set, options).runs) {
            QVERIFY(!run.isVerified);
        }
    }
};

QTEST_APPLESS_MAIN(BenchSetsTest)
#include "triangulation_sets_test.moc"
