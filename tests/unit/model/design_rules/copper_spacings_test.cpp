// Copper beyond the edge of a board, holes that have one middle or make one opening, tracks that bend, and copper
// without a net in between.
#include "model/design_rules/copper_spacings.h"

#include <QtTest>
#include <numbers>

#include "tests/unit/model/design_rules/rule_board.h"
#include "tests/unit/model/hand_made.h"

using namespace hand_made;
using namespace rule_board;
using model::LayerId;
using model::LayerUse;
using model::NetId;
using model::Nm;
using model::Point;
using model::RuleKind;
using model::RuleReport;

namespace {

/// A board of 20 mm by 10 mm with a cut-out of 6 mm by 6 mm in its middle.
void addOutline(Board& board) {
    model::ShapeSketch outline = rectangle({0, 0}, {20 * kMm, 10 * kMm});
    outline.addCircle({10 * kMm, 5 * kMm}, 3 * kMm, true);
    board.builder.setProfile(board.builder.addShape(outline));
}

/// Holes with one middle in two layers of drills, the first one as deep as the board.
class TwoHoles {
public:
    explicit TwoHoles(LayerUse use = LayerUse::Plain, bool isDeep = true) {
        m_second = addDrill(m_board.builder, m_board.top, isDeep ? m_board.bottom : m_board.top);
        m_board.builder.layer(m_second).use = use;
        m_first = m_board.drill;
    }
    TwoHoles& first(Nm diameter, NetId net, int flags) { return add(m_first, diameter, net, flags); }
    TwoHoles& second(Nm diameter, NetId net, int flags) { return add(m_second, diameter, net, flags); }
    TwoHoles& inOneLayer() {
        m_second = m_first;
        return *this;
    }
    [[nodiscard]] NetId a() const { return m_board.a; }
    [[nodiscard]] NetId b() const { return m_board.b; }
    [[nodiscard]] bool arePassed() { return check(*m_board.builder.finish(), RuleKind::HoleToHole, 1).isPassed(); }

private:
    TwoHoles& add(LayerId layer, Nm diameter, NetId net, int flags) {
        if (layer != m_begun) {
            m_board.builder.beginLayer(layer);
            m_begun = layer;
        }
        m_board.builder.addCircle({{0, 0}, diameter, 0}, of(net, flags));
        return *this;
    }

    Board m_board;
    LayerId m_first;
    LayerId m_second;
    LayerId m_begun;  ///< the last one
};

/// What holds for any copper, and for tracks to planes.
model::RuleTable tableOfObjects(RuleKind kind, Nm any, Nm trackToPlane) {
    model::Rule toPlanes{kind, trackToPlane, {}};
    toPlanes.objects = {model::CopperObject::Track, model::CopperObject::Plane};
    return {{}, {{kind, any, {}}, toPlanes}};
}

/// One finding, of the second rule.
void verifyOfSecondRule(const RuleReport& report, Nm distance) {
    QCOMPARE(report.findings.size(), std::size_t{1});
    QCOMPARE(report.findings.front().rule, std::size_t{1});
    QVERIFY(std::abs(report.findings.front().spacing.distance - static_cast<double>(distance)) < 1.0);
}

/// How many tracks meet acutely: one to the left, and one that leaves their common end at 45 degrees above it and
/// bends with a radius of 4 mm.
std::size_t anglesWithArc(bool bendsDown) {
    Board board;
    board.builder.beginLayer(board.top);
    board.builder.addLine({{-5 * kMm, 0}, {0, 0}, 250 * kUm, 0}, of(board.a));
    const double radius = 4e6;
    const double start = bendsDown ? std::numbers::pi / 4 : -3 * std::numbers::pi / 4;
    const double side = bendsDown ? 1.0 : -1.0;
    const base::PointD centre{-radius * std::cos(start), -radius * std::sin(start)};
    const double end = start + side * 40.0 * std::numbers::pi / 180.0;
    model::PathNode node;
    node.point = {0, 0};
    node.centre = {static_cast<Nm>(std::lround(centre.x)), static_cast<Nm>(std::lround(centre.y))};
    node.edge = bendsDown ? model::EdgeKind::ArcCounterClockwise : model::EdgeKind::ArcClockwise;
    const Point last{static_cast<Nm>(std::lround(centre.x + radius * std::cos(end))),
                     static_cast<Nm>(std::lround(centre.y + radius * std::sin(end)))};
    board.builder.addArc({node, last, 250 * kUm, 0}, of(board.a));
    return check(*board.builder.finish(), RuleKind::AcuteAngle, 0).findings.size();
}

}  // namespace

class CopperSpacingsTest : public QObject {
    Q_OBJECT

private slots:
    void copperBeyondTheEdgeKeepsNoDistance() {
        for (const Point at : {Point{20 * kMm + 750 * kUm, 5 * kMm}, {24 * kMm, 5 * kMm}, {10 * kMm, 5 * kMm}}) {
            Board board;
            addOutline(board);
            board.builder.beginLayer(board.top);
            board.builder.addCircle({at, 100 * kUm, 0}, of(board.a));
            const RuleReport report = check(*board.builder.finish(), RuleKind::CopperToEdge, 200 * kUm);
            QCOMPARE(report.findings.size(), std::size_t{1});
            QCOMPARE(report.findings.front().spacing.distance, 0.0);
        }
    }

    void copperBesideTheEdgeIsFoundOnce() {
        Board board;
        addOutline(board);
        board.builder.beginLayer(board.top);
        board.builder.addCircle({{20 * kMm + 100 * kUm, 5 * kMm}, 100 * kUm, 0}, of(board.a));  // beyond
        board.builder.addCircle({{20 * kMm, 8 * kMm}, 100 * kUm, 0}, of(board.a));              // across
        board.builder.addCircle({{10 * kMm, kMm}, 100 * kUm, 0}, of(board.a));                  // within
        const RuleReport report = check(*board.builder.finish(), RuleKind::CopperToEdge, 200 * kUm);
        QCOMPARE(report.findings.size(), std::size_t{2});
        QCOMPARE(report.findings.back().spacing.distance, 0.0);
    }

    /// The box around the copper touches what it is around.
    void nothingIsHeldAgainstAnOutlineThatIsAssumed() {
        Board board;
        addOutline(board);
        board.builder.setProfile(board.builder.soFar().profile, model::Source::Assumed);
        board.builder.beginLayer(board.top);
        board.builder.addCircle({{20 * kMm, 8 * kMm}, 100 * kUm, 0}, of(board.a));
        const RuleReport report = check(*board.builder.finish(), RuleKind::CopperToEdge, 200 * kUm);
        QVERIFY(report.isPassed() && !report.isComplete());
        QCOMPARE(model::textOf(report.unchecked.at(0)),
                 std::string("1 copper element: the outline of the board is assumed"));
    }

    /// Frames and coupons beside a board are none of its copper.
    void copperOfNoNetBeyondTheEdgeIsCounted() {
        Board board;
        addOutline(board);
        board.builder.beginLayer(board.top);
        board.builder.addLine({{-kMm, -kMm}, {21 * kMm, -kMm}, 100 * kUm, 0}, {});
        const RuleReport report = check(*board.builder.finish(), RuleKind::CopperToEdge, 200 * kUm);
        QVERIFY(report.isPassed() && report.isComplete());
        QVERIFY(std::ranges::any_of(report.notes, [](const std::string& note) {
            return note == "1 copper element of no named net lies beyond the board outline on layer top";
        }));
    }

    /// Names of nets that follow from the copper say nothing: a text has one, too.
    void copperOfANumberedNetCountsWhereSomeOfItIsOnTheBoard() {
        for (const bool isOnBoard : {false, true}) {
            Board board;
            addOutline(board);
            const model::NetId net = board.builder.addNet("$7");
            board.builder.beginLayer(board.top);
            board.builder.addLine({{-kMm, -kMm}, {21 * kMm, -kMm}, 100 * kUm, 0}, of(net));
            if (isOnBoard) {
                board.builder.addCircle({{2 * kMm, 2 * kMm}, 100 * kUm, 0}, of(net));
            }
            const RuleReport report = check(*board.builder.finish(), RuleKind::CopperToEdge, 200 * kUm);
            QCOMPARE(report.findings.size(), isOnBoard ? std::size_t{1} : std::size_t{0});
        }
    }

    void withoutNetsNobodyKnowsWhoseItIs() {
        model::DocumentBuilder builder;
        builder.setProfile(builder.addShape(rectangle({0, 0}, {20 * kMm, 10 * kMm})));
        builder.beginLayer(addLayer(builder, "top", model::LayerType::Signal));
        builder.addLine({{-kMm, -kMm}, {21 * kMm, -kMm}, 100 * kUm, 0}, {});
        const RuleReport report = check(*builder.finish(), RuleKind::CopperToEdge, 200 * kUm);
        QVERIFY(report.isPassed() && !report.isComplete());
    }

    /// Tracks that lead to the ring are other copper, and so is a pad that the hole takes a bite of.
    void theRingOfAnNpthIsItsOwn() {
        Board board;
        board.builder.beginLayer(board.top);
        board.builder.addCircle({{0, 0}, 2 * kMm, 0}, of({}, model::kPad));
        board.builder.addCircle({{9 * kMm, 0}, 2 * kMm, 0}, of({}, model::kPad));
        board.builder.addLine({{-5 * kMm, 0}, {-600 * kUm, 0}, 100 * kUm, 0}, of(board.a));
        board.builder.beginLayer(board.drill);
        board.builder.addCircle({{0, 0}, kMm, kMm}, of({}, kBare));
        board.builder.addCircle({{9 * kMm, kMm}, kMm, kMm}, of({}, kBare));
        const RuleReport report = check(*board.builder.finish(), RuleKind::CopperToHole, 200 * kUm);
        QCOMPARE(report.findings.size(), std::size_t{2});
        QCOMPARE(report.findings[0].a, model::ElementId{1});
        QCOMPARE(report.findings[1].a, model::ElementId{2});
    }

    /// In the middle of a pad too: nothing of it is a ring of the hole's own.
    void aPlatedHoleIsNoneOfAnotherNetsPad() {
        Board board;
        board.builder.beginLayer(board.top);
        board.builder.addCircle({{0, 0}, 2 * kMm, 0}, of(board.a, model::kPad));
        board.builder.beginLayer(board.drill);
        board.builder.addCircle({{0, 0}, kMm, kMm}, of(board.b, kWall));
        const auto document = board.builder.finish();
        QVERIFY(!check(*document, RuleKind::CopperToHole, 200 * kUm).isPassed());
    }

    /// A pad of KiCad with an offset: its copper and its hole are of one line of the file.
    void aHoleMayLieOffTheMiddleOfItsPad() {
        for (const bool isOneRecord : {true, false}) {
            Board board;
            model::DocumentBuilder::Origin pad = of({}, model::kPad);
            pad.line = 7;
            board.builder.beginLayer(board.top);
            board.builder.addCircle({{0, 0}, 3 * kMm, 0}, pad);
            model::DocumentBuilder::Origin hole = of({}, kBare);
            hole.line = isOneRecord ? 7 : 8;
            board.builder.beginLayer(board.drill);
            board.builder.addCircle({{500 * kUm, 0}, kMm, kMm}, hole);
            QCOMPARE(check(*board.builder.finish(), RuleKind::CopperToHole, 200 * kUm).isPassed(), isOneRecord);
        }
    }

    void holesInHolesAreFound() {
        TwoHoles nets;
        QVERIFY2(!nets.first(300 * kUm, nets.a(), kWall).second(300 * kUm, nets.b(), kWall).arePassed(), "two nets");
        QVERIFY2(!TwoHoles().first(300 * kUm, {}, kBare).second(500 * kUm, {}, kBare).arePassed(), "two sizes");
        TwoHoles plating;
        QVERIFY2(!plating.first(300 * kUm, plating.a(), kWall).second(kMm, {}, kBare).arePassed(),
                 "an NPTH over a via");
        TwoHoles twice;
        twice.inOneLayer();
        QVERIFY2(!twice.first(300 * kUm, twice.a(), kWall).second(300 * kUm, twice.a(), kWall).arePassed(),
                 "twice in one layer");
    }

    void holesMayBeMeantToHaveOneMiddle() {
        TwoHoles listed;
        QVERIFY2(listed.first(300 * kUm, listed.a(), kWall).second(300 * kUm, listed.a(), kWall).arePassed(),
                 "in two layers");
        for (const LayerUse use : {LayerUse::Backdrill, LayerUse::DualDiameter}) {
            TwoHoles wider(use, false);
            QVERIFY(wider.first(300 * kUm, wider.a(), kWall).second(500 * kUm, {}, kBare).arePassed());
        }
    }

    /// An L of two slots is one opening; a drilled hole at the end of one, another plating or net, the same slot twice
    /// and slots with a web between them are not.
    void milledSlotsMayMakeOneOpening() {
        const auto arePassed = [](Nm upTo, int flags, bool isOneNet, bool isTwice = false) {
            Board board;
            board.builder.beginLayer(board.drill);
            board.builder.addLine({{0, 0}, {5 * kMm, 0}, kMm, 0}, of(board.a, kWall));
            const Point end = isTwice ? Point{5 * kMm, 0} : Point{0, 5 * kMm};
            board.builder.addLine({{0, upTo}, end, kMm, 0}, of(isOneNet ? board.a : board.b, flags));
            return check(*board.builder.finish(), RuleKind::HoleToHole, 200 * kUm).isPassed();
        };
        QVERIFY(arePassed(0, kWall, true));
        QVERIFY(!arePassed(0, kWall, false));
        QVERIFY(!arePassed(0, kBare, true));
        QVERIFY(!arePassed(0, kWall, true, true));
        QVERIFY(!arePassed(kMm + 100 * kUm, kWall, true));
        Board board;
        board.builder.beginLayer(board.drill);
        board.builder.addLine({{0, 0}, {5 * kMm, 0}, kMm, 0}, of({}, kBare));
        board.builder.addCircle({{5 * kMm, 0}, 2 * kMm, 2 * kMm}, of({}, kBare));
        QVERIFY(!check(*board.builder.finish(), RuleKind::HoleToHole, 200 * kUm).isPassed());
    }

    void viasMayBeStackedOnALayer() {
        for (const bool isOneNet : {true, false}) {
            model::DocumentBuilder builder;
            std::vector<LayerId> copper;
            for (const char* name : {"top", "inner", "bottom"}) {
                copper.push_back(addLayer(builder, name, model::LayerType::Signal));
            }
            const LayerId upper = addDrill(builder, copper[0], copper[1]);
            const LayerId lower = addDrill(builder, copper[1], copper[2]);
            const NetId a = builder.addNet("A");
            const NetId b = builder.addNet("B1");
            builder.beginLayer(upper);
            builder.addCircle({{0, 0}, 100 * kUm, 0}, of(a, kWall));
            builder.beginLayer(lower);
            builder.addCircle({{0, 0}, 200 * kUm, 0}, of(isOneNet ? a : b, kWall));
            QCOMPARE(check(*builder.finish(), RuleKind::HoleToHole, 1).isPassed(), isOneNet);
        }
    }

    void arcsMeetTracksAcutelyWhicheverWayTheyBend() {
        QCOMPARE(anglesWithArc(true), std::size_t{1});
        QCOMPARE(anglesWithArc(false), std::size_t{1});
    }

    /// Tracks of two nets are closer to each other than one of them to a plane, and may be.
    void aCloserPairThatPassesHidesNone() {
        Board board;
        board.builder.beginLayer(board.top);
        board.builder.addLine({{0, 0}, {kMm, 0}, 100 * kUm, 0}, of(board.a));
        board.builder.addLine({{0, 220 * kUm}, {kMm, 220 * kUm}, 100 * kUm, 0}, of(board.b));
        const auto plane = board.builder.addShape(rectangle({0, -kMm}, {kMm, -180 * kUm}));
        board.builder.addArea({plane, {}}, of(board.b));
        const auto document = board.builder.finish();
        verifyOfSecondRule(check(*document, tableOfObjects(RuleKind::CopperToCopper, 100 * kUm, 150 * kUm)), 130 * kUm);
        const RuleReport both = check(*document, tableOfObjects(RuleKind::CopperToCopper, 121 * kUm, 150 * kUm));
        QCOMPARE(both.counts, (std::vector<std::size_t>{1, 1}));
    }

    void aShorterCreepageThatPassesHidesNone() {
        Board board;
        board.builder.layer(board.top).side = model::LayerSide::Top;
        board.builder.layer(board.bottom).side = model::LayerSide::Bottom;
        board.builder.setProfile(board.builder.addShape(rectangle({-9 * kMm, -9 * kMm}, {9 * kMm, 9 * kMm})));
        board.builder.beginLayer(board.top);
        const auto plane = [&](Nm from, Nm to, NetId net) {
            board.builder.addArea({board.builder.addShape(rectangle({from, 0}, {to, kMm})), {}}, of(net));
        };
        plane(0, kMm, board.a);
        plane(2500 * kUm, 3500 * kUm, board.b);
        board.builder.addLine({{-2100 * kUm, 0}, {-2100 * kUm, kMm}, 200 * kUm, 0}, of(board.b));
        verifyOfSecondRule(check(*board.builder.finish(), tableOfObjects(RuleKind::Creepage, kMm, 3 * kMm)), 2 * kMm);
    }

    /// 2 mm between two nets, 1 mm of them over copper of no net.
    void creepageOverCopperOfNoNetIsWhatIsLeft() {
        Board board;
        board.builder.layer(board.top).side = model::LayerSide::Top;
        board.builder.layer(board.bottom).side = model::LayerSide::Bottom;
        board.builder.setProfile(board.builder.addShape(rectangle({-9 * kMm, -9 * kMm}, {9 * kMm, 9 * kMm})));
        const auto pad = [&](Nm from, Nm to, NetId net) {
            board.builder.addArea({board.builder.addShape(rectangle({from, -kMm}, {to, kMm})), {}}, of(net));
        };
        board.builder.beginLayer(board.top);
        pad(-3 * kMm, -kMm, board.a);
        pad(-500 * kUm, 500 * kUm, {});
        pad(kMm, 3 * kMm, board.b);
        verifyNarrowest(*board.builder.finish(), RuleKind::Creepage, kMm);
    }
};

QTEST_APPLESS_MAIN(CopperSpacingsTest)
#include "copper_spacings_test.moc"
