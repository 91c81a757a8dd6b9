// Lengths along nets, on nets worked out by hand.
#include "model/measure/net_path.h"

#include <QtTest>
#include <cmath>
#include <numbers>

#include "tests/unit/model/measure/measure_fixture.h"

using namespace model;
using namespace measuring;

namespace {

/// A net under construction on all layers; elements are added layer by layer.
struct NetBoard {
    NetBoard() {
        addLayers(builder);
        net = builder.addNet("N");
    }
    ElementId line(Point a, Point b) { return builder.addLine({a, b, 200'000, 0}, of(net)); }
    ElementId pad(Point at) { return builder.addCircle({at, kMm, 0}, of(net, kPad)); }
    ElementId via(Point at) { return builder.addCircle({at, 400'000, 300'000}, of(net, kHole | kPlated | kVia)); }
    void on(BoardLayer layer) { builder.beginLayer(LayerId{layer}); }

    base::Result<NetPath> path(const MeasureItem& from, const MeasureItem& to) {
        if (!index) {
            index = indexed(builder.finish());
        }
        base::Progress progress;
        return pathAlong(*index, {0, net}, from, to, progress);
    }
    base::Result<NetPath> path(ElementId from, ElementId to) {
        return path(BoardElement{0, from}, BoardElement{0, to});
    }

    DocumentBuilder builder;
    NetId net;
    std::shared_ptr<const BoardIndex> index;
};

bool isNear(double a, double b) {
    return std::abs(a - b) < 1e-3;
}

}  // namespace

class NetPathTest : public QObject {
    Q_OBJECT

private slots:
    void strokesAreFollowedAlongTheirMiddles() {
        NetBoard b;
        b.on(Top);
        const ElementId from = b.pad({0, 0});
        b.line({0, 0}, {3 * kMm, 0});
        b.builder.addArc(
            {PathNode{{3 * kMm, 0}, {3 * kMm, kMm}, EdgeKind::ArcCounterClockwise}, {4 * kMm, kMm}, 200'000},
            of(b.net));
        b.line({4 * kMm, 5 * kMm}, {4 * kMm, kMm});
        const ElementId to = b.pad({4 * kMm, 5 * kMm});
        const NetPath path = *b.path(from, to);
        const double expected = 3e6 + std::numbers::pi / 2 * 1e6 + 4e6;
        QVERIFY2(isNear(path.length, expected), qPrintable(QString::number(path.length)));
        QCOMPARE(path.perLayer.size(), std::size_t{1});
        QVERIFY(isNear(path.perLayer.front().second, expected));
        QCOMPARE(path.holeCount, std::size_t{0});
        QCOMPARE(path.legs.size(), std::size_t{3});
        QVERIFY(path.notes.empty());
        QVERIFY(isNear(b.path(to, from)->length, expected));
        QVERIFY(isNear(b.path(from, from)->length, 0.0));
    }

    void theShorterOfTwoWaysCounts() {
        NetBoard b;
        b.on(Top);
        const ElementId from = b.pad({0, 0});
        const ElementId to = b.pad({10 * kMm, 0});
        b.line({0, 0}, {5 * kMm, 5 * kMm});
        b.line({5 * kMm, 5 * kMm}, {10 * kMm, 0});
        b.line({0, 0}, {0, -3 * kMm});
        b.line({0, -3 * kMm}, {10 * kMm, -3 * kMm});
        b.line({10 * kMm, -3 * kMm}, {10 * kMm, 0});
        QVERIFY(isNear(b.path(from, to)->length, 2 * std::hypot(5e6, 5e6)));
    }

    void pathsGoAroundHolesWithoutPlating() {
        NetBoard b;
        b.on(Top);
        const ElementId from = b.pad({0, 0});
        const ElementId to = b.pad({10 * kMm, 0});
        const ElementId lost = b.pad({20 * kMm, 0});
        b.line({0, 0}, {10 * kMm, 0});
        b.line({10 * kMm, 0}, {20 * kMm, 0});
        b.line({0, 0}, {5 * kMm, 5 * kMm});
        b.line({5 * kMm, 5 * kMm}, {10 * kMm, 0});
        b.on(Drill);
        for (const Nm x : {5 * kMm, 15 * kMm}) {
            b.builder.addCircle({{x, 0}, kMm, kMm}, of({}, kHole));
        }
        QVERIFY(isNear(b.path(from, to)->length, 2 * std::hypot(5e6, 5e6)));
        QVERIFY(!b.path(from, lost));
    }

    void crossingStrokesAreJoinedWhereTheyCross() {
        NetBoard b;
        b.on(Top);
        const ElementId from = b.pad({0, 0});
        b.line({0, 0}, {10 * kMm, 0});
        b.line({6 * kMm, -2 * kMm}, {6 * kMm, 4 * kMm});
        const ElementId to = b.pad({6 * kMm, 4 * kMm});
        QVERIFY(isNear(b.path(from, to)->length, 10e6));
    }

    void holesAddTheirHeight() {
        NetBoard b;
        b.on(Top);
        const ElementId from = b.pad({0, 0});
        b.line({0, 0}, {3 * kMm, 0});
        b.pad({3 * kMm, 0});
        b.on(Bottom);
        b.line({3 * kMm, 0}, {3 * kMm, 4 * kMm});
        const ElementId to = b.pad({3 * kMm, 4 * kMm});
        b.on(Drill);
        b.via({3 * kMm, 0});
        const NetPath path = *b.path(from, to);
        // From the middle of the top copper (2.25 mm) to that of the bottom (0.05 mm).
        QVERIFY(isNear(path.length, 3e6 + 2.2e6 + 4e6));
        QCOMPARE(path.holeCount, std::size_t{1});
        QVERIFY(isNear(path.holeHeight, 2.2e6));
        QCOMPARE(path.perLayer, (std::vector<std::pair<LayerId, double>>{{LayerId{Top}, 3e6}, {LayerId{Bottom}, 4e6}}));
        QVERIFY(QString::fromStdString(path.notes.front()).contains("assumed"));
    }

    void areasAreCrossedStraightAndTold() {
        NetBoard b;
        b.on(Top);
        const ElementId from = b.pad({-4 * kMm, 0});
        b.line({-4 * kMm, 0}, {kMm, 0});
        b.builder.addArea({b.builder.addShape(rectangle({0, -5 * kMm}, {20 * kMm, 5 * kMm})), {}}, of(b.net));
        b.line({15 * kMm, 0}, {25 * kMm, 0});
        const ElementId to = b.pad({25 * kMm, 0});
        const NetPath path = *b.path(from, to);
        QVERIFY2(isNear(path.length, 29e6), qPrintable(QString::number(path.length)));
        QVERIFY(isNear(path.areaLength, 14e6));
        QVERIFY(QString::fromStdString(path.notes.front()).contains("estimate"));
    }

    void placesOnTheCopperAreEnds() {
        NetBoard b;
        b.on(Top);
        b.line({0, 0}, {10 * kMm, 0});
        b.line({10 * kMm, 0}, {10 * kMm, 10 * kMm});
        const auto path = b.path(Location{{2e6, 50'000}, {}}, Location{{10e6 - 50'000, 7e6}, LayerId{Top}});
        QVERIFY(isNear(path->length, 15e6));
        const auto beside = b.path(Location{{2e6, 3e6}, {}}, Location{{10e6, 7e6}, {}});
        QCOMPARE(beside.error().code, base::ErrorCode::BadUsage);
    }

    void whatLeavesTheMiddlesOfTracksIsTold() {
        NetBoard b;
        b.on(Top);
        const ElementId from = b.pad({0, 0});
        b.line({300'000, 0}, {10 * kMm, 0});
        const ElementId to = b.pad({10 * kMm, 0});
        const NetPath path = *b.path(from, to);
        QVERIFY(isNear(path.length, 10e6) && isNear(path.padLength, 300'000.0));
        QCOMPARE(path.notes.size(), std::size_t{1});
        QVERIFY2(path.notes.front().starts_with("0.300000 mm of the path leave the middle lines of tracks"),
                 path.notes.front().c_str());
    }

    void aPinOfSeveralPadsIsAnEndWithTheNearest() {
        NetBoard b;
        Component part;
        part.refdes = "J7";
        const Pin left{b.builder.string("MP"), {0, 0}, b.net, {}, 0xffffffffu};
        const Pin right{b.builder.string("MP"), {6 * kMm, 0}, b.net, {}, 0xffffffffu};
        b.builder.addComponent(part, std::vector{left, right});
        b.on(Top);
        b.pad({0, 0});
        b.pad({6 * kMm, 0});
        b.line({0, 0}, {10 * kMm, 0});
        const ElementId to = b.pad({10 * kMm, 0});
        const NetPath path = *b.path(PinOfCopy{0, PinId{std::size_t{0}}}, BoardElement{0, to});
        QVERIFY2(isNear(path.length, 4e6), qPrintable(QString::number(path.length)));
        QVERIFY(path.notes.back().starts_with("pin J7.MP has 2 pads"));
    }

    void whatDoesNotHangTogetherIsSaid() {
        NetBoard b;
        b.on(Top);
        const ElementId from = b.pad({0, 0});
        b.line({0, 0}, {3 * kMm, 0});
        const ElementId to = b.pad({9 * kMm, 0});
        b.line({9 * kMm, 0}, {7 * kMm, 0});
        const auto path = b.path(from, to);
        QVERIFY(!path.ok());
        QVERIFY2(QString::fromStdString(path.error().text).contains("no copper of net N leads from"),
                 path.error().text.c_str());
    }

    void trailsAndRingsAreFollowedToo() {
        NetBoard b;
        b.on(Top);
        const std::array<PathNode, 4> nodes = {
            PathNode{{0, 0}, {}, EdgeKind::Line}, PathNode{{4 * kMm, 0}, {}, EdgeKind::Line},
            PathNode{{4 * kMm, 4 * kMm}, {}, EdgeKind::Line}, PathNode{{8 * kMm, 4 * kMm}, {}, EdgeKind::Line}};
        b.builder.addTrail(nodes, 200'000, of(b.net));
        const ElementId from = b.pad({0, 0});
        // A full circle around (9, 4) from (8, 4): the shorter half leads to (10, 4).
        b.builder.addArc(
            {PathNode{{8 * kMm, 4 * kMm}, {9 * kMm, 4 * kMm}, EdgeKind::ArcClockwise}, {8 * kMm, 4 * kMm}, 200'000},
            of(b.net));
        b.line({10 * kMm, 4 * kMm}, {12 * kMm, 4 * kMm});
        const ElementId to = b.pad({12 * kMm, 4 * kMm});
        QVERIFY(isNear(b.path(from, to)->length, 12e6 + std::numbers::pi * 1e6 + 2e6));
    }

    /// A guard ring drawn from a corner: its ends lie between the two pads, and are one place.
    void ringsOfSeveralTracksAreFollowedTheShortWayRound() {
        NetBoard b;
        b.on(Top);
        const Nm side = 10 * kMm;
        const std::array<PathNode, 5> ring = {
            PathNode{{0, 0}, {}, EdgeKind::Line}, PathNode{{side, 0}, {}, EdgeKind::Line},
            PathNode{{side, side}, {}, EdgeKind::Line}, PathNode{{0, side}, {}, EdgeKind::Line},
            PathNode{{0, 0}, {}, EdgeKind::Line}};
        b.builder.addTrail(ring, 200'000, of(b.net));
        const ElementId from = b.pad({2 * kMm, 0});
        const ElementId to = b.pad({0, 3 * kMm});
        const NetPath path = *b.path(from, to);
        QVERIFY2(isNear(path.length, 5e6), qPrintable(QString::number(path.length)));
        const auto track = std::ranges::find(path.legs, PathLeg::Kind::Track, &PathLeg::kind);
        QVERIFY(track != path.legs.end());
        const std::vector<PointD> course = courseOf(*b.index, *track);
        QCOMPARE(course.size(), std::size_t{3});
        QVERIFY2(std::hypot(course[1].x, course[1].y) < 1.0, "over the corner where the ring begins");
    }

    void coursesFollowBendsAndArcs() {
        NetBoard b;
        b.on(Top);
        const ElementId from = b.pad({0, 0});
        b.line({0, 0}, {3 * kMm, 0});
        b.builder.addArc(
            {PathNode{{3 * kMm, 0}, {3 * kMm, kMm}, EdgeKind::ArcCounterClockwise}, {4 * kMm, kMm}, 200'000},
            of(b.net));
        const std::array<PathNode, 3> bend = {PathNode{{4 * kMm, kMm}, {}, EdgeKind::Line},
                                              PathNode{{4 * kMm, 3 * kMm}, {}, EdgeKind::Line},
                                              PathNode{{6 * kMm, 3 * kMm}, {}, EdgeKind::Line}};
        b.builder.addTrail(bend, std::array<Nm, 2>{200'000, 200'000}, of(b.net));
        const ElementId to = b.pad({6 * kMm, 3 * kMm});
        for (const auto& [first, last] : {std::pair(from, to), std::pair(to, from)}) {
            const NetPath path = *b.path(first, last);
            double drawn = 0.0;
            for (const PathLeg& leg : path.legs) {
                const std::vector<PointD> course = courseOf(*b.index, leg);
                QVERIFY(std::hypot(course.front().x - leg.from.x, course.front().y - leg.from.y) < 1e-3);
                QVERIFY(std::hypot(course.back().x - leg.to.x, course.back().y - leg.to.y) < 1e-3);
                double length = 0.0;
                for (std::size_t i = 0; i + 1 < course.size(); ++i) {
                    length += std::hypot(course[i + 1].x - course[i].x, course[i + 1].y - course[i].y);
                }
                QVERIFY2(length <= leg.length + 1e-3 && length > leg.length * 0.999,
                         qPrintable(QString("%1 of %2").arg(length).arg(leg.length)));
                drawn += length;
            }
            QVERIFY(drawn > path.length * 0.999);
        }
    }

    void circlesAreFollowedTheShortWayRound() {
        NetBoard b;
        b.on(Top);
        // Begins and ends at (1, 0): the short way from (0, 1) to (0, -1) over (1, 0) passes that place.
        b.builder.addArc({PathNode{{kMm, 0}, {0, 0}, EdgeKind::ArcCounterClockwise}, {kMm, 0}, 100'000}, of(b.net));
        const Nm near = 707'107;
        b.line({near, near}, {3 * kMm, 3 * kMm});
        b.line({near, -near}, {3 * kMm, -3 * kMm});
        const ElementId from = b.pad({3 * kMm, 3 * kMm});
        const ElementId to = b.pad({3 * kMm, -3 * kMm});
        const NetPath path = *b.path(from, to);
        const auto round = std::ranges::find_if(path.legs, [](const PathLeg& leg) {
            return isNear(std::hypot(leg.from.x, leg.from.y) / 1e6, 1.0) &&
                   isNear(std::hypot(leg.to.x, leg.to.y) / 1e6, 1.0);
        });
        QVERIFY(round != path.legs.end());
        for (const PointD& at : courseOf(*b.index, *round)) {
            QVERIFY2(at.x > 0.7e6 && std::abs(std::hypot(at.x, at.y) - 1e6) < 2.0,
                     qPrintable(QString("%1 %2").arg(at.x).arg(at.y)));
        }
    }
};

QTEST_APPLESS_MAIN(NetPathTest)
#include "net_path_test.moc"
