// What painting leaves, and the way back from it to features and nets.
#include "model/formats/common/painting.h"

#include "tests/unit/model/formats/odb/odb_testing.h"

using model::ElementId;
using model::NetId;
using model::Point;
using model::PolygonSet;
using model::formats::netsOf;
using model::formats::NetVote;
using model::formats::PieceNet;
using namespace odb_testing;

namespace {

using Features = std::vector<std::uint32_t>;

Features sourcesOf(const model::Document& d, ElementId id) {
    const auto span = d.painted.of(id);
    return {span.begin(), span.end()};
}

std::string netOf(const model::Document& d, ElementId id) {
    const NetId net = d.elements.net[id.row()];
    return net.isValid() ? d.nets[net.row()].name : "";
}

/// The piece of layer PLANE that covers more x than any other on this side of the bar.
ElementId pieceAt(const model::Document& d, Point point) {
    const model::Layer& plane = d.layer(d.findLayer("PLANE"));
    ElementId best;
    for (std::uint32_t i = 0; i < plane.elements.count; ++i) {
        const ElementId id{plane.elements.first + i};
        const model::Box box = d.boxOf(id);
        const bool isIn = box.min.x <= point.x && point.x <= box.max.x && box.min.y <= point.y && point.y <= box.max.y;
        if (isIn && (!best.isValid() || box.width() < d.boxOf(best).width())) {
            best = id;
        }
    }
    return best;
}

/// A plane cut in two by a bar (feature 0). Left: a clearance around the hole of SIG (1) and a thermal for GND (2).
/// Right: a hole of VCC without a feature. An island (3) without holes.
void writePlaneJob(const Folder& folder, const std::string& moreHoles = {}, const std::string& moreFids = {}) {
    std::string matrix = matrixOf({{"SIGNAL", "TOP"}, {"POWER_GROUND", "PLANE"}, {"SIGNAL", "BOTTOM"}});
    matrix.replace(matrix.find(" NAME=PLANE"), 11, " POLARITY=NEGATIVE\n NAME=PLANE");
    matrix += "LAYER {\n ROW=4\n CONTEXT=BOARD\n TYPE=DRILL\n NAME=DRILL\n START_NAME=TOP\n END_NAME=BOTTOM\n}\n";
    folder.write("matrix/matrix", matrix);
    folder.write("steps/board/profile", "UNITS=MM\nS P 0\nOB 0 0 I\nOS 100 0\nOS 100 100\nOS 0 100\nOS 0 0\nOE\nSE\n");
    folder.write("steps/board/layers/top/features", "UNITS=MM\n$0 r1000\nP 1 1 0 P 0 0\nP 99 99 0 P 0 0\n");
    folder.write("steps/board/layers/plane/features",
                 "UNITS=MM\n$0 r2000\n$1 ths3000x2000x45x4x400\n$2 donut_r3000x2000\nL 50 -5 50 105 0 P 0\n"
                 "P 10 10 0 P 0 0\nP 20 20 1 P 0 0\nP 70 20 2 P 0 0\n");
    folder.write(
        "steps/board/layers/drill/features",
        "UNITS=MM\n@0 .drill\n$0 r500\nP 10 10 0 P 0 0;0=0\nP 20 20 0 P 0 0;0=2\nP 70 70 0 P 0 0;0=0\n" + moreHoles);
    folder.write("steps/board/eda/data",
                 "UNITS=MM\nLYR TOP PLANE BOTTOM DRILL\nNET SIG\nSNT VIA\nFID H 3 0\nFID C 1 1\nNET GND\nSNT VIA\n"
                 "FID H 3 1\nFID C 1 2\nNET VCC\nSNT VIA\nFID H 3 2\n" +
                     moreFids);
}

}  // namespace

class PaintingTest : public QObject {
    Q_OBJECT

private slots:
    void piecesHaveTheNetOfThePlatedHolesInThem() {
        const Folder folder;
        writePlaneJob(folder);
        const auto d = read(folder.path());
        QCOMPARE(d->layer(d->findLayer("PLANE")).elements.count, 3U);
        QCOMPARE(netOf(*d, pieceAt(*d, {20'000'000, 20'000'000})), std::string("GND"));
        QCOMPARE(netOf(*d, pieceAt(*d, {90'000'000, 90'000'000})), std::string("VCC"));
        QCOMPARE(netOf(*d, pieceAt(*d, {70'000'000, 20'000'000})), std::string(""));
        QCOMPARE(d->elementsOf(d->findNet("GND")).size(), std::size_t{2});  // the hole and the piece
        QVERIFY(findDiagnostic(d->diagnostics, "2 of 3 pieces have a net") != nullptr);
    }

    void piecesKnowTheFeaturesAlongTheirOutline() {
        const Folder folder;
        writePlaneJob(folder);
        const auto d = read(folder.path());
        QCOMPARE(sourcesOf(*d, pieceAt(*d, {20'000'000, 20'000'000})), (Features{0, 1, 2}));
        QCOMPARE(sourcesOf(*d, pieceAt(*d, {90'000'000, 90'000'000})), (Features{0, 3}));
        QCOMPARE(sourcesOf(*d, pieceAt(*d, {70'000'000, 20'000'000})), (Features{3}));
        QVERIFY(d->painted.of(ElementId{d->layer(d->findLayer("TOP")).elements.first}).empty());
    }

    void clearancesAreExactCircles() {
        const Folder folder;
        writePlaneJob(folder);
        const auto d = read(folder.path());
        const ElementId piece = pieceAt(*d, {20'000'000, 20'000'000});
        const model::ShapeId shape = d->areas[d->elements.geometry[piece.row()]].shape;
        const auto isAntipad = [&](const model::Contour& contour) {
            const model::PathNodes nodes = d->shapes.nodesOf(contour);
            return contour.isHole && nodes.size() == 1 && nodes[0].centre == Point{10'000'000, 10'000'000} &&
                   std::abs(nodes[0].point.x - nodes[0].centre.x) + std::abs(nodes[0].point.y - nodes[0].centre.y) ==
                       1'000'000;
        };
        QCOMPARE(std::ranges::count_if(d->shapes.contoursOf(shape), isAntipad), 1);
        QVERIFY(findDiagnostic(d->diagnostics, "straight edges") == nullptr);
    }

    void whatOverlapsInASymbolKeepsItsArcs() {
        const Folder folder;
        writeSmallJob(folder, "UNITS=MM\n$0 pair\nP 10 10 0 P 0 0\n");
        folder.write("symbols/pair/features", "UNITS=MM\n$0 r1000\nP 0 0 0 P 0 0\nP 0.5 0 0 P 0 0\n");
        const auto d = read(folder.path());
        const ElementId pad = elementOf(*d, "TOP", 0);
        const model::ShapeId shape = d->areas[d->elements.geometry[pad.row()]].shape;
        const auto contours = d->shapes.contoursOf(shape);
        QCOMPARE(contours.size(), std::size_t{1});
        for (const model::PathNode& node : d->shapes.nodesOf(contours[0])) {
            QVERIFY(node.edge != model::EdgeKind::Line);
        }
    }

    void holesOfSeveralNetsInOnePieceAreReported() {
        const Folder folder;
        writePlaneJob(folder, "P 30 30 0 P 0 0;0=2\nP 31 40 0 P 0 0;0=2\nP 32 50 0 P 0 0;0=1\n",
                      "NET EXTRA\nSNT VIA\nFID H 3 3\nFID H 3 4\nFID H 3 5\n");
        const auto d = read(folder.path());
        // Two votes of EXTRA (its third hole is bare) against the hole and the thermal of GND: the first net wins.
        QCOMPARE(netOf(*d, pieceAt(*d, {20'000'000, 20'000'000})), std::string("GND"));
        QVERIFY(findDiagnostic(d->diagnostics, "in 1 pieces lie holes of several nets") != nullptr);
    }

    void whatNegativesLeaveKnowsThem() {
        const Folder folder;
        writeSmallJob(folder,
                      "UNITS=MM\n$0 s4000\n$1 s1000\nP 10 10 0 P 0 0\nP 10 10 1 N 0 0\nP 30 30 0 P 0 0\n"
                      "P 11 11 1 N 0 0\nP 50 50 1 N 0 0\n");
        const auto d = read(folder.path());
        QCOMPARE(sourcesOf(*d, elementOf(*d, "TOP", 0)), (Features{0, 1, 3}));
        QVERIFY(sourcesOf(*d, elementOf(*d, "TOP", 2)).empty());
    }

    void votesCountOnlyInsideOfAPiece() {
        PolygonSet pieces;
        const auto box = [&pieces](int x, int y, int size) {
            pieces.addLoop(std::vector<Point>{{x, y}, {x + size, y}, {x + size, y + size}, {x, y + size}});
        };
        pieces.beginPolygon();
        box(0, 0, 100);
        box(20, 20, 60);  // its hole
        pieces.beginPolygon();
        box(40, 40, 20);  // an island in the hole
        const NetId a{0};
        const NetId b{1};
        const std::vector<NetVote> votes = {{{10, 10}, a}, {{30, 50}, b}, {{50, 50}, b}, {{200, 50}, a}, {{50, -1}, b}};
        const std::vector<PieceNet> nets = netsOf(pieces, votes);
        QCOMPARE(nets[0].net, a);
        QVERIFY(!nets[0].hasOtherVotes);
        QCOMPARE(nets[1].net, b);
        QVERIFY(netsOf({}, votes).empty());
        QVERIFY(!netsOf(pieces, {})[0].net.isValid());
    }

    void holesVoteForTheCopperThatTheyCut() {
        // A thermal that clears less than what is drilled: all around, the plane touches the barrel.
        PolygonSet plane;
        const auto box = [&plane](model::Nm from, model::Nm to) {
            plane.addLoop(std::vector<Point>{{from, from}, {to, from}, {to, to}, {from, to}});
        };
        plane.beginPolygon();
        box(0, 2'000'000);
        box(900'000, 1'100'000);
        const NetId net{3};
        const auto of = [&](model::Nm radius) {
            return netsOf(plane, std::vector<NetVote>{{{1'000'000, 1'000'000}, net, radius}});
        };
        QVERIFY(!of(0)[0].net.isValid());
        QVERIFY(!of(90'000)[0].net.isValid());   // kept clear
        QVERIFY(!of(100'000)[0].net.isValid());  // cuts nothing
        QCOMPARE(of(150'000)[0].net, net);
    }
};

QTEST_APPLESS_MAIN(PaintingTest)
#include "painting_test.moc"
