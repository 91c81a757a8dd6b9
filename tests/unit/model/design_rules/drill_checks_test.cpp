// Sizes of holes and slots and aspect ratios: at exactly their limit and just below, and what is not held against them.
#include "model/design_rules/drill_checks.h"

#include <QJsonArray>
#include <QJsonDocument>
#include <QtTest>
#include <algorithm>
#include <array>
#include <iterator>

#include "model/clearance/side_names.h"
#include "model/clearance/waivers.h"
#include "model/design_rules/waived_check.h"
#include "model/export/clearance_export.h"
#include "tests/unit/model/design_rules/rule_board.h"
#include "tests/unit/model/hand_made.h"

using namespace hand_made;
using namespace rule_board;
using model::DocumentBuilder;
using model::ElementId;
using model::FindingReason;
using model::HoleClass;
using model::LayerId;
using model::Nm;
using model::Point;
using model::Rule;
using model::RuleKind;
using model::RuleReport;
using model::RuleTable;

namespace {

constexpr int kViaWall = kWall | model::kVia;
constexpr Nm kThick = 1600 * kUm;

Rule ruleOf(RuleKind kind, Nm least, HoleClass holes = HoleClass::Any) {
    return {kind, least, {}, true, {holes}};
}

Rule ratioOf(double most) {
    Rule rule{RuleKind::AspectRatio, 0, {}};
    rule.mostRatio = most;
    return rule;
}

std::vector<Point> middlesOf(const model::Document& board, const RuleReport& report) {
    std::vector<Point> middles;
    for (const model::RuleFinding& finding : report.findings) {
        middles.push_back(board.boxOf(finding.a).middle());
    }
    return middles;
}

std::vector<std::string> textsOf(const RuleReport& report) {
    std::vector<std::string> texts;
    std::ranges::transform(report.unchecked, std::back_inserter(texts),
                           [](const model::Unchecked& unchecked) { return model::textOf(unchecked); });
    return texts;
}

/// A via of this drill through a board of this thickness.
std::shared_ptr<const model::Document> viaOf(Nm drill, Nm thickness = kThick) {
    Board board;
    board.builder.job().step = "pcb";
    board.builder.layer(board.drill).thickness = thickness;
    board.builder.beginLayer(board.drill);
    board.builder.addCircle({{kMm, 2 * kMm}, drill, drill / 2}, of(board.a, kViaWall));
    return board.builder.finish();
}

}  // namespace

class DrillChecksTest : public QObject {
    Q_OBJECT

private slots:
    void roundHolesAreAsWideAsTheirDrill() {
        Board board;
        board.builder.beginLayer(board.drill);
        board.builder.addCircle({{0, 0}, 400 * kUm, 350 * kUm}, of(board.a, kViaWall));
        board.builder.addCircle({{3 * kMm, kMm}, 300 * kUm, 250 * kUm}, of(board.a, kViaWall));
        board.builder.addLine({{0, 5 * kMm}, {kMm, 5 * kMm}, 200 * kUm, 0}, of({}, kBare));  // a slot
        const auto document = board.builder.finish();
        verifyNarrowest(*document, RuleKind::HoleSize, 300 * kUm);
        const RuleReport report = check(*document, RuleKind::HoleSize, 301 * kUm);
        const model::RuleFinding& finding = report.findings.front();
        QCOMPARE(finding.layer, board.drill);
        QCOMPARE(finding.a, ElementId{1U});
        QVERIFY(!finding.b.isValid() && finding.reason == FindingReason::TooNarrow);
        for (const model::PointD end : {finding.spacing.from, finding.spacing.to}) {
            QCOMPARE(end.x, 3e6);
            QCOMPARE(end.y, 1e6);
        }
        const auto [first, second] = model::SideNames(*document).of(finding);
        QCOMPARE(model::textOf(first), std::string("A, via, element 1"));
        QVERIFY(second.net.empty());
    }

    /// Straight, bent and routed ones, the last at its narrowest edge.
    void slotsAreAsWideAsTheirNarrowestPart() {
        Board board;
        board.builder.beginLayer(board.drill);
        board.builder.addLine({{0, 0}, {kMm, 0}, 700 * kUm, 600 * kUm}, of(board.a, kWall));
        board.builder.addArc(
            {{{0, 5 * kMm}, {kMm, 5 * kMm}, model::EdgeKind::ArcClockwise}, {2 * kMm, 5 * kMm}, 650 * kUm, 0},
            of({}, kBare));
        const std::vector<model::PathNode> path{
            {{0, 9 * kMm}, {}}, {{2 * kMm, 9 * kMm}, {}}, {{2 * kMm, 11 * kMm}, {}}};
        board.builder.addTrail(path, std::array<Nm, 2>{800 * kUm, 600 * kUm}, of({}, kBare));
        board.builder.addCircle({{0, 20 * kMm}, 300 * kUm, 0}, of({}, kBare));  // a drill
        const auto document = board.builder.finish();
        verifyNarrowest(*document, RuleKind::SlotWidth, 600 * kUm);
        const RuleReport report = check(*document, RuleKind::SlotWidth, 601 * kUm);
        QCOMPARE(report.findings.front().spacing.from.x, 2e6);
        QCOMPARE(report.findings.front().spacing.from.y, 10e6);
        QCOMPARE(check(*document, RuleKind::SlotWidth, kMm).findings.size(), std::size_t{3});
    }

    void kindsOfHolesHaveLimitsOfTheirOwn() {
        Board board;
        board.builder.beginLayer(board.drill);
        board.builder.addCircle({{0, 0}, 100 * kUm, 50 * kUm}, of(board.a, kViaWall));  // a microvia
        board.builder.addCircle({{kMm, 0}, 200 * kUm, 150 * kUm}, of(board.a, kViaWall));
        board.builder.addCircle({{2 * kMm, 0}, 300 * kUm, 0}, of({}, kBare));
        board.builder.addLine({{0, 5 * kMm}, {kMm, 5 * kMm}, 400 * kUm, 350 * kUm}, of(board.b, kWall));
        board.builder.addLine({{0, 9 * kMm}, {kMm, 9 * kMm}, 500 * kUm, 0}, of({}, kBare));
        const auto document = board.builder.finish();
        const auto found = [&](const std::vector<Rule>& rules) {
            std::vector<std::uint32_t> all;
            for (const model::RuleFinding& finding : check(*document, {{}, rules}).findings) {
                all.push_back(finding.a.value);
            }
            return all;
        };
        using Found = std::vector<std::uint32_t>;
        const auto size = RuleKind::HoleSize;
        const auto slot = RuleKind::SlotWidth;
        QCOMPARE(found({ruleOf(size, kMm)}), (Found{0, 1, 2}));
        QCOMPARE(found({ruleOf(size, kMm, HoleClass::Microvia)}), (Found{0}));
        QCOMPARE(found({ruleOf(size, kMm, HoleClass::Plated)}), (Found{1}));
        QCOMPARE(found({ruleOf(size, kMm, HoleClass::NonPlated)}), (Found{2}));
        QCOMPARE(found({ruleOf(slot, kMm)}), (Found{3, 4}));
        QCOMPARE(found({ruleOf(slot, kMm, HoleClass::Plated)}), (Found{3}));
        QCOMPARE(found({ruleOf(slot, kMm, HoleClass::NonPlated)}), (Found{4}));
        QCOMPARE(found({ruleOf(size, 250 * kUm), ruleOf(size, 100 * kUm, HoleClass::Microvia)}), (Found{1}));
        Rule ofNet = ruleOf(slot, kMm);
        ofNet.classes[0] = "net:B*";
        QCOMPARE(found({ofNet}), (Found{3}));
    }

    void holesThatAreTooDeepForTheirDrillAreFound() {
        const RuleTable table{{}, {ratioOf(8)}};
        QVERIFY(check(*viaOf(200 * kUm), table).isPassed());
        QCOMPARE(check(*viaOf(199'999), table).findings.size(), std::size_t{1});
        const RuleReport report = check(*viaOf(160 * kUm), table);
        QVERIFY(report.isComplete());
        QCOMPARE(report.findings.size(), std::size_t{1});
        const model::RuleFinding& finding = report.findings.front();
        QCOMPARE(finding.reason, FindingReason::TooDeep);
        QCOMPARE(finding.depth, 1600e3);
        QCOMPARE(finding.spacing.distance, 160e3);
        QCOMPARE(finding.spacing.from.x, 1e6);
        QCOMPARE(finding.spacing.from.y, 2e6);
        QCOMPARE(model::requiredOf(table.rules[0], finding), 200e3);
        QCOMPARE(model::reasonOf(finding), std::string("10.00 : 1, 1600.0 um deep"));
        const auto withTolerance = [&](Nm tolerance) {
            base::Progress progress;
            return model::checkRules(*viaOf(199'500), {{}, {ratioOf(8)}, tolerance}, progress)->findings.size();
        };
        QCOMPARE(withTolerance(500), std::size_t{0});
        QCOMPARE(withTolerance(499), std::size_t{1});
    }

    /// NPTHs and slots are no plated round holes; a back-drill comes when the hole is plated.
    void onlyPlatedRoundHolesHaveAnAspectRatio() {
        Board board;
        board.builder.layer(board.drill).thickness = kThick;
        model::Layer back;
        back.name = "back";
        back.type = model::LayerType::Drill;
        back.use = model::LayerUse::Backdrill;
        back.spanTop = back.spanBottom = board.bottom;
        const LayerId backDrill = board.builder.addLayer(back);
        board.builder.beginLayer(board.drill);
        const ElementId hole = board.builder.addCircle({{0, 0}, 160 * kUm, 80 * kUm}, of(board.a, kViaWall));
        board.builder.addCircle({{5 * kMm, 0}, 160 * kUm, 0}, of({}, kBare));
        board.builder.addLine({{0, 5 * kMm}, {kMm, 5 * kMm}, 160 * kUm, 80 * kUm}, of(board.a, kWall));
        board.builder.addPlatedSpan({hole, board.top, board.top});
        board.builder.beginLayer(backDrill);
        board.builder.addCircle({{0, 0}, 260 * kUm, 0}, of({}, kBare));
        const auto document = board.builder.finish();
        const RuleReport report = check(*document, RuleTable{{}, {ratioOf(9)}});
        QCOMPARE(report.findings.size(), std::size_t{1});
        QCOMPARE(report.findings[0].a, hole);
        QCOMPARE(report.findings[0].depth, 1600e3);
        QCOMPARE(check(*document, RuleKind::HoleSize, 300 * kUm).findings.size(),
                 std::size_t{2});  // not the back-drill
    }

    /// In two files, or in one of them twice.
    void aHoleThatTheJobHasTwiceCountsOnce() {
        Board board;
        const LayerId again = addDrill(board.builder, board.top, board.bottom);
        const auto add = [&](Nm x, Nm diameter) {
            board.builder.addCircle({{x, 0}, diameter, diameter / 2}, of(board.a, kWall));
        };
        board.builder.beginLayer(board.drill);
        add(0, 300 * kUm);
        add(5 * kMm, 300 * kUm);
        add(5 * kMm, 300 * kUm);
        add(9 * kMm, 300 * kUm);
        board.builder.beginLayer(again);
        add(500, 300'500);        // the first one, rounded apart
        add(9 * kMm, 250 * kUm);  // another drill
        const auto document = board.builder.finish();
        const std::vector<Point> middles = middlesOf(*document, check(*document, RuleKind::HoleSize, 400 * kUm));
        QCOMPARE(middles.size(), std::size_t{4});
        QCOMPARE(std::ranges::count(middles, Point{9 * kMm, 0}), 2);
    }

    void stackedMicroviasAreHolesOfTheirOwn() {
        DocumentBuilder builder;
        const LayerId top = addLayer(builder, "top");
        const LayerId inner = addLayer(builder, "inner");
        const LayerId bottom = addLayer(builder, "bottom");
        const LayerId drills[] = {addDrill(builder, top, inner), addDrill(builder, inner, bottom)};
        const model::NetId net = builder.addNet("A");
        for (const LayerId drill : drills) {
            builder.beginLayer(drill);
            builder.addCircle({{0, 0}, 80 * kUm, 40 * kUm}, of(net, kViaWall));
        }
        const auto document = builder.finish();
        QCOMPARE(check(*document, RuleKind::HoleSize, 100 * kUm).findings.size(), std::size_t{2});
    }

    /// Every step is checked once, however often it is placed: its locations are seen in all copies.
    void holesOfCopiesAreThoseOfTheirStep() {
        const auto drillOf = [](DocumentBuilder& builder) {
            const LayerId top = addLayer(builder, "top");
            return addDrill(builder, top, addLayer(builder, "bottom"));
        };
        DocumentBuilder step;
        step.beginLayer(drillOf(step));
        step.addCircle({{0, 0}, 150 * kUm, 0}, of({}, kBare));
        const auto card = step.finish();
        DocumentBuilder panel;
        panel.beginLayer(drillOf(panel));
        panel.addCircle({{50 * kMm, 0}, 180 * kUm, 0}, of({}, kBare));
        const std::uint32_t row = panel.addStep(card);
        panel.addInstance({row, {{0, 0}}, false});
        panel.addInstance({row, {{10 * kMm, 0}}, false});
        const auto document = panel.finish();
        const RuleReport ofPanel = check(*document, RuleKind::HoleSize, 200 * kUm);
        QCOMPARE(ofPanel.findings.size(), std::size_t{1});
        QCOMPARE(ofPanel.findings[0].spacing.distance, 180e3);
        QVERIFY(ofPanel.isComplete());
        QCOMPARE(check(*card, RuleKind::HoleSize, 200 * kUm).findings.size(), std::size_t{1});
    }

    void whatCannotBeCheckedIsCounted() {
        Board board;
        const LayerId open = addLayer(board.builder, "open", model::LayerType::Drill);
        const model::ShapeId shape = board.builder.addShape(rectangle({0, 0}, {kMm, 200 * kUm}));
        board.builder.beginLayer(board.drill);
        board.builder.addCircle({{0, 0}, 0, 0}, of(board.a, kWall));
        board.builder.addCircle({{kMm, 0}, 300 * kUm, 250 * kUm}, of(board.a, kWall));
        board.builder.addLine({{0, 3 * kMm}, {kMm, 3 * kMm}, 0, 0}, of({}, kBare));
        board.builder.addArea({shape, {{0, 5 * kMm}}}, of(board.a, kWall));
        board.builder.beginLayer(open);
        board.builder.addCircle({{9 * kMm, 0}, 300 * kUm, 250 * kUm}, of(board.a, kWall));
        const auto document = board.builder.finish();
        using Texts = std::vector<std::string>;
        const std::string size = "1 hole: the job gives them no size";
        QCOMPARE(textsOf(check(*document, RuleKind::HoleSize, 1)), Texts{size});
        QCOMPARE(textsOf(check(*document, RuleKind::SlotWidth, 1)),
                 (Texts{size, "1 hole: drawn as areas, whose width is not measured"}));
        QCOMPARE(textsOf(check(*document, RuleTable{{}, {ratioOf(8)}})),
                 (Texts{size, "1 hole: layer open does not say which copper layers it passes",
                        "1 hole: the job does not say how thick the dielectrics are that they pass"}));
        // Another rule holds for other holes, and can say of them all.
        const RuleTable two{{}, {ruleOf(RuleKind::HoleSize, 1), ruleOf(RuleKind::HoleSize, 1, HoleClass::NonPlated)}};
        const RuleReport report = check(*document, two);
        QVERIFY(model::verdictOf(two, report, 0) == model::Verdict::Incomplete);
        QVERIFY(model::verdictOf(two, report, 1) == model::Verdict::Unused);
    }

    void rulesThatNothingCanMeetAreUnused() {
        const auto whyUnused = [](const model::Document& document, const Rule& rule) {
            return check(document, RuleTable{{}, {rule}}).unused.front();
        };
        Board slotted;
        slotted.builder.beginLayer(slotted.drill);
        slotted.builder.addLine({{0, 0}, {kMm, 0}, 600 * kUm, 0}, of({}, kBare));
        const auto ofSlots = slotted.builder.finish();
        QCOMPARE(whyUnused(*ofSlots, ruleOf(RuleKind::SlotWidth, 1)), std::string());
        QCOMPARE(whyUnused(*ofSlots, ruleOf(RuleKind::SlotWidth, 1, HoleClass::Plated)),
                 std::string("the step has no slots of the kind plated"));
        QCOMPARE(whyUnused(*ofSlots, ruleOf(RuleKind::HoleSize, 1)), std::string("the step has no round holes"));
        QCOMPARE(whyUnused(*ofSlots, ratioOf(8)), std::string("the step has no plated round holes"));
        Board holes;
        holes.builder.beginLayer(holes.drill);
        holes.builder.addCircle({{0, 0}, 600 * kUm, 0}, of({}, kBare));
        const auto ofHoles = holes.builder.finish();
        QCOMPARE(whyUnused(*ofHoles, ruleOf(RuleKind::SlotWidth, 1)), std::string("the step has no slots"));
        QCOMPARE(whyUnused(*ofHoles, ruleOf(RuleKind::HoleSize, 1)), std::string());
        QCOMPARE(whyUnused(*ofHoles, ruleOf(RuleKind::HoleSize, 1, HoleClass::Microvia)),
                 std::string("the step has no round holes of the kind microvia"));
        QCOMPARE(whyUnused(*ofHoles, ratioOf(8)), std::string("the step has no plated round holes"));
    }

    void aLayerHasTheHolesThatPassIt() {
        DocumentBuilder builder;
        const LayerId top = addLayer(builder, "top");
        const LayerId inner = addLayer(builder, "inner");
        const LayerId bottom = addLayer(builder, "bottom");
        const LayerId drills[] = {addDrill(builder, top, bottom), addDrill(builder, top, inner)};
        for (const LayerId drill : drills) {
            builder.beginLayer(drill);
            builder.addCircle({{kMm * static_cast<Nm>(drill.row()), 0}, 200 * kUm, 0}, of({}, kBare));
        }
        const auto document = builder.finish();
        const auto countOn = [&](model::RuleScope scope) {
            base::Progress progress;
            const RuleTable table{{}, {ruleOf(RuleKind::HoleSize, 300 * kUm)}};
            return model::checkRules(*document, table, progress, scope)->findings.size();
        };
        QCOMPARE(countOn({}), std::size_t{2});
        QCOMPARE(countOn({inner, {}}), std::size_t{2});
        QCOMPARE(countOn({bottom, {}}), std::size_t{1});
        QCOMPARE(countOn({{}, {model::NetId{0U}, model::NetId{1U}}}), std::size_t{0});  // no rule between two nets
    }

    void reportsHaveDrillRequirementAndDepth() {
        const auto document = viaOf(160 * kUm);
        const RuleTable table{{}, {ruleOf(RuleKind::HoleSize, 200 * kUm), ratioOf(8)}};
        const model::StepRules steps[] = {{document.get(), check(*document, table)}};
        const auto report = [&](model::ReportFormat format) { return model::ruleReport(table, steps, format, 9); };
        const auto has = [&](model::ReportFormat format, const char* part) {
            const std::string text = report(format);
            QVERIFY2(text.find(part) != std::string::npos, (text + part).c_str());
        };
        using enum model::ReportFormat;
        has(Text, "FAIL        hole-size, at least 200.0 um: 1 location\n");
        has(Text, "FAIL        aspect-ratio, at most 8 : 1: 1 location\n");
        has(Text, "   160.000 um  drill ");
        has(Text, "  10.00 : 1, 1600.0 um deep\n");
        has(Csv, "pcb,aspect-ratio,200.000,drill,160.000,A,,1.000000,2.000000,1.000000,2.000000,");
        has(Csv, ",FAIL,\"10.00 : 1, 1600.0 um deep\",");
        has(Junit, "160.000 um of 200.0 um, 10.00 : 1, 1600.0 um deep");
        has(Sarif, "\"most_ratio\": 8.0");
        has(Html, "<td class=\"n\">at most 8 : 1</td>");
        const auto rules =
            QJsonDocument::fromJson(QByteArray::fromStdString(report(Json)))["steps"][0]["rules"].toArray();
        QCOMPARE(rules[0]["least_um"].toDouble(), 200.0);
        QCOMPARE(rules[0]["findings"][0]["clearance_um"].toDouble(), 160.0);
        QVERIFY(rules[0]["findings"][0]["depth_um"].isUndefined());
        QVERIFY(rules[1]["least_um"].isUndefined());
        QCOMPARE(rules[1]["most_ratio"].toDouble(), 8.0);
        QCOMPARE(rules[1]["findings"][0]["depth_um"].toDouble(), 1600.0);
        QCOMPARE(rules[1]["findings"][0]["aspect_ratio"].toDouble(), 10.0);
    }

    /// A thicker board is another matter than the one that somebody accepted.
    void aWaiverHoldsForNoDeeperHole() {
        const RuleTable table{{}, {ratioOf(8)}};
        const auto first = viaOf(160 * kUm);
        model::Waiver said;
        said.reason = "looked at";
        said.author = "Me";
        said.date = "2026-11-23";
        const RuleReport found = check(*first, table);
        const std::vector<model::Waiver> waivers{
            model::waiverOf(*first, model::SideNames(*first), table, found.findings.front(), said)};
        const auto again = model::parseWaivers(model::toJson(waivers));
        QVERIFY2(again, again ? "" : again.error().text.c_str());
        QVERIFY(*again == waivers);
        const auto waived = [&](Nm drill, Nm thickness) {
            base::Progress progress;
            return *model::checkRules(*viaOf(drill, thickness), table, waivers, progress);
        };
        QVERIFY(waived(160 * kUm, kThick).isPassed());
        QVERIFY(waived(170 * kUm, 1700 * kUm).isPassed());  // 10 : 1 as well
        QVERIFY(!waived(150 * kUm, kThick).isPassed());
        const RuleReport deeper = waived(160 * kUm, 1720 * kUm);
        QCOMPARE(deeper.findings.size(), std::size_t{1});
        QVERIFY2(deeper.waiverNotes.at(0).text.ends_with("it is 10.75 : 1, 1720.0 um deep now, so it does not hold"),
                 deeper.waiverNotes[0].text.c_str());
    }
};

QTEST_GUILESS_MAIN(DrillChecksTest)
#include "drill_checks_test.moc"
