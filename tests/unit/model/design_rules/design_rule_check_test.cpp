// Design rules: each kind on a board made for it, at exactly its limit and just below.
#include "model/design_rules/design_rule_check.h"

#include <QJsonArray>
#include <QJsonDocument>
#include <QtTest>
#include <algorithm>
#include <random>
#include <set>

#include "model/board/document_builder.h"
#include "model/clearance/side_names.h"
#include "model/export/clearance_export.h"
#include "tests/unit/model/design_rules/rule_board.h"
#include "tests/unit/model/hand_made.h"

using namespace hand_made;
using namespace rule_board;
using model::ElementId;
using model::NetId;
using model::Nm;
using model::Rule;
using model::RuleKind;
using model::RuleReport;
using model::RuleTable;

class RulesTest : public QObject {
    Q_OBJECT

private slots:
    void copperKeepsItsDistanceToOtherNets() {
        Board board;
        board.builder.beginLayer(board.top);
        board.builder.addCircle({{0, 0}, 200 * kUm, 0}, of(board.a));
        board.builder.addCircle({{300 * kUm, 0}, 200 * kUm, 0}, of(board.b));
        board.builder.addCircle({{150 * kUm, 0}, 50 * kUm, 0}, of(board.a));  // of one of both nets
        verifyNarrowest(*board.builder.finish(), RuleKind::CopperToCopper, 25 * kUm);
    }

    /// Half a micrometre by default; copper that touches has no clearance, however small the limit.
    void limitsHaveATolerance() {
        Board board;
        board.builder.beginLayer(board.top);
        board.builder.addCircle({{0, 0}, 200 * kUm, 0}, of(board.a));
        board.builder.addCircle({{300 * kUm, 0}, 200 * kUm, 0}, of(board.b));  // 100 um apart
        board.builder.addCircle({{0, 5000 * kUm}, 200 * kUm, 0}, of(board.builder.addNet("C")));
        board.builder.addCircle({{200 * kUm, 5000 * kUm}, 200 * kUm, 0}, of(board.builder.addNet("D")));  // they touch
        const auto document = board.builder.finish();
        const auto count = [&](Nm least, Nm tolerance) {
            base::Progress progress;
            return model::checkRules(*document, {{}, {{RuleKind::CopperToCopper, least, {}}}, tolerance}, progress)
                ->findings.size();
        };
        QCOMPARE(count(100'500, model::RuleTable{}.tolerance), std::size_t{1});
        QCOMPARE(count(100'501, model::RuleTable{}.tolerance), std::size_t{2});
        QCOMPARE(count(100'003, 3), std::size_t{1});
        QCOMPARE(count(100'003, 2), std::size_t{2});
        QCOMPARE(count(100, 500), std::size_t{1});
    }

    void theLastRuleThatFitsTheClassesHolds() {
        Board board;
        board.builder.beginLayer(board.top);
        board.builder.addCircle({{0, 0}, 200 * kUm, 0}, of(board.a));
        board.builder.addCircle({{300 * kUm, 0}, 200 * kUm, 0}, of(board.b));  // 100 um apart
        const auto document = board.builder.finish();
        const Rule any{RuleKind::CopperToCopper, 90 * kUm, {}};
        const Rule special{RuleKind::CopperToCopper, 120 * kUm, {"bus", ""}};
        const std::vector<model::NetClass> classes{{"bus", {"B?"}}, {"none", {"C*"}}};
        QVERIFY(check(*document, RuleTable{classes, {any}}).isPassed());
        const RuleReport broken = check(*document, RuleTable{classes, {any, special}});
        QCOMPARE(broken.findings.size(), std::size_t{1});
        QCOMPARE(broken.findings.front().rule, std::size_t{1});
        QVERIFY(check(*document, RuleTable{classes, {special, any}}).isPassed());
        const Rule twice{RuleKind::CopperToCopper, 120 * kUm, {"bus", "bus"}};
        QVERIFY(check(*document, RuleTable{classes, {any, twice}}).isPassed());
        const Rule nobody{RuleKind::CopperToCopper, 120 * kUm, {"none", ""}};
        QVERIFY(check(*document, RuleTable{classes, {any, nobody}}).isPassed());
    }

    void holesKeepCopperAway() {
        Board board;
        board.builder.beginLayer(board.top);
        board.builder.addCircle({{500 * kUm, 0}, 200 * kUm, 0}, of(board.a));
        board.builder.beginLayer(board.drill);
        board.builder.addCircle({{0, 0}, 300 * kUm, 0}, of({}, kBare));
        board.builder.addCircle({{500 * kUm, 0}, 100 * kUm, 100 * kUm}, of(board.a, kWall));  // its own
        verifyNarrowest(*board.builder.finish(), RuleKind::CopperToHole, 250 * kUm);
    }

    void holesKeepApart() {
        Board board;
        board.builder.beginLayer(board.drill);
        board.builder.addCircle({{0, 0}, 300 * kUm, 0}, of({}, kBare));
        board.builder.addCircle({{700 * kUm, 0}, 100 * kUm, 0}, of({}, kBare));
        verifyNarrowest(*board.builder.finish(), RuleKind::HoleToHole, 500 * kUm);
    }

    void ringsAreAsWideAsTheWidestCopperLeavesThem() {
        Board board;
        board.builder.beginLayer(board.top);
        board.builder.addLine({{-900 * kUm, 0}, {0, 0}, 320 * kUm, 0}, of(board.a));
        board.builder.addCircle({{10 * kUm, 0}, 600 * kUm, 0}, of(board.a, model::kPad));  // not quite centred
        board.builder.addCircle({{0, 0}, 900 * kUm, 0}, of(board.b, model::kPad));         // not its own
        board.builder.beginLayer(board.drill);
        board.builder.addCircle({{0, 0}, 300 * kUm, 300 * kUm}, of(board.a, kWall));
        verifyNarrowest(*board.builder.finish(), RuleKind::AnnularRing, 140 * kUm);
    }

    void aHoleBesideItsPadBreaksOut() {
        Board board;
        board.builder.beginLayer(board.bottom);
        board.builder.addCircle({{100 * kUm, 0}, 400 * kUm, 0}, of(board.a, model::kPad));
        board.builder.beginLayer(board.drill);
        board.builder.addCircle({{0, 0}, 300 * kUm, 300 * kUm}, of(board.a, kWall));
        const RuleReport broken = check(*board.builder.finish(), RuleKind::AnnularRing, 1);
        QCOMPARE(broken.findings.size(), std::size_t{1});
        QCOMPARE(broken.findings.front().spacing.distance, 0.0);
        QCOMPARE(broken.findings.front().layer, board.bottom);
    }

    /// As presets ask for rings, of inner and outer layers each by a rule of its own.
    void aHoleWithoutAPadIsFoundByRulesOfAllItsLayers() {
        Board board;
        board.builder.beginLayer(board.drill);
        board.builder.addCircle({{0, 0}, 300 * kUm, 300 * kUm}, of(board.a, kWall));
        const auto document = board.builder.finish();
        model::Rule top{RuleKind::AnnularRing, 1, {}};
        top.layer = "to*";
        model::Rule bottom = top;
        bottom.layer = "botto*";
        const RuleReport report = check(*document, RuleTable{{}, {top, bottom}});
        QCOMPARE(report.counts, (std::vector<std::size_t>{1, 0}));
        QCOMPARE(report.findings.front().reason, model::FindingReason::NoPad);
    }

    /// Whether a hole has a pad does not depend on where rings are asked for.
    void aHoleWithoutAPadIsFoundByARuleOfOneOfItsLayers() {
        model::Rule top{RuleKind::AnnularRing, 1, {}};
        top.layer = "to*";
        const auto found = [&](Nm padBelow) {
            Board board;
            board.builder.beginLayer(board.bottom);
            if (padBelow > 0) {
                board.builder.addCircle({{0, 0}, padBelow, 0}, of(board.a, model::kPad));
            }
            board.builder.beginLayer(board.drill);
            board.builder.addCircle({{0, 0}, 300 * kUm, 300 * kUm}, of(board.a, kWall));
            const RuleReport report = check(*board.builder.finish(), RuleTable{{}, {top}});
            const bool isNoPad = !report.isPassed() && report.findings.front().reason == model::FindingReason::NoPad &&
                                 report.findings.front().layer == board.top;
            return isNoPad ? report.findings.size() : report.isPassed() ? std::size_t{0} : std::size_t{99};
        };
        QCOMPARE(found(0), std::size_t{1});
        QCOMPARE(found(200 * kUm), std::size_t{1});  // the drill takes it
        QCOMPARE(found(500 * kUm), std::size_t{0});
    }

    /// One hole has a pad where no rule holds, one none at all, and one no rule.
    void padsOnLayersWithoutARuleAreOfTheirHolesAlone() {
        model::Rule rule{RuleKind::AnnularRing, 1, {"net:A*", ""}};
        rule.layer = "to*";
        Board board;
        board.builder.beginLayer(board.bottom);
        board.builder.addCircle({{5000 * kUm, 0}, 500 * kUm, 0}, of(board.a, model::kPad));
        board.builder.beginLayer(board.drill);
        for (const Nm x : {0, 5000 * kUm}) {
            board.builder.addCircle({{x, 0}, 300 * kUm, 300 * kUm}, of(board.a, kWall));
        }
        board.builder.addCircle({{9000 * kUm, 0}, 300 * kUm, 300 * kUm}, of(board.b, kWall));  // no rule
        const auto document = board.builder.finish();
        const RuleReport report = check(*document, RuleTable{{}, {rule}});
        QCOMPARE(report.findings.size(), std::size_t{1});
        QCOMPARE(report.findings.front().reason, model::FindingReason::NoPad);
        QVERIFY(document->boxOf(report.findings.front().a).middle() == model::Point{});
    }

    /// A pad without a net that touches a net is part of it; one that lies alone keeps away from all, other such too.
    void copperWithoutANetBelongsToWhatItTouches() {
        Board board;
        board.builder.beginLayer(board.top);
        board.builder.addCircle({{0, 0}, 200 * kUm, 0}, of(board.a));
        board.builder.addLine({{0, 0}, {500 * kUm, 0}, 50 * kUm, 0}, of({}));          // of A
        board.builder.addCircle({{500 * kUm, 160 * kUm}, 200 * kUm, 0}, of(board.a));  // 35 um from it
        board.builder.addCircle({{5000 * kUm, 0}, 200 * kUm, 0}, of({}, model::kPad));
        board.builder.addCircle({{5240 * kUm, 0}, 200 * kUm, 0}, of({}, model::kPad));   // 40 um
        board.builder.addLine({{9000 * kUm, 0}, {9500 * kUm, 0}, 50 * kUm, 0}, of({}));  // text
        board.builder.addLine({{9000 * kUm, 60 * kUm}, {9500 * kUm, 60 * kUm}, 50 * kUm, 0}, of({}));
        const auto document = board.builder.finish();
        const RuleReport report = check(*document, RuleKind::CopperToCopper, 50 * kUm);
        QCOMPARE(report.findings.size(), std::size_t{1});
        QCOMPARE(report.findings[0].spacing.distance, 40.0 * kUm);
        QCOMPARE(report.notes.size(), std::size_t{1});
        QVERIFY2(report.notes[0].starts_with("2 copper elements of no net"), report.notes[0].c_str());
    }

    void oneElementIsNoPlural() {
        Board board;
        board.builder.beginLayer(board.top);
        board.builder.addCircle({{0, 0}, 200 * kUm, 0}, of(board.a));
        board.builder.addLine({{9000 * kUm, 0}, {9500 * kUm, 0}, 50 * kUm, 0}, of({}));
        const auto document = board.builder.finish();
        QCOMPARE(check(*document, RuleKind::CopperToCopper, 50 * kUm).notes,
                 std::vector<std::string>{"1 copper element of no net, neither pad nor hole, is held against nets"});
    }

    void rulesThatAreOffDoNotCount() {
        Board board;
        board.builder.beginLayer(board.top);
        board.builder.addCircle({{0, 0}, 200 * kUm, 0}, of(board.a));
        board.builder.addCircle({{300 * kUm, 0}, 200 * kUm, 0}, of(board.b));  // 100 um apart
        const auto document = board.builder.finish();
        const Rule strict{RuleKind::CopperToCopper, 120 * kUm, {}};
        Rule lax{RuleKind::CopperToCopper, 90 * kUm, {}, false};
        QVERIFY(!check(*document, RuleTable{{}, {strict, lax}}).isPassed());
        lax.isOn = true;
        QVERIFY(check(*document, RuleTable{{}, {strict, lax}}).isPassed());
        QVERIFY(check(*document, RuleTable{{}, {{RuleKind::CopperToCopper, 120 * kUm, {}, false}}}).isPassed());
    }

    void rulesHaveTitlesAndSidesNames() {
        QCOMPARE(model::titleOf({RuleKind::HoleToHole, 1, {}}), std::string("hole-hole"));
        QCOMPARE(model::titleOf({RuleKind::CopperToCopper, 1, {"power", ""}}),
                 std::string("copper-copper between power and any net"));
        Board board;
        board.builder.beginLayer(board.top);
        board.builder.addCircle({{0, 0}, 200 * kUm, 0}, of(board.b));
        board.builder.addCircle({{0, 0}, 200 * kUm, 0}, of({}));
        const auto document = board.builder.finish();
        QCOMPARE(model::sideOf(*document, ElementId{0U}), std::string("B1"));
        QCOMPARE(model::sideOf(*document, ElementId{1U}), std::string("(no net)"));
        QCOMPARE(model::sideOf(*document, {}), std::string("(board edge)"));
    }

    /// Pads of the size of an NPTH, or smaller, are no copper: a note, and no location of any rule.
    void padsThatNpthsTakeAwayAreNoCopper() {
        Board board;
        board.builder.beginLayer(board.top);
        board.builder.addCircle({{0, 0}, 300 * kUm, 0}, of({}, model::kPad));                // as large
        board.builder.addCircle({{5000 * kUm, 0}, 200 * kUm, 0}, of(board.b, model::kPad));  // smaller
        board.builder.addCircle({{200 * kUm, 0}, 20 * kUm, 0}, of(board.a));            // 40 um from the first hole
        board.builder.addCircle({{9100 * kUm, 0}, 310 * kUm, 0}, of({}, model::kPad));  // a crescent of it stays
        board.builder.beginLayer(board.drill);
        for (const Nm x : {0, 5000 * kUm, 9000 * kUm}) {
            board.builder.addCircle({{x, 0}, 300 * kUm, 0}, of({}, kBare));
        }
        const auto document = board.builder.finish();
        const RuleReport report = check(*document, RuleKind::CopperToHole, 50 * kUm);
        QCOMPARE(report.findings.size(), std::size_t{2});
        QCOMPARE(report.findings[0].a.value, 3U);
        QCOMPARE(report.findings[1].a.value, 2U);
        QVERIFY(std::ranges::count(report.notes, "2 pads lie wholly within NPTHs, which take them away") == 1);
        QVERIFY(check(*document, RuleKind::CopperToCopper, 50 * kUm).isPassed());
    }

    /// A laser via, a drilled one and an NPTH, 60 um from a net each and 60 um from each other.
    void kindsOfHolesHaveLimitsOfTheirOwn() {
        using model::HoleClass;
        Board board;
        board.builder.beginLayer(board.top);
        for (const Nm x : {0, 1000 * kUm, 2000 * kUm}) {
            board.builder.addCircle({{x, 160 * kUm + 50 * kUm}, 100 * kUm, 0}, of(board.b));
        }
        board.builder.beginLayer(board.drill);
        board.builder.addCircle({{0, 0}, 100 * kUm, 80 * kUm}, of(board.a, kWall | model::kVia));
        board.builder.addCircle({{1000 * kUm, 0}, 200 * kUm, 180 * kUm}, of(board.a, kWall | model::kVia));
        board.builder.addCircle({{2000 * kUm, 0}, 200 * kUm, 200 * kUm}, of({}, kBare));
        const auto document = board.builder.finish();
        const auto found = [&](RuleKind kind, Nm least, std::array<HoleClass, 2> holes) {
            std::vector<std::uint32_t> all;
            for (const model::RuleFinding& finding :
                 check(*document, {{}, {{kind, least, {}, true, holes}}}).findings) {
                all.push_back(finding.a.value * 10 + (finding.b.isValid() ? finding.b.value : 0));
            }
            return all;
        };
        using Found = std::vector<std::uint32_t>;
        const auto toHole = RuleKind::CopperToHole;
        QCOMPARE(found(toHole, 120 * kUm, {HoleClass::Microvia}), (Found{3}));
        QCOMPARE(found(toHole, 120 * kUm, {HoleClass::Plated}), (Found{14}));
        QCOMPARE(found(toHole, 120 * kUm, {HoleClass::NonPlated}), (Found{25}));
        QCOMPARE(found(RuleKind::HoleToHole, kMm, {HoleClass::Microvia, HoleClass::Any}), (Found{34}));
        QCOMPARE(found(RuleKind::HoleToHole, kMm, {HoleClass::NonPlated, HoleClass::Plated}), (Found{45}));
        QCOMPARE(found(RuleKind::AnnularRing, 1, {HoleClass::Microvia}), (Found{30}));
        QCOMPARE(found(RuleKind::AnnularRing, 1, {HoleClass::Any}), (Found{30, 40}));
    }

    void rulesThatNothingCanMeetAreUnused() {
        using model::HoleClass;
        Board board;
        board.builder.beginLayer(board.drill);
        board.builder.addCircle({{0, 0}, 300 * kUm, 200 * kUm}, of(board.a, kWall));
        const auto document = board.builder.finish();
        const RuleTable table{{},
                              {{RuleKind::CopperToHole, 1, {}, true, {HoleClass::Microvia}},
                               {RuleKind::HoleToHole, 1, {}, true, {HoleClass::Plated, HoleClass::Any}},
                               {RuleKind::HoleToHole, 2, {}},
                               {RuleKind::CopperToCopper, 1, {}}}};
        const RuleReport report = check(*document, table);
        QCOMPARE(report.unused[0], std::string("the step has no holes of the kind microvia"));
        QCOMPARE(report.unused[1], std::string("rule 3 holds instead"));
        QVERIFY(report.unused[2].empty() && report.unused[3].empty());
        QVERIFY(model::verdictOf(table, report, 0) == model::Verdict::Unused);
        const model::StepRules steps[] = {{document.get(), report}};
        const std::string text = model::ruleReport(table, steps, model::ReportFormat::Text, 9);
        QVERIFY2(text.find("unused      copper-hole of microvias") != std::string::npos, text.c_str());
    }

    /// 200 random pairs of pads, and of a pad and an NPTH, some of them closer than the limit: exactly those are found.
    void plantedViolationsAreFoundAndNoOthers() {
        std::mt19937 random(3);
        const auto upTo = [&](unsigned most) { return static_cast<Nm>(random() % most); };
        for (const RuleKind kind : {RuleKind::CopperToCopper, RuleKind::CopperToHole}) {
            Board board;
            std::set<Nm> planted;
            std::vector<model::CircleGeometry> holes;
            board.builder.beginLayer(board.top);
            for (Nm i = 0; i < 200; ++i) {
                const Nm y = i * 3 * kMm;
                const bool isPlanted = upTo(8) == 0;
                const Nm apart = isPlanted ? 1 + upTo(99'000) : 99'500 + upTo(300'000);
                const model::CircleGeometry second{{400 * kUm + apart, y}, 400 * kUm, 0};
                board.builder.addCircle({{0, y}, 400 * kUm, 0}, of(board.a, model::kPad));
                if (kind == RuleKind::CopperToHole) {
                    holes.push_back(second);
                } else {
                    const NetId net = upTo(2) == 0 ? NetId{} : board.builder.addNet("N" + std::to_string(i));
                    board.builder.addCircle(second, of(net, model::kPad));
                }
                if (isPlanted) {
                    planted.insert(y);
                }
            }
            board.builder.beginLayer(board.drill);
            for (const model::CircleGeometry& hole : holes) {
                board.builder.addCircle(hole, of({}, kBare));
            }
            const auto document = board.builder.finish();
            base::Progress progress;
            const RuleReport report = *model::checkRules(*document, {{}, {{kind, 100 * kUm, {}}}}, progress);
            std::set<Nm> found;
            for (const model::RuleFinding& finding : report.findings) {
                found.insert(static_cast<Nm>(std::lround(finding.spacing.from.y)));
            }
            QCOMPARE(report.findings.size(), planted.size());
            QVERIFY(found == planted);
        }
    }

    /// Tracks that lead on are one element, as long as the job has them in order.
    void legsOfOneTrackKeepTheirDistance() {
        using model::PathNode;
        const std::vector<PathNode> hairpin{{{0, 0}, {}}, {{0, 10 * kMm}, {}}, {{kMm, 10 * kMm}, {}}, {{kMm, 0}, {}}};
        const auto found = [&](Nm least, bool isOne) {
            Board board;
            board.builder.beginLayer(board.top);
            if (isOne) {
                board.builder.addTrail(hairpin, 200 * kUm, of(board.a));
            }
            for (std::size_t i = 0; i + 1 < hairpin.size() && !isOne; ++i) {
                board.builder.addLine({hairpin[i].point, hairpin[i + 1].point, 200 * kUm, 0}, of(board.a));
            }
            Rule rule{RuleKind::CopperToCopper, least, {}};
            rule.isSameNet = true;
            return check(*board.builder.finish(), RuleTable{{}, {rule}}).findings;
        };
        for (const bool isOne : {true, false}) {
            QCOMPARE(found(800 * kUm, isOne).size(), std::size_t{0});
            const auto narrow = found(801 * kUm, isOne);
            QCOMPARE(narrow.size(), std::size_t{1});
            QVERIFY(std::abs(narrow.front().spacing.distance - 800e3) < 1);
        }
    }

    /// Of inner layers, though the board has none, and of layers that are not looked at. A name may be misspelt.
    void rulesWithoutALayerAreUnused() {
        Board board;
        board.builder.beginLayer(board.top);
        board.builder.addCircle({{0, 0}, 200 * kUm, 0}, of(board.a));
        const auto document = board.builder.finish();
        const auto on = [](const char* layer) {
            Rule rule{RuleKind::CopperToCopper, 1, {}};
            rule.layer = layer;
            return rule;
        };
        const RuleTable table{{}, {on(""), on("inner"), on("bottom"), on("BOT*"), on("in7")}};
        const RuleReport whole = check(*document, table);
        QCOMPARE(whole.unused[1], std::string("the step has no inner layer"));
        QVERIFY(model::verdictOf(table, whole, 0) == model::Verdict::Passed);
        QVERIFY(model::verdictOf(table, whole, 1) == model::Verdict::Unused);
        QVERIFY(model::verdictOf(table, whole, 2) == model::Verdict::Passed);
        QVERIFY(model::verdictOf(table, whole, 3) == model::Verdict::Passed);
        QVERIFY(model::verdictOf(table, whole, 4) == model::Verdict::Incomplete);

        base::Progress progress;
        model::RuleScope scope;
        scope.layer = board.top;
        const RuleReport top = *model::checkRules(*document, table, progress, scope);
        QVERIFY(model::verdictOf(table, top, 0) == model::Verdict::Passed);
        QCOMPARE(top.unused[2], std::string("it is for bottom layers, only layer top is checked"));
        QCOMPARE(top.unused[3], std::string("it is for layer BOT*, only layer top is checked"));
        QVERIFY(model::verdictOf(table, top, 4) == model::Verdict::Incomplete);
    }

    void rulesOfHolesAreUnusedWithoutAny() {
        const auto whyUnused = [](const model::Document& document, RuleKind kind) {
            return check(document, kind, 1).unused.front();
        };
        const auto without = Board().builder.finish();
        QCOMPARE(whyUnused(*without, RuleKind::AnnularRing), std::string("the step has no plated holes"));
        QCOMPARE(whyUnused(*without, RuleKind::HoleToHole), std::string("the step has no holes"));
        QCOMPARE(whyUnused(*without, RuleKind::CopperToHole), std::string("the step has no holes"));
        Board board;
        board.builder.beginLayer(board.drill);
        board.builder.addCircle({{0, 0}, 300 * kUm, 0}, of({}, kBare));
        const auto document = board.builder.finish();
        QCOMPARE(whyUnused(*document, RuleKind::AnnularRing), std::string("the step has no plated holes"));
        QCOMPARE(whyUnused(*document, RuleKind::HoleToHole), std::string());
        QCOMPARE(whyUnused(*document, RuleKind::CopperToHole), std::string());
    }

    void sidesAreToldApart() {
        Board board;
        model::Component part;
        part.refdes = "U5";
        board.builder.beginLayer(board.top);
        addPart(board, part, {{board.a, {0, 0}}});
        board.builder.addLine({{0, 0}, {0, kMm}, 50 * kUm, 0}, of(board.b));
        board.builder.beginLayer(board.drill);
        board.builder.addCircle({{0, 0}, 300 * kUm, 0}, of({}, kBare));
        board.builder.addLine({{5 * kMm, 0}, {5 * kMm, kMm}, 300 * kUm, 100 * kUm}, of(board.a, kWall));
        board.builder.addCircle({{9 * kMm, 0}, 300 * kUm, 200 * kUm}, of(board.a, kWall | model::kVia));
        const auto document = board.builder.finish();
        const model::SideNames names(*document);
        const auto text = [&](std::uint32_t element) { return model::textOf(names.of(ElementId{element})); };
        QCOMPARE(text(0), std::string("A, U5.1, pad, element 0"));
        QCOMPARE(text(1), std::string("B1, track, element 1"));
        QCOMPARE(text(2), std::string("(no net), NPTH, element 2"));
        QCOMPARE(text(3), std::string("A, plated slot, element 3"));
        QCOMPARE(text(4), std::string("A, via, element 4"));
        QCOMPARE(model::textOf(names.of(ElementId{})), std::string("(board edge)"));
    }

    /// What the reports of a step say, in all formats.
    void reportsNameEveryRuleAndPlace() {
        Board board;
        board.builder.beginLayer(board.top);
        board.builder.addCircle({{0, 0}, 200 * kUm, 0}, of(board.a));
        board.builder.addCircle({{300 * kUm, 0}, 200 * kUm, 0}, of(board.b));
        const auto document = board.builder.finish();
        const RuleTable table{{},
                              {{RuleKind::CopperToCopper, 120 * kUm, {}},
                               {RuleKind::HoleToHole, 120 * kUm, {}},
                               {RuleKind::CopperToHole, 120 * kUm, {}, false}}};
        const model::StepRules steps[] = {{document.get(), check(*document, table)}};
        const std::string text = model::ruleReport(table, steps, model::ReportFormat::Text, 9);
        for (const char* word : {"FAIL        copper-copper, at least 120.0 um: 1 location\n", "unused      hole-hole",
                                 "off         copper-hole", "   100.000 um  top ", "A, dot, element 0 "}) {
            QVERIFY2(text.find(word) != std::string::npos, (text + word).c_str());
        }
        const auto lines = [](const std::string& csv) { return std::ranges::count(csv, '\n'); };
        QCOMPARE(lines(model::ruleReport(table, steps, model::ReportFormat::Csv, 9)), 2);
        const std::string cut = model::ruleReport(table, steps, model::ReportFormat::Csv, 0);
        QVERIFY2(lines(cut) == 2 && cut.find(",not listed,1 more location is not listed,") != std::string::npos,
                 cut.c_str());
        const std::string json = model::ruleReport(table, steps, model::ReportFormat::Json, 9);
        const QJsonArray rules =
            QJsonDocument::fromJson(QByteArray::fromStdString(json))["steps"][0]["rules"].toArray();
        QCOMPARE(rules.size(), 3);
        QCOMPARE(rules[0]["passed"], QJsonValue(false));
        QCOMPARE(rules[0]["findings"][0]["nets"][1].toString(), "B1");
        QCOMPARE(rules[1]["result"].toString(), "unused");
        QCOMPARE(rules[2]["on"], QJsonValue(false));
        QVERIFY(model::reportFormatOf(".csv") == model::ReportFormat::Csv && !model::reportFormatOf("pdf"));
    }
};

QTEST_GUILESS_MAIN(RulesTest)
#include "design_rule_check_test.moc"
