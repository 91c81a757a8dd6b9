// Nets that a component ties together: no fault of the rule of copper, and the same ties wherever they are looked for.
#include <QtTest>

#include "model/board/pad_group_names.h"
#include "model/clearance/clearance.h"
#include "model/clearance/stackup_clearance.h"
#include "model/nets/net_check.h"
#include "tests/unit/model/design_rules/rule_board.h"

using namespace hand_made;
using namespace rule_board;
using model::NetId;
using model::Nm;
using model::RuleKind;
using model::RuleReport;

class TiedNetsTest : public QObject {
    Q_OBJECT

private slots:
    void netTies_data() {
        QTest::addColumn<QString>("what");
        QTest::addColumn<int>("shorts");
        QTest::addColumn<int>("ties");
        QTest::newRow("pads of a tie") << "pads" << 0 << 1;
        QTest::newRow("pads of a part that nothing calls a tie") << "resistor pads" << 1 << 0;
        QTest::newRow("pads of two components") << "two components" << 1 << 0;
        QTest::newRow("a tie joined by copper without a net") << "bridge" << 0 << 1;
        QTest::newRow("a part that nothing calls a tie, joined so") << "resistor bridge" << 1 << 0;
        QTest::newRow("a tie joined by copper that leads away from it") << "long bridge" << 1 << 0;
        QTest::newRow("tracks beside it") << "tracks" << 1 << 1;
        QTest::newRow("a tie joined by a track") << "joined by a track" << 0 << 1;
        QTest::newRow("a jumper joined by copper without a net") << "jumper bridge" << 0 << 1;
        QTest::newRow("a jumper joined by a track") << "jumper joined by a track" << 1 << 0;
        QTest::newRow("an open jumper joined by copper without a net") << "open jumper bridge" << 1 << 0;
    }
    void netTies() {
        QFETCH(QString, what);
        QFETCH(int, shorts);
        QFETCH(int, ties);
        Board board;
        model::Component part;
        part.refdes = "X1";
        part.part = what.startsWith("resistor")      ? "R0"
                    : what.startsWith("open jumper") ? "SolderJumper-2_Open"
                    : what.startsWith("jumper")      ? "SolderJumper-2_Bridged"
                                                     : "Net-Tie 2";
        const bool isBridge = what.endsWith("bridge");
        const bool isTrack = what.endsWith("track");
        const Nm second = isBridge || isTrack ? 500 * kUm : 90 * kUm;
        board.builder.beginLayer(board.top);
        if (what == "two components") {
            addPart(board, part, {{board.a, {0, 0}}});
            addPart(board, part, {{board.b, {second, 0}}});
        } else {
            addPart(board, part, {{board.a, {0, 0}}, {board.b, {second, 0}}});
        }
        if (isBridge || isTrack) {
            board.builder.addLine({{0, 0}, {second, 0}, 50 * kUm, 0}, of(isTrack ? board.a : NetId{}));
        }
        if (what == "long bridge") {
            board.builder.addLine({{second, 0}, {second, 900 * kUm}, 50 * kUm, 0}, of({}));
        } else if (what == "tracks") {
            board.builder.addLine({{0, 5000 * kUm}, {0, 6000 * kUm}, 50 * kUm, 0}, of(board.a));
            board.builder.addLine({{0, 6000 * kUm}, {0, 7000 * kUm}, 50 * kUm, 0}, of(board.b));
        }
        const auto document = board.builder.finish();
        const RuleReport report = check(*document, RuleKind::CopperToCopper, 50 * kUm);
        QCOMPARE(report.findings.size(), static_cast<std::size_t>(shorts));
        QCOMPARE(report.netTies.size(), static_cast<std::size_t>(ties));
        if (ties > 0) {
            QCOMPARE(model::textOf(*document, report.netTies[0]),
                     std::string("X1 ties A and B1 on top, assumed from its name and its copper"));
        }
    }

    void aTieIsWhatTheCopperJoins_data() {
        QTest::addColumn<int>("bridges");
        QTest::addColumn<QString>("track");
        QTest::addColumn<QStringList>("ties");
        QTest::addColumn<int>("shorts");
        QTest::newRow("one bridge") << 1 << "" << QStringList{"JP3 ties A and B1 on top"} << 0;
        QTest::newRow("one bridge, a track on the pads that it joins")
            << 1 << "joined" << QStringList{"JP3 ties A and B1 on top"} << 0;
        QTest::newRow("one bridge, a track on the open pad")
            << 1 << "open" << QStringList{"JP3 ties A and B1 on top"} << 1;
        QTest::newRow("two bridges") << 2 << "" << QStringList{"JP3 ties A and B1 on top", "JP3 ties A and C on top"}
                                     << 0;
        QTest::newRow("two bridges, a track on the last pad")
            << 2 << "open" << QStringList{"JP3 ties A and B1 on top", "JP3 ties A and C on top"} << 0;
        QTest::newRow("no bridge") << 0 << "" << QStringList{} << 0;
        QTest::newRow("no bridge, a track on the open pad") << 0 << "open" << QStringList{} << 1;
    }
    /// A jumper of three pads that says it is a net tie: rules, the netlist check and the search agree on it.
    void aTieIsWhatTheCopperJoins() {
        QFETCH(int, bridges);
        QFETCH(QString, track);
        QFETCH(QStringList, ties);
        QFETCH(int, shorts);
        Board board;
        const NetId c = board.builder.addNet("C");
        model::Component part;
        part.refdes = "JP3";
        part.part = "net tie solder jumper bridged";
        board.builder.beginLayer(board.top);
        addPart(board, part, {{board.a, {0, 0}}, {board.b, {300 * kUm, 0}}, {c, {600 * kUm, 0}}});
        for (Nm i = 0; i < bridges; ++i) {
            const Nm x = i * 300 * kUm;
            board.builder.addLine({{x, 0}, {x + 150 * kUm, 0}, 40 * kUm, 0}, of({}));
            board.builder.addLine({{x + 150 * kUm, 0}, {x + 300 * kUm, 0}, 40 * kUm, 0}, of({}));
        }
        if (!track.isEmpty()) {
            const Nm x = track == "open" ? 600 * kUm : 300 * kUm;
            board.builder.addLine({{x, 0}, {x, 900 * kUm}, 40 * kUm, 0}, of(board.a));
        }
        const auto document = board.builder.finish();
        for (QString& tie : ties) {
            tie += ", assumed from its name and its copper";
        }

        const auto namesOf = [&](const std::vector<model::NetTie>& found) {
            QStringList names;
            for (const model::NetTie& tie : found) {
                names << QString::fromStdString(model::textOf(*document, tie));
            }
            return names;
        };
        const RuleReport report = check(*document, RuleKind::CopperToCopper, 50 * kUm);
        QCOMPARE(report.findings.size(), static_cast<std::size_t>(shorts));
        QCOMPARE(namesOf(report.netTies), ties);
        base::Progress progress;
        const model::NetReport nets = model::checkAllNets(*document, progress)->front().report;
        QCOMPARE(nets.shorts.size(), static_cast<std::size_t>(shorts));
        QCOMPARE(namesOf(nets.ties), ties);
        model::ClearanceRequest closest;
        closest.below = 50.0 * kUm;
        QCOMPARE(model::smallestClearances(*document, closest, progress)->size(), static_cast<std::size_t>(shorts));
    }

    /// A pad of a tie, and one beside it that a hole is drilled in.
    void aTieKeepsNoDistanceByOtherRulesEither() {
        for (const auto& [part, faults] : {std::pair("Net-Tie 2", 0), std::pair("R0", 1)}) {
            Board board;
            board.builder.layer(board.top).side = model::LayerSide::Top;
            board.builder.layer(board.bottom).side = model::LayerSide::Bottom;
            board.builder.setProfile(board.builder.addShape(rectangle({-kMm, -kMm}, {kMm, kMm})));
            model::Component component;
            component.refdes = "X1";
            component.part = part;
            board.builder.beginLayer(board.top);
            addPart(board, component, {{board.a, {0, 0}}, {board.b, {90 * kUm, 0}}});
            board.builder.beginLayer(board.drill);
            board.builder.addCircle({{90 * kUm, 0}, 60 * kUm, 0}, of(board.b, model::kHole | model::kPlated));
            const auto document = board.builder.finish();
            for (const RuleKind kind : {RuleKind::CopperToCopper, RuleKind::CopperToHole, RuleKind::Creepage}) {
                const RuleReport report = check(*document, kind, 20 * kUm);
                QCOMPARE(report.findings.size(), static_cast<std::size_t>(faults));
                QCOMPARE(report.netTies.size(), std::size_t{1} - report.findings.size());
            }
        }
    }

    /// Nor through the stackup, where what else is close of the two nets is found.
    void aTieIsNotWhereItsNetsAreClosestInSpace() {
        for (const auto& [part, distance] : {std::pair("Net-Tie 2", 300e3), std::pair("R0", 0.0)}) {
            Board board;
            for (const auto& [layer, z] : {std::pair(board.top, kMm), std::pair(board.bottom, 0)}) {
                board.builder.layer(layer).z = z;
                board.builder.layer(layer).thickness = 35 * kUm;
            }
            model::Component component;
            component.refdes = "X1";
            component.part = part;
            board.builder.beginLayer(board.top);
            addPart(board, component, {{board.a, {0, 0}}, {board.b, {90 * kUm, 0}}});
            board.builder.addLine({{0, 3000 * kUm}, {kMm, 3000 * kUm}, 100 * kUm, 0}, of(board.a));
            board.builder.addLine({{0, 3400 * kUm}, {kMm, 3400 * kUm}, 100 * kUm, 0}, of(board.b));
            base::Progress progress;
            const auto found = *model::smallestThroughStackup(*board.builder.finish(), {}, progress);
            QCOMPARE(found.size(), std::size_t{1});
            QVERIFY(std::abs(found.front().spacing.distance - distance) < 1.0);
        }
    }

    void padsOfOnePinAreNoShort_data() {
        QTest::addColumn<QString>("first");
        QTest::addColumn<QString>("second");
        QTest::addColumn<bool>("isOne");
        QTest::newRow("one pin in several pads") << "unconnected-(U1-EP-Pad9)"
                                                 << "unconnected-(U1-EP-Pad9)_7" << true;
        QTest::newRow("two pins") << "unconnected-(U1-A-Pad1)"
                                  << "unconnected-(U1-B-Pad2)" << false;
    }
    /// KiCad makes a net for each pad of a pin that is not connected.
    void padsOfOnePinAreNoShort() {
        QFETCH(QString, first);
        QFETCH(QString, second);
        QFETCH(bool, isOne);
        Board board;
        model::Component part;
        part.refdes = "U1";
        const NetId a = board.builder.addNet(first.toStdString());
        const NetId b = board.builder.addNet(second.toStdString());
        board.builder.beginLayer(board.top);
        addPart(board, part, {{a, {0, 0}}, {b, {50 * kUm, 0}}});
        const auto document = board.builder.finish();
        base::Progress progress;
        const model::NetReport nets = model::checkAllNets(*document, progress)->front().report;
        QCOMPARE(nets.shorts.empty(), isOne);
        QCOMPARE(check(*document, RuleKind::CopperToCopper, 50 * kUm).isPassed(), isOne);
    }

    void whatABoardOfKiCadDeclaresIsATieAndNothingElse_data() {
        QTest::addColumn<QString>("group");
        QTest::addColumn<QStringList>("ties");
        QTest::newRow("all pads") << "1, 2" << QStringList{"NT1 ties A and B1 on top"};
        QTest::newRow("pads of one net") << "1" << QStringList{};
        QTest::newRow("nothing") << "" << QStringList{};
    }
    /// The copper may lead far away: coils are declared so.
    void whatABoardOfKiCadDeclaresIsATieAndNothingElse() {
        QFETCH(QString, group);
        QFETCH(QStringList, ties);
        Board board;
        board.builder.job().version = "KiCad 9 (20241229)";
        model::Component part;
        part.refdes = "NT1";
        part.part = "net tie";
        if (!group.isEmpty()) {
            const model::Property property{board.builder.string(std::string(model::kNetTieGroup)),
                                           board.builder.string(group.toStdString())};
            part.properties = board.builder.addProperties(std::span(&property, 1));
        }
        board.builder.beginLayer(board.top);
        addPart(board, part, {{board.a, {0, 0}}, {board.b, {500 * kUm, 0}}});
        board.builder.addLine({{0, 0}, {500 * kUm, 0}, 50 * kUm, 0}, of({}));
        board.builder.addLine({{0, 0}, {0, 9000 * kUm}, 50 * kUm, 0}, of({}));
        const auto document = board.builder.finish();
        base::Progress progress;
        const model::NetReport nets = model::checkAllNets(*document, progress)->front().report;
        QStringList found;
        for (const model::NetTie& tie : nets.ties) {
            found << QString::fromStdString(model::textOf(*document, tie));
        }
        QCOMPARE(found, ties);
        QCOMPARE(nets.shorts.size(), ties.isEmpty() ? std::size_t{1} : std::size_t{0});
        if (ties.isEmpty()) {
            QCOMPARE(model::textOf(*document, nets.shorts[0]),
                     std::string("are joined by copper without a net between pads of NT1"));
        }
        QCOMPARE(check(*document, RuleKind::CopperToCopper, 50 * kUm).isPassed(), !ties.isEmpty());
    }
};

QTEST_APPLESS_MAIN(TiedNetsTest)
#include "tied_nets_test.moc"
