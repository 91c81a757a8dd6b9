#include "model/export/meshes/united.h"

#include <QtTest>

#include "model/geometry/boolean.h"

using model::PolygonSet;

namespace {

/// Squares of 10 nm, so far apart; with a hole each.
PolygonSet squares(int count, model::Nm apart) {
    PolygonSet set;
    for (model::Nm i = 0; i < count; ++i) {
        const model::Nm x = i * apart;
        set.beginPolygon();
        set.addLoop(std::vector<model::Point>{{x, 0}, {x + 10, 0}, {x + 10, 10}, {x, 10}});
        set.addLoop(std::vector<model::Point>{{x + 4, 4}, {x + 5, 4}, {x + 5, 5}, {x + 4, 5}});
    }
    return set;
}

double areaOf(const PolygonSet& set) {
    return static_cast<double>(model::twiceArea(set)) / 2;
}

double areaOf(const std::vector<model::LoopSet>& parts) {
    double area = 0.0;
    for (const model::LoopSet& part : parts) {
        for (std::size_t i = 0; i + 1 < part.loopStart.size(); ++i) {
            const auto loop =
                std::span(part.points).subspan(part.loopStart[i], part.loopStart[i + 1] - part.loopStart[i]);
            area += static_cast<double>(model::twiceArea(loop)) / 2;
        }
    }
    return area;
}

}  // namespace

class UnitedTest : public QObject {
    Q_OBJECT

private slots:
    void whatIsApartStaysAsItIs() {
        const std::vector<model::LoopSet> united = model::uniteNear(squares(100, 20));
        QCOMPARE(united.size(), std::size_t{100});
        QCOMPARE(united[7].points.size(), std::size_t{8});
        QCOMPARE(areaOf(united), 100 * 99.0);
    }

    void whatOverlapsBecomesOne() {
        const std::vector<model::LoopSet> united = model::uniteNear(squares(100, 8));
        QCOMPARE(united.size(), std::size_t{1});
        QCOMPARE(areaOf(united), areaOf(model::unite(squares(100, 8))));
    }

    /// Each part by itself; they overlap where they meet.
    void largeGroupsAreUnitedInParts() {
        const std::vector<model::LoopSet> united = model::uniteNear(squares(100, 8), 10);
        QCOMPARE(united.size(), std::size_t{10});
        QCOMPARE(areaOf(united), 10 * areaOf(model::unite(squares(10, 8))));
    }

    void nothingStaysNothing() { QVERIFY(model::uniteNear({}).empty()); }
};

QTEST_GUILESS_MAIN(UnitedTest)
#include "united_test.moc"
