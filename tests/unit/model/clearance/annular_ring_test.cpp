// Annular rings: round holes and slots in pads of all shapes, exact to the nanometre, with nets and without.
#include "model/clearance/annular_ring.h"

#include <QtTest>
#include <algorithm>
#include <cmath>
#include <iterator>
#include <random>

#include "model/board/document_builder.h"
#include "model/design_rules/design_rule_check.h"
#include "tests/unit/model/hand_made.h"

using namespace hand_made;
using model::AnnularRing;
using model::DocumentBuilder;
using model::FindingReason;
using model::LayerId;
using model::NetId;
using model::Nm;
using model::Point;
using model::RingState;
using model::RuleKind;
using model::RuleReport;

namespace {

constexpr int kWall = model::kHole | model::kPlated;
constexpr double kFar = 10e6;

struct Board {
    DocumentBuilder builder;
    LayerId top = addLayer(builder, "top");
    LayerId inner = addLayer(builder, "inner");
    LayerId bottom = addLayer(builder, "bottom");
    LayerId drill = addDrill(builder, top, bottom);
    NetId a = builder.addNet("A");
    NetId b = builder.addNet("B");

    /// Drills what `add` adds and returns the only ring on top.
    template <class Add>
    AnnularRing ring(const Add& add) {
        builder.beginLayer(drill);
        add();
        const auto document = builder.finish();
        return model::annularRings(*document, top, kFar).front();
    }
    void hole(Point at, Nm diameter, NetId net) { builder.addCircle({at, diameter, diameter}, of(net, kWall)); }
    void slot(Point from, Point to, Nm width, NetId net) { builder.addLine({from, to, width, width}, of(net, kWall)); }
};

/// A round pad.
struct RoundPad {
    Nm x;
    Nm y;
    Nm diameter;
};

/// A board of 100 holes and slots with and without nets, in pads whose rings are 0.1 to 0.3 mm wide but for one in ten.
struct Planting {
    std::vector<std::pair<LayerId, Point>> planted;  ///< where they are less
    std::shared_ptr<const model::Document> document;

    explicit Planting(unsigned seed) : m_random(seed) {
        for (int i = 0; i < 100; ++i) {
            const Point at{i % 10 * 5000 * kUm, i / 10 * 5000 * kUm};
            const Point end{at.x + upTo(2) * upTo(1000) * kUm, at.y + upTo(2) * upTo(1000) * kUm};
            const NetId nets[] = {m_board.a, m_board.b, {}};
            m_slots.push_back({at, end, (200 + upTo(600)) * kUm, nets[upTo(3)]});
        }
        addPads(m_board.top);
        addPads(m_board.bottom);
        m_board.builder.beginLayer(m_board.drill);
        for (const Slot& slot : m_slots) {
            m_board.slot(slot.from, slot.to, slot.width, slot.net);
        }
        document = m_board.builder.finish();
    }

private:
    struct Slot {
        Point from;
        Point to;
        Nm width;
        NetId net;
    };

    int upTo(unsigned most) { return static_cast<int>(m_random() % most); }
    void addPads(LayerId layer) {
        m_board.builder.beginLayer(layer);
        for (const Slot& slot : m_slots) {
            const bool isPlanted = upTo(10) == 0;
            const Nm ring = isPlanted ? upTo(100) * kUm + 999 : (100 + upTo(200)) * kUm;
            const NetId net = upTo(2) == 0 ? slot.net : NetId{};
            m_board.builder.addLine({slot.from, slot.to, slot.width + 2 * ring, 0}, of(net, model::kPad));
            if (isPlanted) {
                planted.emplace_back(layer, slot.from);
            }
        }
    }

    std::mt19937 m_random;
    Board m_board;
    std::vector<Slot> m_slots;
};

RuleReport check(const model::Document& board, Nm least) {
    base::Progress progress;
    return *model::checkRules(board, {{}, {{RuleKind::AnnularRing, least, {}}}, 0}, progress);
}

void verifyWidth(const AnnularRing& ring, double width) {
    QVERIFY(ring.ring.state == RingState::Around);
    QVERIFY2(std::abs(ring.ring.width.distance - width) < 0.01, qPrintable(QString::number(ring.ring.width.distance)));
    const auto [distance, from, to] = ring.ring.width;
    QVERIFY(std::abs(std::hypot(from.x - to.x, from.y - to.y) - distance) < 0.01);
}

}  // namespace

class AnnularRingTest : public QObject {
    Q_OBJECT

private slots:
    void roundHolesInRoundPads() {
        Board board;
        board.builder.beginLayer(board.top);
        board.builder.addCircle({{10 * kUm, 0}, 600 * kUm, 0}, of(board.a, model::kPad));
        verifyWidth(board.ring([&] { board.hole({0, 0}, 300 * kUm, board.a); }), 140 * kUm);
    }

    /// The ring is the pad's, whatever plane or track lies around it.
    void aPlaneAroundAPadIsNoRing() {
        Board board;
        board.builder.beginLayer(board.top);
        const auto shape = board.builder.addShape(rectangle({-1000 * kUm, -1000 * kUm}, {1000 * kUm, 1000 * kUm}));
        board.builder.addArea({shape, {}}, of(board.a));
        board.builder.addCircle({{0, 0}, 600 * kUm, 0}, of(board.a, model::kPad));
        const AnnularRing ring = board.ring([&] { board.hole({0, 0}, 300 * kUm, board.a); });
        verifyWidth(ring, 150 * kUm);
        QVERIFY(ring.isOfPads);
    }

    /// Also where the hole breaks out of it, but not for one beside.
    void aPadOffTheHoleIsNotMadeGoodByAPlane() {
        for (const Nm offset : {200 * kUm, 400 * kUm}) {
            Board board;
            board.builder.beginLayer(board.top);
            const auto shape = board.builder.addShape(rectangle({-1000 * kUm, -1000 * kUm}, {1000 * kUm, 1000 * kUm}));
            board.builder.addArea({shape, {}}, of(board.a));
            board.builder.addCircle({{offset, 0}, 600 * kUm, 0}, of(board.a, model::kPad));
            const AnnularRing ring = board.ring([&] { board.hole({0, 0}, 300 * kUm, board.a); });
            QVERIFY(ring.ring.state == (offset < 300 * kUm ? RingState::BreaksOut : RingState::Around));
            QCOMPARE(ring.isOfPads, offset < 300 * kUm);
        }
    }

    void aLayerWithoutAPadHasTheRingOfThePlaneAndSaysSo() {
        Board board;
        board.builder.beginLayer(board.top);
        const auto shape = board.builder.addShape(rectangle({-250 * kUm, -250 * kUm}, {250 * kUm, 250 * kUm}));
        board.builder.addArea({shape, {}}, of(board.a));
        board.builder.beginLayer(board.bottom);
        board.builder.addCircle({{0, 0}, 460 * kUm, 0}, of(board.a, model::kPad));
        board.builder.beginLayer(board.drill);
        board.hole({0, 0}, 300 * kUm, board.a);
        const auto document = board.builder.finish();
        const RuleReport report = check(*document, 110 * kUm);
        QCOMPARE(report.findings.size(), std::size_t{2});
        QCOMPARE(report.findings[0].layer, board.bottom);
        QCOMPARE(model::reasonOf(report.findings[0]), std::string());
        QCOMPARE(report.findings[1].layer, board.top);
        QCOMPARE(model::reasonOf(report.findings[1]),
                 std::string("no pad there on this layer: the copper around it counts"));
    }

    void padsThatOverlapCountTogether_data() {
        QTest::addColumn<QList<RoundPad>>("pads");
        QTest::addColumn<double>("width");
        const Nm r = 150 * kUm;  // of the hole
        QTest::newRow("one within another") << QList<RoundPad>{{0, 0, 400 * kUm}, {0, 0, 600 * kUm}} << 150.0 * kUm;
        QTest::newRow("the same twice") << QList<RoundPad>{{0, 0, 600 * kUm}, {0, 0, 600 * kUm}} << 150.0 * kUm;
        // The outlines cross above and below the hole: sqrt(300^2 - 100^2) - 150.
        QTest::newRow("two side by side")
            << QList<RoundPad>{{-100 * kUm, 0, 600 * kUm}, {100 * kUm, 0, 600 * kUm}} << std::sqrt(8.0) * 100 * kUm - r;
        // The hole breaks out of each of them: sqrt(300^2 - 200^2) - 150.
        QTest::newRow("two halves") << QList<RoundPad>{{-200 * kUm, 0, 600 * kUm}, {200 * kUm, 0, 600 * kUm}}
                                    << std::sqrt(5.0) * 100 * kUm - r;
    }
    void padsThatOverlapCountTogether() {
        QFETCH(QList<RoundPad>, pads);
        QFETCH(double, width);
        Board board;
        board.builder.beginLayer(board.top);
        for (const RoundPad& pad : pads) {
            board.builder.addCircle({{pad.x, pad.y}, pad.diameter, 0}, of(board.a, model::kPad));
        }
        const AnnularRing ring = board.ring([&] { board.hole({0, 0}, 300 * kUm, board.a); });
        QVERIFY(ring.ring.state == RingState::Around);
        QVERIFY2(std::abs(ring.ring.width.distance - width) < 2, qPrintable(QString::number(ring.ring.width.distance)));
    }

    void slotsInRoundEndedPads() {
        Board board;
        board.builder.beginLayer(board.top);
        board.builder.addLine({{-500 * kUm, 0}, {500 * kUm, 0}, 900 * kUm, 0}, of(board.a, model::kPad));
        // 20 um off to the right, where the ends are: 450 - 300 - 20.
        verifyWidth(board.ring([&] { board.slot({-480 * kUm, 0}, {520 * kUm, 0}, 600 * kUm, board.a); }), 130 * kUm);
    }

    void slotsOfAnyDirectionInRectangles() {
        Board board;
        board.builder.beginLayer(board.top);
        const auto shape = board.builder.addShape(rectangle({-1000 * kUm, -1000 * kUm}, {1000 * kUm, 1000 * kUm}));
        board.builder.addArea({shape, {}}, of(board.a, model::kPad));
        verifyWidth(board.ring([&] {
            board.slot({-300 * kUm, -400 * kUm}, {500 * kUm, 650 * kUm}, 400 * kUm, board.a);
        }),
                    150 * kUm);
    }

    void curvedSlots() {
        Board board;
        board.builder.beginLayer(board.top);
        board.builder.addCircle({{0, 0}, 4000 * kUm, 0}, of(board.a, model::kPad));
        // A quarter of a circle of 1.5 mm: 2000 - 1500 - 200.
        const model::ArcGeometry arc{
            {{1500 * kUm, 0}, {0, 0}, model::EdgeKind::ArcCounterClockwise}, {0, 1500 * kUm}, 400 * kUm, 400 * kUm};
        verifyWidth(board.ring([&] { board.builder.addArc(arc, of(board.a, kWall)); }), 300 * kUm);
    }

    /// The opening in the middle of the pad is what the drill takes anyway.
    void ringShapedPads() {
        Board board;
        board.builder.beginLayer(board.top);
        board.builder.addCircle({{0, 0}, 600 * kUm, 250 * kUm}, of(board.a, model::kPad));
        verifyWidth(board.ring([&] { board.hole({0, 0}, 300 * kUm, board.a); }), 150 * kUm);
    }

    void anOpeningInAPlaneIsNoRing() {
        Board board;
        board.builder.beginLayer(board.top);
        model::ShapeSketch plane = rectangle({-5000 * kUm, -5000 * kUm}, {5000 * kUm, 5000 * kUm});
        plane.addPolygon(
            std::array<Point, 4>{
                {{-200 * kUm, -200 * kUm}, {-200 * kUm, 200 * kUm}, {200 * kUm, 200 * kUm}, {200 * kUm, -200 * kUm}}},
            true);
        board.builder.addArea({board.builder.addShape(plane), {}}, of(board.a));
        QVERIFY(board.ring([&] { board.hole({0, 0}, 300 * kUm, board.a); }).ring.state == RingState::Apart);
    }

    void padsOfTheSizeOfTheDrillAreRemoved_data() {
        QTest::addColumn<int>("pad");
        QTest::addColumn<int>("slot");
        QTest::newRow("round, smaller") << 250 << 0;
        QTest::newRow("round, as large") << 300 << 0;
        QTest::newRow("slot, smaller") << 250 << 700;
        QTest::newRow("slot, as large") << 300 << 700;
    }
    void padsOfTheSizeOfTheDrillAreRemoved() {
        QFETCH(int, pad);
        QFETCH(int, slot);
        Board board;
        const Point end{slot * kUm, slot * kUm / 2};
        board.builder.beginLayer(board.top);
        board.builder.addLine({{0, 0}, end, pad * kUm, 0}, of(board.a, model::kPad));
        QVERIFY(board.ring([&] { board.slot({0, 0}, end, 300 * kUm, board.a); }).ring.state == RingState::Removed);
    }

    void aNanometreOfCopperIsARing() {
        Board board;
        board.builder.beginLayer(board.top);
        board.builder.addCircle({{0, 0}, 300 * kUm + 2, 0}, of(board.a, model::kPad));
        verifyWidth(board.ring([&] { board.hole({0, 0}, 300 * kUm, board.a); }), 1);
    }

    /// Also where the middle of the hole lies beside the pad.
    void holesBesideTheirPadBreakOut() {
        for (const Nm offset : {100 * kUm, 280 * kUm}) {
            Board board;
            board.builder.beginLayer(board.top);
            board.builder.addCircle({{offset, 0}, 400 * kUm, 0}, of(board.a, model::kPad));
            const AnnularRing ring = board.ring([&] { board.hole({0, 0}, 300 * kUm, board.a); });
            QVERIFY(ring.ring.state == RingState::BreaksOut);
            QCOMPARE(ring.ring.width.distance, 0.0);
        }
    }

    void nets_data() {
        QTest::addColumn<QString>("hole");
        QTest::addColumn<QString>("pad");
        QTest::addColumn<bool>("isMeasured");
        QTest::newRow("the same") << "A"
                                  << "A" << true;
        QTest::newRow("none") << ""
                              << "" << true;
        QTest::newRow("of the pad alone") << ""
                                          << "A" << true;
        QTest::newRow("of the hole alone") << "A"
                                           << "" << true;
        QTest::newRow("two") << "A"
                             << "B" << false;
    }
    void nets() {
        QFETCH(QString, hole);
        QFETCH(QString, pad);
        QFETCH(bool, isMeasured);
        Board board;
        const auto netOf = [&](const QString& name) {
            return name.isEmpty() ? NetId{} : name == "A" ? board.a : board.b;
        };
        board.builder.beginLayer(board.top);
        board.builder.addCircle({{0, 0}, 500 * kUm, 0}, of(netOf(pad), model::kPad));
        const AnnularRing ring = board.ring([&] { board.hole({0, 0}, 300 * kUm, netOf(hole)); });
        QCOMPARE(ring.ring.state == RingState::Around, isMeasured);
    }

    void aPadThatIsDrilledAwayIsReportedOncePerHole() {
        Board board;
        for (const LayerId layer : {board.top, board.inner, board.bottom}) {
            board.builder.beginLayer(layer);
            board.builder.addCircle({{0, 0}, 300 * kUm, 0}, of({}, model::kPad));
        }
        board.builder.beginLayer(board.drill);
        board.hole({0, 0}, 300 * kUm, {});
        const auto document = board.builder.finish();
        const RuleReport report = check(*document, 1);
        QCOMPARE(report.findings.size(), std::size_t{1});
        QVERIFY(report.findings[0].reason == FindingReason::PadRemoved);
        QCOMPARE(report.findings[0].layer, board.top);
        QCOMPARE(std::string(toString(report.findings[0].reason)), std::string("the drill removes the whole pad"));
    }

    void aHoleWithoutAnyPadIsReportedOnce() {
        Board board;
        board.builder.beginLayer(board.drill);
        board.hole({0, 0}, 300 * kUm, board.a);
        const auto document = board.builder.finish();
        const RuleReport report = check(*document, 1);
        QCOMPARE(report.findings.size(), std::size_t{1});
        QVERIFY(report.findings[0].reason == FindingReason::NoPad);
        QCOMPARE(model::secondSideOf(*document, report.findings[0]), std::string("(no pad)"));
    }

    void ringsOfSomeHolesAreThoseAmongAll() {
        const Planting planting(1);
        const model::Document& board = *planting.document;
        const LayerId top = planting.planted.front().first;
        std::vector<AnnularRing> expected = model::annularRings(board, top, kFar);
        std::vector<model::ElementId> some;
        std::erase_if(expected, [](const AnnularRing& ring) { return ring.hole.row() % 7 != 0; });
        std::ranges::transform(expected, std::back_inserter(some), &AnnularRing::hole);
        const std::vector<AnnularRing> found = model::annularRings(board, top, some, kFar);
        QVERIFY(!some.empty());
        QCOMPARE(found.size(), expected.size());
        for (std::size_t i = 0; i < found.size(); ++i) {
            QVERIFY(found[i].hole == expected[i].hole && found[i].pad == expected[i].pad);
            QVERIFY(found[i].ring.state == RingState::Around);
            QCOMPARE(found[i].ring.width.distance, expected[i].ring.width.distance);
        }
        QVERIFY(model::annularRings(board, top, {}, kFar).empty());
    }

    /// Random holes and slots with rings of random width, some of them below the limit: exactly those are found.
    void plantedViolationsAreFoundAndNoOthers() {
        for (unsigned seed = 0; seed < 20; ++seed) {
            Planting planting(seed);
            const RuleReport report = check(*planting.document, 100 * kUm);
            QCOMPARE(report.findings.size(), planting.planted.size());
            for (const model::RuleFinding& found : report.findings) {
                const Point at = planting.document->lines[planting.document->elements.geometry[found.a.row()]].a;
                QVERIFY(std::ranges::count(planting.planted, std::pair(found.layer, at)) == 1);
            }
        }
    }
};

QTEST_GUILESS_MAIN(AnnularRingTest)
#include "annular_ring_test.moc"
