// What hangs together, and how that differs from the nets.
#include "model/nets/connectivity.h"

#include <QtTest>
#include <random>

#include "model/base/parallel.h"
#include "model/board/document_builder.h"
#include "model/nets/net_check.h"
#include "model/nets/net_inference.h"
#include "tests/unit/model/hand_made.h"

using namespace hand_made;
using model::Connectivity;
using model::DocumentBuilder;
using model::ElementId;
using model::LayerId;
using model::NetId;
using model::Nm;
using model::Point;

namespace {

/// A board of copper layers with a drill layer through all of them and a blind one through the first two.
class Board {
public:
    explicit Board(int copper = 3) {
        model::Layer layer;
        layer.type = model::LayerType::Signal;
        for (int i = 0; i < copper; ++i) {
            m_copper.push_back(m_builder.addLayer(layer));
        }
        layer.type = model::LayerType::Drill;
        layer.spanTop = m_copper.front();
        layer.spanBottom = m_copper.back();
        m_drill = m_builder.addLayer(layer);
        layer.spanBottom = m_copper[1];
        m_blind = m_builder.addLayer(layer);
    }
    void on(int copper) { m_builder.beginLayer(m_copper[static_cast<std::size_t>(copper)]); }
    void onDrill() { m_builder.beginLayer(m_drill); }
    void onBlind() { m_builder.beginLayer(m_blind); }
    NetId net(const std::string& name) { return m_builder.addNet(name); }

    ElementId pad(Point p, NetId net = {}, Nm size = kMm) {
        return m_builder.addCircle({p, size, 0}, of(net, model::kPad));
    }
    ElementId hole(Point p, bool isPlated = true, NetId net = {}, Nm size = kMm / 2) {
        const int flags = model::kHole | (isPlated ? model::kPlated : 0);
        return m_builder.addCircle({p, size, size}, of(net, flags));
    }
    ElementId line(Point a, Point b, NetId net = {}) { return m_builder.addLine({a, b, 200'000, 0}, of(net, 0)); }
    ElementId chain(std::span<const Point> points, NetId net) {
        std::vector<model::PathNode> nodes;
        for (const Point point : points) {
            nodes.push_back({point, {}, model::EdgeKind::Line});
        }
        return m_builder.addTrail(nodes, std::vector<Nm>(points.size() - 1, 200'000), of(net, 0));
    }
    ElementId arc(Point a, Point b, Point centre, NetId net) {
        return m_builder.addArc({{a, centre, model::EdgeKind::ArcClockwise}, b, 200'000}, of(net, 0));
    }
    ElementId twoIslands(Point p, NetId net = {}) {
        model::ShapeSketch sketch;
        sketch.addCircle(p, kMm, false);
        sketch.addCircle({p.x + 10 * kMm, p.y}, kMm, false);
        return m_builder.addArea({m_builder.addShape(sketch), {}}, of(net, 0));
    }
    void point(const std::string& net, Point at) {
        model::NetPoint point;
        point.name = m_builder.string(net);
        point.position = at;
        point.side = model::LayerSide::Top;
        m_builder.addNetPoint(point);
    }
    /// A component with pins 1, 2, …; pads belong to them by place and net.
    void part(const std::string& refdes, const std::vector<std::pair<Point, NetId>>& places,
              const std::vector<std::pair<std::string, std::string>>& properties = {}) {
        std::vector<model::Pin> pins;
        for (const auto& [at, net] : places) {
            model::Pin pin;
            pin.name = m_builder.string(std::to_string(pins.size() + 1));
            pin.position = at;
            pin.net = net;
            pins.push_back(pin);
        }
        std::vector<model::Property> rows;
        for (const auto& [name, value] : properties) {
            rows.push_back({m_builder.string(name), m_builder.string(value)});
        }
        model::Component component;
        component.refdes = refdes;
        component.properties = m_builder.addProperties(rows);
        m_builder.addComponent(component, pins);
    }
    ElementId areaPad(Point p, NetId net) {
        model::ShapeSketch sketch;
        sketch.addCircle(p, kMm, false);
        return m_builder.addArea({m_builder.addShape(sketch), {}}, of(net, model::kPad));
    }
    std::shared_ptr<const model::Document> finish() { return m_builder.finish(); }
    [[nodiscard]] LayerId copper(int i) const { return m_copper[static_cast<std::size_t>(i)]; }

private:
    DocumentBuilder m_builder;
    std::vector<LayerId> m_copper;
    LayerId m_drill;
    LayerId m_blind;
};

Connectivity connectivityOf(const model::Document& document) {
    base::Progress progress;
    auto connectivity = Connectivity::of(document, progress);
    return std::move(*connectivity);
}

model::NetReport reportOf(const model::Document& document) {
    return checkNets(document, connectivityOf(document));
}

/// "A B" for each short.
QStringList shortsOf(const model::Document& document) {
    QStringList shorts;
    for (const model::ShortedNets& entry : reportOf(document).shorts) {
        shorts << QString::fromStdString(document.nets[entry.a.row()].name + ' ' + document.nets[entry.b.row()].name);
    }
    return shorts;
}

QStringList opensOf(const model::Document& document) {
    QStringList opens;
    for (const model::OpenNet& open : reportOf(document).opens) {
        opens << QString::fromStdString(document.nets[open.net.row()].name);
    }
    return opens;
}

/// Island of the first piece of an element.
std::uint32_t islandOf(const Connectivity& c, ElementId element) {
    for (std::uint32_t piece = 0; piece < c.pieceCount(); ++piece) {
        if (c.element(piece) == element) {
            return c.island(piece);
        }
    }
    return 0xffffffff;
}

}  // namespace

class ConnectivityTest : public QObject {
    Q_OBJECT

private slots:
    /// Tracks are 0.2 mm wide.
    void holesWithoutPlatingSeverTracks() {
        Board board;
        const NetId cut = board.net("CUT");
        const NetId bent = board.net("BENT");
        const NetId beside = board.net("BESIDE");
        const NetId narrow = board.net("NARROW");
        const NetId blind = board.net("BLIND");
        const NetId around = board.net("AROUND");
        board.on(0);
        const auto rowOf = [](int row) { return row * 10 * kMm; };
        const auto lead = [&](NetId net, int row) {
            board.pad({-5 * kMm, rowOf(row)}, net);
            board.pad({5 * kMm, rowOf(row)}, net);
            return board.line({-5 * kMm, rowOf(row)}, {5 * kMm, rowOf(row)}, net);
        };
        const ElementId track = lead(cut, 0);
        lead(beside, 1);
        lead(narrow, 2);
        lead(around, 3);
        board.line({-5 * kMm, rowOf(3)}, {0, rowOf(3) + 4 * kMm}, around);
        board.line({0, rowOf(3) + 4 * kMm}, {5 * kMm, rowOf(3)}, around);
        board.pad({-5 * kMm, rowOf(4)}, bent);  // two tracks that end in a hole
        board.pad({0, rowOf(4) + 5 * kMm}, bent);
        board.line({-5 * kMm, rowOf(4)}, {0, rowOf(4)}, bent);
        board.line({0, rowOf(4)}, {0, rowOf(4) + 5 * kMm}, bent);
        board.on(2);
        board.pad({-5 * kMm, rowOf(5)}, blind);
        board.pad({5 * kMm, rowOf(5)}, blind);
        board.line({-5 * kMm, rowOf(5)}, {5 * kMm, rowOf(5)}, blind);
        board.onDrill();
        board.hole({0, 0}, false);
        board.hole({0, rowOf(1) + 151'000}, false);     // leaves 1 µm of the track
        board.hole({0, rowOf(2)}, false, {}, 200'000);  // as wide as the track: its sides are left as points
        board.hole({0, rowOf(3)}, false);
        board.hole({0, rowOf(4)}, false);
        board.onBlind();
        board.hole({0, rowOf(5)}, false);
        const auto document = board.finish();
        QCOMPARE(opensOf(*document), (QStringList{"CUT", "BENT"}));
        const Connectivity c = connectivityOf(*document);
        int parts = 0;
        for (std::uint32_t piece = 0; piece < c.pieceCount(); ++piece) {
            parts += c.element(piece) == track ? 1 : 0;
        }
        QCOMPARE(parts, 2);
    }

    void holesWithoutPlatingSeverTrackChainsAndArcs() {
        Board board;
        const NetId chain = board.net("CHAIN");
        const NetId arc = board.net("ARC");
        board.on(0);
        const std::vector<Point> bends{{0, 0}, {kMm, 0}, {kMm, kMm}, {2 * kMm, kMm}};
        board.chain(bends, chain);
        board.pad({0, 0}, chain);
        board.pad({2 * kMm, kMm}, chain);
        board.arc({0, 10 * kMm}, {10 * kMm, 10 * kMm}, {5 * kMm, 10 * kMm}, arc);
        board.pad({0, 10 * kMm}, arc);
        board.pad({10 * kMm, 10 * kMm}, arc);
        board.onDrill();
        board.hole({kMm, kMm}, false);  // at a bend
        board.hole({5 * kMm, 15 * kMm}, false);
        board.hole({5 * kMm, 5 * kMm}, false);
        QCOMPARE(opensOf(*board.finish()), (QStringList{"CHAIN", "ARC"}));
    }

    void copperOfOneLayerThatTouchesHangsTogether() {
        Board board;
        board.on(0);
        const ElementId a = board.pad({0, 0});
        const ElementId b = board.line({0, 0}, {5 * kMm, 0});
        const ElementId c = board.pad({5 * kMm + 600'000, 0});            // touches the stroke's round end exactly
        const ElementId d = board.pad({5 * kMm + 600'000 + kMm + 1, 0});  // 1 nm away
        board.on(1);
        const ElementId e = board.pad({0, 0});  // right above, on another layer
        const auto document = board.finish();
        const Connectivity connectivity = connectivityOf(*document);
        QCOMPARE(connectivity.pieceCount(), std::size_t{5});
        QCOMPARE(connectivity.islandCount(), std::size_t{3});
        QCOMPARE(islandOf(connectivity, b), islandOf(connectivity, a));
        QCOMPARE(islandOf(connectivity, c), islandOf(connectivity, a));
        QVERIFY(islandOf(connectivity, d) != islandOf(connectivity, a));
        QVERIFY(islandOf(connectivity, e) != islandOf(connectivity, a));
        QCOMPARE(connectivity.contacts().size(), std::size_t{2});
    }

    void platedHolesJoinTheLayersTheyPass() {
        Board board;
        std::vector<ElementId> pads;
        for (int layer = 0; layer < 3; ++layer) {
            board.on(layer);
            for (const Nm x : {0, 10, 20}) {
                pads.push_back(board.pad({x * kMm, 0}));
            }
        }
        board.onDrill();
        board.hole({0, 0});
        board.hole({20 * kMm, 0}, false);  // not plated
        board.onBlind();
        board.hole({10 * kMm, 0});
        const auto document = board.finish();
        const Connectivity c = connectivityOf(*document);
        QCOMPARE(c.islandCount(), std::size_t{6});  // 1 through, 2 of the blind one, 3 without plating
        QCOMPARE(islandOf(c, pads[0]), islandOf(c, pads[6]));
        QCOMPARE(islandOf(c, pads[1]), islandOf(c, pads[4]));
        QVERIFY(islandOf(c, pads[1]) != islandOf(c, pads[7]));
        QVERIFY(islandOf(c, pads[2]) != islandOf(c, pads[5]));
        QCOMPARE(c.contacts().size(), std::size_t{5});
    }

    void islandsOfOneAreaAreApart() {
        Board board;
        board.on(0);
        const ElementId area = board.twoIslands({0, 0});
        const ElementId pad = board.pad({10 * kMm, 0});
        const auto document = board.finish();
        const Connectivity c = connectivityOf(*document);
        QCOMPARE(c.pieceCount(), std::size_t{3});
        QCOMPARE(c.islandCount(), std::size_t{2});
        QVERIFY(islandOf(c, area) != islandOf(c, pad));
    }

    void piecesAreFoundByPlace() {
        Board board;
        board.on(0);
        const ElementId pad = board.pad({0, 0});
        board.on(1);
        board.pad({0, 0});
        const auto document = board.finish();
        const Connectivity c = connectivityOf(*document);
        QCOMPARE(c.piecesAt(board.copper(0), {400'000, 0}, 0).size(), std::size_t{1});
        QCOMPARE(c.element(c.piecesAt(board.copper(0), {400'000, 0}, 0)[0]), pad);
        QVERIFY(c.piecesAt(board.copper(0), {600'000, 0}, 0).empty());
        QCOMPARE(c.piecesAt(board.copper(0), {600'000, 0}, 100'000).size(), std::size_t{1});
        QVERIFY(c.piecesAt(board.copper(2), {0, 0}, 0).empty());
    }

    void anOpenNetNamesItsIslands() {
        Board board;
        const NetId a = board.net("A");
        const NetId b = board.net("B");
        board.on(0);
        board.pad({0, 0}, a);
        const ElementId lone = board.pad({9 * kMm, 0}, a);
        board.line({0, 0}, {3 * kMm, 0}, a);
        board.line({20 * kMm, 0}, {23 * kMm, 0}, a);
        board.pad({0, 9 * kMm}, b);
        const auto document = board.finish();
        const model::NetReport report = checkNets(*document, connectivityOf(*document));
        QCOMPARE(report.opens.size(), std::size_t{1});
        QCOMPARE(report.opens[0].net, a);
        const auto islands = report.islandsOf(report.opens[0]);
        QCOMPARE(islands.size(), std::size_t{3});
        QCOMPARE(islands[0].pieceCount, 2U);
        QCOMPARE(islands[1].element, lone);
        QCOMPARE(islands[1].location.x, 9.0 * kMm);
        QCOMPARE(islands[1].padCount, 1U);
        QCOMPARE(islands[2].padCount, 0U);
        QVERIFY(report.shorts.empty());
    }

    /// Not at a corner of its outline.
    void anIslandThatBeginsWithAPadIsAtTheMiddleOfIt() {
        Board board;
        const NetId a = board.net("A");
        board.on(0);
        board.areaPad({0, 0}, a);
        board.areaPad({9 * kMm, 5 * kMm}, a);
        const auto document = board.finish();
        const model::NetReport report = checkNets(*document, connectivityOf(*document));
        QCOMPARE(report.islands.size(), std::size_t{2});
        QCOMPARE(report.islands[1].location.x, 9.0 * kMm);
        QCOMPARE(report.islands[1].location.y, 5.0 * kMm);
    }

    void aNetThatIsClosedThroughAHoleIsNotOpen() {
        Board board;
        const NetId a = board.net("A");
        board.on(0);
        board.pad({0, 0}, a);
        board.on(2);
        board.pad({0, 0}, a);
        board.onDrill();
        board.hole({0, 0});
        const auto document = board.finish();
        QVERIFY(checkNets(*document, connectivityOf(*document)).opens.empty());
    }

    void netsThatTouchAreShorted() {
        Board board;
        const NetId a = board.net("A");
        const NetId b = board.net("B");
        board.on(0);
        const ElementId second = board.line({0, -kMm}, {0, kMm}, b);
        const ElementId first = board.line({-kMm, 0}, {kMm, 0}, a);
        board.line({-kMm, 500'000}, {kMm, 500'000}, a);
        board.on(1);
        board.pad({0, 0}, a);
        board.pad({900'000, 0}, b);
        const auto document = board.finish();
        const model::NetReport report = checkNets(*document, connectivityOf(*document));
        QCOMPARE(report.shorts.size(), std::size_t{2});
        QCOMPARE(report.shorts[0].a, a);
        QCOMPARE(report.shorts[0].b, b);
        QCOMPARE(report.shorts[0].layer, board.copper(0));
        QCOMPARE(report.shorts[0].contactCount, 2U);
        QCOMPARE(report.shorts[0].elementA, first);
        QCOMPARE(report.shorts[0].elementB, second);
        QVERIFY(std::abs(report.shorts[0].location.x) <= 100'000 && std::abs(report.shorts[0].location.y) <= 100'000);
        QVERIFY(!report.shorts[0].through.isValid());
        QCOMPARE(report.shorts[1].layer, board.copper(1));
        // The nets are still open between the layers, each counted by itself.
        QCOMPARE(report.opens.size(), std::size_t{2});
    }

    void copperWithoutANetMayJoinTwo() {
        Board board;
        const NetId a = board.net("A");
        const NetId b = board.net("B");
        board.on(0);
        board.pad({0, 0}, a);
        const ElementId bridge = board.line({0, 0}, {3 * kMm, 0});
        board.line({3 * kMm, 0}, {6 * kMm, 0});
        board.pad({6 * kMm, 0}, b);
        const auto document = board.finish();
        const model::NetReport report = checkNets(*document, connectivityOf(*document));
        QCOMPARE(report.shorts.size(), std::size_t{1});
        QVERIFY(report.shorts[0].through.isValid());
        QVERIFY(report.shorts[0].through.row() >= bridge.row());
    }

    void oneAndManyThreadsAgree() {
        std::mt19937 random(3);
        Board board(4);
        const NetId nets[] = {board.net("A"), board.net("B"), NetId{}};
        std::uniform_int_distribution<Nm> place(0, 40 * kMm);
        const auto point = [&] { return Point{place(random), place(random)}; };
        for (int layer = 0; layer < 4; ++layer) {
            board.on(layer);
            for (int i = 0; i < 900; ++i) {
                const Point p = point();
                board.line(p, {p.x + place(random) / 20, p.y + place(random) / 20}, nets[random() % 3]);
                board.pad(point(), nets[random() % 3], 300'000);
            }
        }
        board.onDrill();
        for (int i = 0; i < 700; ++i) {
            board.hole(point());
        }
        const auto document = board.finish();
        const Connectivity many = connectivityOf(*document);
        const base::ThreadLimit limit(1);
        const Connectivity one = connectivityOf(*document);
        QCOMPARE(one.contacts().size(), many.contacts().size());
        QVERIFY(one.contacts().size() > 1000);
        for (std::size_t i = 0; i < one.contacts().size(); ++i) {
            const auto& x = one.contacts()[i];
            const auto& y = many.contacts()[i];
            QVERIFY(x.a == y.a && x.b == y.b && x.location.x == y.location.x && x.location.y == y.location.y &&
                    x.layer == y.layer);
        }
        for (std::uint32_t piece = 0; piece < one.pieceCount(); ++piece) {
            QCOMPARE(one.island(piece), many.island(piece));
        }
    }

    void itCanBeCancelled() {
        Board board;
        board.on(0);
        board.pad({0, 0});
        const auto document = board.finish();
        base::Progress progress;
        progress.cancel();
        const auto result = Connectivity::of(*document, progress);
        QVERIFY(!result);
        QCOMPARE(result.error().code, base::ErrorCode::Cancelled);
    }

    /// Nets by the points of a netlist: what carries points of two is a short of both, and either may be open besides.
    void copperWithPointsOfSeveralNetsIsAShort() {
        Board board;
        board.on(0);
        for (const Nm x : {0, 10, 20, 30}) {
            board.pad({x * kMm, 0});
            board.point(x % 20 == 0 ? "A" : "B", {x * kMm, 0});
        }
        board.line({0, 0}, {5 * kMm, 0});
        board.line({5 * kMm, 0}, {10 * kMm, 0});
        base::Progress progress;
        const auto document = *model::withInferredNets(*board.finish(), progress);
        QCOMPARE(shortsOf(*document), QStringList{"A B"});
        QCOMPARE(opensOf(*document), (QStringList{"A", "B"}));
        QVERIFY(std::ranges::any_of(document->diagnostics.entries(), [](const model::Diagnostic& entry) {
            return entry.text.find("points of A and B lie on one island") != std::string::npos;
        }));
    }

    void aPieceWithPointsOfSeveralNetsIsAShort() {
        Board board;
        board.on(0);
        board.line({0, 0}, {10 * kMm, 0});
        board.point("A", {0, 0});
        board.point("B", {10 * kMm, 0});
        base::Progress progress;
        const auto document = *model::withInferredNets(*board.finish(), progress);
        QCOMPARE(shortsOf(*document), QStringList{"A B"});
    }

    void padsOfTwoNetsThatOverlapAreAShort() {
        Board board;
        board.on(0);
        board.pad({0, 0});
        board.pad({kMm / 2, 0});
        board.point("A", {0, 0});
        board.point("B", {kMm / 2, 0});
        base::Progress progress;
        const auto document = *model::withInferredNets(*board.finish(), progress);
        QCOMPARE(shortsOf(*document), QStringList{"A B"});
    }

    void aPinWithoutANetOnCopperOfOneIsListed() {
        Board board;
        const NetId a = board.net("A");
        board.on(0);
        board.pad({0, 0});
        board.line({0, 0}, {5 * kMm, 0});
        board.line({5 * kMm, 0}, {9 * kMm, 0}, a);
        board.pad({20 * kMm, 0});
        board.part("U1", {{{0, 0}, {}}, {{20 * kMm, 0}, {}}});
        const auto document = board.finish();
        const model::NetReport report = reportOf(*document);
        QCOMPARE(report.pinsOnNets.size(), std::size_t{1});
        QCOMPARE(textOf(*document, report.pinsOnNets[0]), std::string("U1.1 has no net and touches A"));
        QCOMPARE(report.pinsOnNets[0].copper, ElementId{2});
        QVERIFY(report.shorts.empty());
    }

    void padsThatAPartJoinsAreNotOpen_data() {
        QTest::addColumn<QString>("property");
        QTest::addColumn<QString>("value");
        QTest::addColumn<QStringList>("opens");
        QTest::newRow("nothing declared") << ""
                                          << "" << QStringList{"A"};
        QTest::newRow("a group") << "jumper_pad_groups"
                                 << "1, 2" << QStringList{};
        QTest::newRow("a group of others") << "jumper_pad_groups"
                                           << "1, 3" << QStringList{"A"};
        QTest::newRow("pads of one number") << "duplicate_pad_numbers_are_jumpers"
                                            << "yes" << QStringList{"A"};
    }
    void padsThatAPartJoinsAreNotOpen() {
        QFETCH(QString, property);
        QFETCH(QString, value);
        QFETCH(QStringList, opens);
        Board board;
        const NetId a = board.net("A");
        board.on(0);
        board.pad({0, 0}, a);
        board.pad({5 * kMm, 0}, a);
        board.pad({9 * kMm, 0}, board.net("B"));
        board.part("JP1", {{{0, 0}, a}, {{5 * kMm, 0}, a}, {{9 * kMm, 0}, board.net("C")}},
                   {{property.toStdString(), value.toStdString()}});
        QCOMPARE(opensOf(*board.finish()), opens);
    }

    void anEmptyBoardHasNoIslands() {
        const auto document = Board().finish();
        const Connectivity c = connectivityOf(*document);
        QCOMPARE(c.islandCount(), std::size_t{0});
        QVERIFY(checkNets(*document, c).opens.empty());
    }
};

QTEST_APPLESS_MAIN(ConnectivityTest)
#include "connectivity_test.moc"
