// What design rules could not check, and so say.
#include "model/design_rules/unchecked_items.h"

#include <QtTest>

#include "model/board/document_builder.h"
#include "model/design_rules/design_rule_check.h"
#include "tests/unit/model/design_rules/rule_board.h"
#include "tests/unit/model/hand_made.h"

using namespace hand_made;
using namespace rule_board;
using model::DocumentBuilder;
using model::LayerId;
using model::Nm;
using model::Rule;
using model::RuleKind;
using model::RuleReport;
using model::RuleTable;

class UncheckedItemsTest : public QObject {
    Q_OBJECT

private slots:
    void whatCannotBeCheckedIsSaid() {
        DocumentBuilder builder;
        QVERIFY(check(*builder.finish(), model::defaultRules()).isComplete());  // nothing is there
        DocumentBuilder some;
        some.beginLayer(addLayer(some, "top"));
        some.addCircle({{0, 0}, 200 * kUm, 0}, of({}));
        const auto document = some.finish();
        const RuleReport report = check(*document, model::defaultRules());
        QVERIFY(report.isPassed());
        QCOMPARE(report.unchecked.size(), std::size_t{3});
        QCOMPARE(model::textOf(report.unchecked[0]), std::string("1 copper element: the board has no nets"));
        QCOMPARE(model::textOf(report.unchecked[1]), std::string("1 copper element: the board has no outline"));
        QCOMPARE(model::textOf(report.unchecked[2]), std::string("1 copper element: the job has no solder mask layer"));
        RuleTable table = model::defaultRules();
        QVERIFY(model::verdictOf(table, report, 0) == model::Verdict::Incomplete);
        QVERIFY(model::verdictOf(table, report, 1) == model::Verdict::Unused);
        for (Rule& rule : table.rules) {
            rule.isOn = false;
        }
        QVERIFY(check(*document, table).isComplete());
    }

    void holesWithoutSpanOrSizeAreCounted() {
        Board board;
        const LayerId open = addLayer(board.builder, "open", model::LayerType::Drill);
        board.builder.beginLayer(board.drill);
        board.builder.addCircle({{0, 0}, 0, 0}, of(board.a, kWall));
        board.builder.beginLayer(open);
        board.builder.addCircle({{0, 0}, 300 * kUm, 300 * kUm}, of(board.a, kWall));
        board.builder.addCircle({{5000 * kUm, 0}, 300 * kUm, 300 * kUm}, of({}, kBare));
        const auto document = board.builder.finish();
        const auto texts = [&](RuleKind kind) {
            std::vector<std::string> all;
            for (const model::Unchecked& unchecked : check(*document, kind, 1).unchecked) {
                all.push_back(model::textOf(unchecked));
            }
            return all;
        };
        const std::string why = ": layer open does not say which copper layers it passes";
        const std::string size = "1 hole: the job gives them no size";
        QCOMPARE(texts(RuleKind::AnnularRing), (std::vector<std::string>{"1 hole" + why, size}));
        QCOMPARE(texts(RuleKind::CopperToHole), (std::vector<std::string>{"2 holes" + why, size}));
        QCOMPARE(texts(RuleKind::CopperToCopper), (std::vector<std::string>{"1 hole" + why}));
        QCOMPARE(texts(RuleKind::HoleToHole), (std::vector<std::string>{size}));
    }

    /// Some jobs write a few nanometres where they do not know: no ring follows from that.
    void holesOfNoSensibleSizeLeaveRingsIncomplete() {
        Board board;
        board.builder.beginLayer(board.top);
        board.builder.addCircle({{0, 0}, 400 * kUm, 0}, of(board.a, model::kPad));
        board.builder.beginLayer(board.drill);
        board.builder.addCircle({{0, 0}, 10, 5}, of(board.a, kWall));
        const RuleReport report = check(*board.builder.finish(), RuleKind::AnnularRing, 100 * kUm);
        QVERIFY(report.isPassed() && !report.isComplete());
        QCOMPARE(model::textOf(report.unchecked.front()), std::string("1 hole: the job gives them no size"));
    }

    /// Nobody may take a board that was read in part for one without faults.
    void aJobThatWasReadInPartLeavesAllRulesIncomplete() {
        Board board;
        board.builder.diagnostics().report(model::Severity::Error, "board.kicad_pcb", 9, "the file ends early");
        const auto document = board.builder.finish();
        const RuleTable table = model::defaultRules();
        const RuleReport report = check(*document, table);
        for (std::size_t rule = 0; rule < table.rules.size(); ++rule) {
            QCOMPARE(model::verdictOf(table, report, rule) == model::Verdict::Incomplete, table.rules[rule].isOn);
        }
        QCOMPARE(model::textOf(report.unchecked.front()),
                 std::string("1 error: not all of the job could be read: board.kicad_pcb:9: The file ends early"));
    }

    void aClassWithoutNetsLeavesItsRuleIncomplete() {
        Board board;
        const auto document = board.builder.finish();
        const RuleTable table{
            {{"power", {"V*"}}, {"a", {"A"}}},
            {{RuleKind::CopperToCopper, 1, {"power", "a"}}, {RuleKind::CopperToCopper, 1, {"a", ""}}}};
        const RuleReport report = check(*document, table);
        QCOMPARE(report.unchecked.size(), std::size_t{1});
        QCOMPARE(model::textOf(report.unchecked[0]), std::string("no net fits the net class power"));
    }

    /// A misspelt name must not hide behind other names of its class. Patterns may be meant for other boards.
    void namesOfAClassThatNoNetHasLeaveRulesIncomplete() {
        Board board;
        const auto document = board.builder.finish();
        const RuleTable table{{{"power", {"A", "VNI", "VCC*", "B?"}}, {"other", {"A", "X"}}},
                              {{RuleKind::TrackWidth, 1, {"power"}},
                               {RuleKind::CopperToCopper, 1, {"", "power"}},
                               {RuleKind::CopperToCopper, 2, {"other"}, false}}};
        const RuleReport report = check(*document, table);
        QCOMPARE(report.unchecked.size(), std::size_t{2});
        QCOMPARE(model::textOf(report.unchecked[0]), std::string("no net fits VNI of the net class power"));
        QCOMPARE(report.unchecked[1].rule, std::size_t{1});
        QCOMPARE(report.notes, std::vector<std::string>{"no net fits VCC* of the net class power"});
    }

    void copiesThatMayComeTooCloseAreCounted() {
        for (const Nm apart : {Nm{900 * kUm}, Nm{1100 * kUm}}) {
            DocumentBuilder step;
            step.beginLayer(addLayer(step, "top"));
            step.addCircle({{0, 0}, 1000 * kUm, 0}, of(step.addNet("A")));
            DocumentBuilder panel;
            panel.beginLayer(addLayer(panel, "top"));
            panel.addCircle({{5000 * kUm, 0}, 1000 * kUm, 0}, of(panel.addNet("A")));
            const std::uint32_t row = panel.addStep(step.finish());
            panel.addInstance({row, {{0, 0}}, false});
            panel.addInstance({row, {{1000 * kUm + apart, 0}}, false});
            const RuleReport report = check(*panel.finish(), RuleKind::CopperToCopper, 1000 * kUm);
            QCOMPARE(report.unchecked.size(), std::size_t{apart < 1000 * kUm ? 1U : 0U});
        }
    }

    /// What is nearer than the limit of another rule alone leaves a rule complete.
    void copiesAreCountedByTheLimitOfEachRule() {
        DocumentBuilder step;
        step.beginLayer(addLayer(step, "top"));
        step.addCircle({{0, 0}, kMm, 0}, of(step.addNet("A")));
        DocumentBuilder panel;
        panel.beginLayer(addLayer(panel, "top"));
        panel.addCircle({{20 * kMm, 0}, kMm, 0}, of(panel.addNet("A")));
        const std::uint32_t row = panel.addStep(step.finish());
        panel.addInstance({row, {{0, 0}}, false});
        panel.addInstance({row, {{3 * kMm, 0}}, false});  // 2 mm from the first
        const RuleTable table{{}, {{RuleKind::CopperToCopper, 100 * kUm, {}}, {RuleKind::Creepage, 6400 * kUm, {}}}};
        const RuleReport report = check(*panel.finish(), table);
        QCOMPARE(model::verdictOf(table, report, 0), model::Verdict::Passed);
        QCOMPARE(model::verdictOf(table, report, 1), model::Verdict::Incomplete);
        QCOMPARE(std::ranges::count(report.unchecked,
                                    "copies of steps, or a copy and an element, may come closer than the limit",
                                    &model::Unchecked::why),
                 1);
    }

    /// Copies may hold holes that the step itself lacks; what none of them has cannot come too close.
    void copiesLeaveRulesForOtherHolesAlone() {
        DocumentBuilder step;
        const LayerId top = addLayer(step, "top");
        step.beginLayer(addDrill(step, top, top));
        step.addCircle({{0, 0}, 300 * kUm, 0}, of({}, model::kHole));
        DocumentBuilder panel;
        addDrill(panel, addLayer(panel, "top"), LayerId{0});
        const std::uint32_t row = panel.addStep(step.finish());
        panel.addInstance({row, {{0, 0}}, false});
        panel.addInstance({row, {{400 * kUm, 0}}, false});
        const auto board = panel.finish();
        Rule rule{RuleKind::HoleToHole, 200 * kUm, {}};
        const auto verdict = [&](model::HoleClass holes) {
            rule.holes = {holes, holes};
            const RuleTable table{{}, {rule}};
            return model::verdictOf(table, check(*board, table), 0);
        };
        QCOMPARE(verdict(model::HoleClass::Any), model::Verdict::Incomplete);
        QCOMPARE(verdict(model::HoleClass::NonPlated), model::Verdict::Incomplete);
        QCOMPARE(verdict(model::HoleClass::Microvia), model::Verdict::Unused);
    }

    /// A layer that rules of the kind are not held against is a layer that the board does not have: a pass would be
    /// untrue. A face may have no mask for good reasons, as long as the board has any.
    void layersOfAnotherKindLeaveRulesIncomplete() {
        Board board;
        hand_made::addLayer(board.builder, "notes", model::LayerType::Document);
        hand_made::addLayer(board.builder, "silk", model::LayerType::SilkScreen);
        const auto document = board.builder.finish();
        const auto on = [](RuleKind kind, const char* layer) {
            Rule rule{kind, 1, {}};
            rule.layer = layer;
            return rule;
        };
        const RuleTable table{
            {},
            {on(RuleKind::MaskSliver, "top"), on(RuleKind::MaskSliver, "to*"), on(RuleKind::CopperToCopper, "mask"),
             on(RuleKind::TrackWidth, "silk"), on(RuleKind::AnnularRing, "notes"), on(RuleKind::SilkToPad, "mask"),
             on(RuleKind::MaskSliver, "mas*"), on(RuleKind::MaskSliver, "bottom"), on(RuleKind::CopperToCopper, "*o*"),
             on(RuleKind::SilkToPad, "silk")}};
        const RuleReport report = check(*document, table);
        const auto verdictOf = [&](std::size_t rule) {
            std::string why = report.unused[rule];
            for (const model::Unchecked& unchecked : report.unchecked) {
                why += unchecked.rule == rule ? model::textOf(unchecked) : "";
            }
            return std::string(model::toString(model::verdictOf(table, report, rule))) + ": " + why;
        };
        QCOMPARE(verdictOf(0), std::string("pass: "));
        QCOMPARE(verdictOf(1), std::string("incomplete: no solder mask fits to*"));
        QCOMPARE(verdictOf(2), std::string("incomplete: no copper layer fits mask"));
        QCOMPARE(verdictOf(3), std::string("incomplete: no copper layer fits silk"));
        QVERIFY(verdictOf(4).starts_with("incomplete: ") && verdictOf(4).ends_with("no copper layer fits notes"));
        QCOMPARE(verdictOf(5), std::string("incomplete: no silkscreen fits mask"));
        QCOMPARE(verdictOf(6), std::string("pass: "));
        QCOMPARE(verdictOf(7), std::string("unused: the step has no bottom solder mask"));
        QCOMPARE(verdictOf(8), std::string("pass: "));
        QCOMPARE(verdictOf(9), std::string("pass: "));
    }
};

QTEST_GUILESS_MAIN(UncheckedItemsTest)
#include "unchecked_items_test.moc"
