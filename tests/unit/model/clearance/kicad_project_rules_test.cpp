// Rules of projects of KiCad, and of older boards.
#include "model/clearance/kicad_project_rules.h"

#include <QTemporaryDir>
#include <QtTest>
#include <algorithm>
#include <filesystem>
#include <fstream>

using model::NetClass;
using model::Rule;
using model::RuleKind;

namespace {

namespace fs = std::filesystem;

constexpr model::Nm kUm = 1000;

constexpr const char* kProject = R"json({
"board": {"design_settings": {
  "rules": {
    "min_clearance": 0.1, "min_copper_edge_clearance": 0.5, "min_hole_clearance": 0.25, "min_hole_to_hole": 0.3,
    "min_track_width": 0.15, "min_via_annular_width": 0.05, "min_silk_clearance": 0.0,
    "solder_mask_to_copper_clearance": 0.02,
    "min_via_diameter": 0.5,
    "min_text_height": 0.0},
  "rule_severities": {"annular_width": "ignore", "clearance": "error", "microvia_drill_out_of_range": "ignore"}}},
"net_settings": {
  "classes": [
    {"name": "Default", "clearance": 0.2, "track_width": 0.25, "via_diameter": 0.8},
    {"name": "Power", "clearance": 0.4},
    {"name": "Fine", "clearance": 0.05, "nets": ["/A"]},
    {"name": "Finer", "clearance": 0.15},
    {"name": "Wide", "clearance": 0.3},
    {"name": "Colour", "clearance": null},
    {"name": "Odd",
     "clearance": 1e9}],
  "netclass_assignments": {"GND": ["Power", "Wide"], "VCC": "Power"},
  "netclass_patterns": [{"netclass": "Fine", "pattern": "USB_*"}, {"netclass": "None", "pattern": "x"},
  {"netclass": "Finer", "pattern": "F?"}, {"netclass": "Wide", "pattern": "W"}]}})json";

model::RuleFile import(const char* text) {
    const auto file = model::parseKicadProjectRules(text);
    return file ? *file : model::RuleFile{};
}

std::vector<std::string> textsOf(const std::vector<model::LeftOutRule>& leftOut) {
    std::vector<std::string> texts;
    std::ranges::transform(leftOut, std::back_inserter(texts), model::textOf);
    return texts;
}

void write(const fs::path& path, const std::string& text) {
    std::ofstream(path, std::ios::binary) << text;
}

constexpr const char* kOldBoard = R"((kicad_pcb (version 20171130) (host pcbnew 5.1)
  (setup
    (trace_min 0.15) (via_min_size 0.4))
  (net 1 GND)
  (net_class Default "The (usual) class."
    (clearance 0.2) (add_net "A B"))
  (net_class Motor ""
    (clearance 0.4) (add_net GND))
  (net_class Odd ""
    (clearance far))
  (module x (layer F.Cu) (net_class None "" (clearance 9)))
))";

}  // namespace

class KicadProjectRulesTest : public QObject {
    Q_OBJECT

private slots:
    void minimumsOfTheBoardAreRules() {
        const std::vector<Rule> rules = import(kProject).table.rules;
        const auto has = [&](const Rule& rule) { return std::ranges::find(rules, rule) != rules.end(); };
        QVERIFY(has({RuleKind::CopperToEdge, 500 * kUm, {}}));
        QVERIFY(has({RuleKind::CopperToHole, 250 * kUm, {}}));
        QVERIFY(has({RuleKind::HoleToHole, 300 * kUm, {}}));
        QVERIFY(has({RuleKind::TrackWidth, 150 * kUm, {}}));
        QVERIFY(has({RuleKind::MaskToForeign, 20 * kUm, {}}));
        QVERIFY(has({RuleKind::AnnularRing, 50 * kUm, {}, false}));
        QVERIFY(std::ranges::none_of(rules, [](const Rule& rule) { return rule.kind == RuleKind::SilkToPad; }));
        QVERIFY(model::parseRules(model::toJson(import(kProject).table)));
    }

    /// To KiCad microvias are no through holes, but slots and NPTHs are.
    void smallestHolesAreRules() {
        using model::HoleClass;
        const auto rulesOf = [](const std::string& least, const std::string& severities) {
            return import(("{\"board\": {\"design_settings\": {\"rules\": {" + least + "}, \"rule_severities\": {" +
                           severities + "}}}}")
                              .c_str());
        };
        const std::string both = R"("min_through_hole_diameter": 0.3, "min_microvia_drill": 0.1)";
        std::vector<Rule> expected = {{RuleKind::HoleSize, 300 * kUm, {}, true, {HoleClass::Plated}},
                                      {RuleKind::HoleSize, 300 * kUm, {}, true, {HoleClass::NonPlated}},
                                      {RuleKind::SlotWidth, 300 * kUm, {}},
                                      {RuleKind::HoleSize, 100 * kUm, {}, true, {HoleClass::Microvia}}};
        QVERIFY(rulesOf(both, "").table.rules == expected);
        QVERIFY(rulesOf(both, "").leftOut.empty());
        expected[3].isOn = false;
        QVERIFY(rulesOf(both, R"("microvia_drill_out_of_range": "ignore")").table.rules == expected);
        for (Rule& rule : expected) {
            rule.isOn = !rule.isOn;
        }
        QVERIFY(rulesOf(both, R"("drill_out_of_range": "ignore")").table.rules == expected);
        QVERIFY(rulesOf(R"("min_through_hole_diameter": 0.0)", "").table.rules.empty());
        QCOMPARE(textsOf(rulesOf(R"("min_through_hole_diameter": "small")", "").leftOut),
                 std::vector<std::string>{"line 1: min_through_hole_diameter, which is no length, is left out"});
    }

    void twoClassesKeepTheLargerClearance() {
        std::vector<Rule> clearances = import(kProject).table.rules;
        std::erase_if(clearances, [](const Rule& rule) { return rule.kind != RuleKind::CopperToCopper; });
        const std::vector<Rule> expected = {
            {RuleKind::CopperToCopper, 200 * kUm, {"", ""}},
            {RuleKind::CopperToCopper, 100 * kUm, {"Fine", "Fine"}},  // no less than the board's
            {RuleKind::CopperToCopper, 150 * kUm, {"Fine", "Finer"}},
            {RuleKind::CopperToCopper, 150 * kUm, {"Finer", "Finer"}},
            {RuleKind::CopperToCopper, 300 * kUm, {"Wide", ""}},
            {RuleKind::CopperToCopper, 400 * kUm, {"Power", ""}}};
        QVERIFY(clearances == expected);
    }

    void classesHaveTheirNets() {
        const std::vector<NetClass> expected = {{"Power", {"GND", "VCC"}},
                                                {"Fine", {"/A", "USB_*"}},
                                                {"Finer", {"F?"}},
                                                {"Wide", {"GND", "W"}},
                                                {"Colour", {}},
                                                {"Odd", {}}};
        QVERIFY(import(kProject).table.classes == expected);
    }

    void whatHasNoCounterpartIsNamedWithItsLine() {
        QCOMPARE(textsOf(import(kProject).leftOut),
                 (std::vector<std::string>{"line 19: the clearance of net class Odd, which is no length, is left out",
                                           "line 7: min_via_diameter is left out"}));
        const model::RuleFile odd = import(R"json({"board": {"design_settings": {"rules": {
"min_clearance": "wide", "min_track_width": -1, "min_hole_to_hole": 0.2}}},
"net_settings": {"classes": [{"clearance": 1}, {"name": "A", "clearance": 0.3, "nets": ["N"]}, {"name": "A"}, 7]}})json");
        QCOMPARE(odd.leftOut.size(), std::size_t{5});
        QCOMPARE(odd.table.rules.size(), std::size_t{2});
    }

    void whatIsNoProjectIsAnError() {
        for (const char* text : {"", "{", "[]"}) {
            QVERIFY(!model::parseKicadProjectRules(text));
        }
        for (const char* text : {"{}", R"({"board": 1, "net_settings": {"classes": 5}})"}) {
            QVERIFY(model::parseKicadProjectRules(text)->table.rules.empty());
        }
        const std::string text = kProject;
        for (std::size_t length = 0; length < text.size(); ++length) {
            static_cast<void>(model::parseKicadProjectRules(text.substr(0, length)));
        }
    }

    void oldBoardsHoldThemThemselves() {
        const auto file = model::parseKicadBoardRules(kOldBoard);
        QVERIFY(file);
        const std::vector<Rule> expected = {{RuleKind::CopperToCopper, 200 * kUm, {"", ""}},
                                            {RuleKind::CopperToCopper, 400 * kUm, {"Motor", ""}},
                                            {RuleKind::TrackWidth, 150 * kUm, {}}};
        QVERIFY(file->table.rules == expected);
        QVERIFY(file->table.classes == (std::vector<NetClass>{{"Motor", {"GND"}}, {"Odd", {}}}));
        QCOMPARE(textsOf(file->leftOut),
                 (std::vector<std::string>{"line 9: the clearance of net class Odd, which is no length, is left out"}));
        QVERIFY(model::parseKicadBoardRules("(kicad_pcb (version 4))")->table.rules.empty());
        const auto nameless = model::parseKicadBoardRules(
            "(kicad_pcb\n(net_class (clearance 1))\n(net_class M \"\" (clearance 0.3) (add_net A))\n"
            "(net_class M \"\" (clearance 0.4) (add_net B))\n(net_class N\xff \"\" (clearance 0.5) (add_net C)))");
        QVERIFY(nameless);
        QVERIFY(nameless->table.classes == (std::vector<NetClass>{{"M", {"A"}}}));
        QCOMPARE(textsOf(nameless->leftOut),
                 (std::vector<std::string>{"line 2: a net class without a name of its own is left out",
                                           "line 4: a net class without a name of its own is left out",
                                           "line 5: a net class whose name is no UTF-8 is left out"}));
        const std::string text = kOldBoard;
        for (std::size_t length = 0; length < text.size(); ++length) {
            static_cast<void>(model::parseKicadBoardRules(text.substr(0, length)));
        }
    }

    void anOldBoardOfListsThatDoNotEndTakesNoTime() {
        std::string board = "(kicad_pcb (version 4)\n";
        for (int i = 0; i < 1'000'000; ++i) {  // hours, if each is followed to the end of the text
            board += "(net_class (a\n";
        }
        QVERIFY(model::parseKicadBoardRules(board)->table.classes.empty());
    }

    void aBoardHasTheRulesOfItsProject() {
        QTemporaryDir folder;
        const fs::path board = fs::path(folder.path().toStdString()) / "b.kicad_pcb";
        write(board, "(kicad_pcb (version 20211014))");
        QVERIFY(!model::kicadRulesOf(board));
        write(fs::path(board).replace_extension(".kicad_pro"), kProject);
        QVERIFY(model::kicadRulesOf(board)->table.classes.front().name == "Power");
        const std::size_t count = model::kicadRulesOf(board)->table.rules.size();
        write(fs::path(board).replace_extension(".kicad_dru"),
              "(version 1)\n(rule x (condition \"A.NetClass == 'Power'\") (constraint clearance (min 2mm)))\n(sheet)");
        const auto file = model::kicadRulesOf(board);
        QCOMPARE(file->table.rules.size(), count + 1);
        QCOMPARE(file->table.rules.back().least, 2000 * kUm);
        write(
            fs::path(board).replace_extension(".kicad_dru"),
            "(rule x (condition \"A.hasNetclass('*E*') && B.NetClass == 'power'\") (constraint clearance (min 2mm)))");
        const auto named = model::kicadRulesOf(board);
        QVERIFY(named->table.classes.back() == (NetClass{"power", {"GND", "VCC"}}));
        QVERIFY(named->table.classes[6] == (NetClass{"*E*", {"GND", "VCC", "/A", "USB_*", "F?", "GND", "W"}}));
        QCOMPARE(named->table.rules.back().classes, (std::array<std::string, 2>{"*E*", "power"}));
        write(fs::path(board).replace_extension(".kicad_dru"),
              "(version 1)\n(rule x (condition \"A.NetClass == 'Power'\") (constraint clearance (min 2mm)))\n(sheet)");
        QCOMPARE(file->table.classes.size(), std::size_t{6});
        QCOMPARE(model::readRules(board)->table.rules.size(), count + 1);
        QCOMPARE(file->leftOut.front().file, fs::path(board).replace_extension(".kicad_pro"));
        QCOMPARE(file->leftOut.back(),
                 (model::LeftOutRule{"(sheet) is left out", 3, fs::path(board).replace_extension(".kicad_dru")}));
        QVERIFY(!model::kicadRulesOf(fs::path(board).replace_extension(".tgz")));
        write(board, "(kicad_pcb (version 20241229))");
        fs::remove(fs::path(board).replace_extension(".kicad_pro"));
        fs::remove(fs::path(board).replace_extension(".kicad_dru"));
        QVERIFY(!model::kicadRulesOf(board));
        QVERIFY(!model::readRules(board));
    }

    void anOldBoardWithAProjectGoesByItself() {
        QTemporaryDir folder;
        const fs::path board = fs::path(folder.path().toStdString()) / "b.kicad_pcb";
        write(board, kOldBoard);
        const model::RuleFile alone = *model::kicadRulesOf(board);
        QCOMPARE(alone.table.classes.front().name, std::string("Motor"));
        QVERIFY(alone.unused.empty());
        write(fs::path(board).replace_extension(".kicad_pro"), kProject);
        const model::RuleFile both = *model::kicadRulesOf(board);
        QVERIFY(both.table == alone.table);
        QVERIFY(both.unused.front().starts_with("b.kicad_pro: the board is of KiCad 4 or 5"));
        write(board, "(kicad_pcb (version 4))");  // it says nothing
        QCOMPARE(model::kicadRulesOf(board)->table.classes.front().name, std::string("Power"));
    }

    void whatTheProjectIgnoresNoCustomRuleChecks() {
        QTemporaryDir folder;
        const fs::path board = fs::path(folder.path().toStdString()) / "b.kicad_pcb";
        write(board, "(kicad_pcb (version 20241229))");
        write(fs::path(board).replace_extension(".kicad_pro"), kProject);  // ignores annular_width
        write(fs::path(board).replace_extension(".kicad_dru"),
              "(version 1)\n(rule a (severity error) (constraint annular_width (min 1mm)))\n"
              "(rule b (constraint clearance (min 2mm)))\n"
              "(rule c (condition \"A.isMicroVia()\") (constraint hole_size (min 3mm)))\n"
              "(rule d (condition \"!A.isPlated()\") (constraint hole_size (min 4mm)))");
        const auto isOn = [rules = model::kicadRulesOf(board)->table.rules](model::Nm least) {
            return std::ranges::find(rules, least, &Rule::least)->isOn;
        };
        QVERIFY(!isOn(1000 * kUm));
        QVERIFY(isOn(2000 * kUm));
        QVERIFY(!isOn(3000 * kUm));
        QVERIFY(isOn(4000 * kUm));
    }

    void clearancesOfSingleItemsAreNamed() {
        QTemporaryDir folder;
        const fs::path board = fs::path(folder.path().toStdString()) / "b.kicad_pcb";
        write(fs::path(board).replace_extension(".kicad_pro"), kProject);
        const auto namedWith = [&](const std::string& items) {
            write(board, "(kicad_pcb (version 20241229)\n" + items + ")");
            const std::vector<model::LeftOutRule> leftOut = model::kicadRulesOf(board)->leftOut;
            return leftOut.back().file == board ? model::textOf(leftOut.back()) : std::string();
        };
        QCOMPARE(namedWith(""), std::string());
        QCOMPARE(namedWith("(zone (connect_pads (clearance 0.2)))"), std::string());  // no more than all others
        QCOMPARE(namedWith("(footprint \"x\"\n(pad \"1\" (options (clearance outline)) (clearance 0.3)))\n"
                           "(zone (connect_pads yes (clearance 1.5)))"),
                 std::string("line 3: what zones, pads and footprints ask for themselves (2 clearances, up to 1.5 mm) "
                             "is left out"));
        QCOMPARE(namedWith("(zone (connect_pads (clearance far)))"), std::string());
    }

    void customRulesThatCannotBeUsedAreNamed() {
        QTemporaryDir folder;
        const fs::path board = fs::path(folder.path().toStdString()) / "b.kicad_pcb";
        const fs::path custom = fs::path(board).replace_extension(".kicad_dru");
        write(board, "(kicad_pcb (version 20241229))");
        write(fs::path(board).replace_extension(".kicad_pro"), kProject);
        const std::size_t count = model::kicadRulesOf(board)->table.rules.size();
        write(custom, "(version 1)\n(rule a (condition \"A.insideArea('HV')\") (constraint clearance (min 1mm)))");
        const model::LeftOutRule none{"rule a, condition A.insideArea('HV') is left out", 2, custom};
        QCOMPARE(model::readRules(board)->leftOut.back(), none);
        QCOMPARE(model::readRules(board)->table.rules.size(), count);

        write(custom, "(version 1)\n(rule a (constraint clearance (min 1mm))\n");
        QCOMPARE(model::readRules(board).error().text, custom.string() + ": line 2: a list is not closed");
        const auto shown = model::kicadRulesOf(board);
        QCOMPARE(shown->table.rules.size(), count);
        QCOMPARE(shown->leftOut.back(),
                 (model::LeftOutRule{"it cannot be read and is left out: line 2: a list is not closed", 0, custom}));

        write(custom, "(rule a (severity ignore) (constraint clearance (min 1mm)))");
        QVERIFY(model::readRules(board)->unused.front().starts_with("b.kicad_dru, line 1: rule a has severity ignore"));
    }

    void aProjectThatIsDamagedOrMissingIsNamed() {
        QTemporaryDir folder;
        const fs::path board = fs::path(folder.path().toStdString()) / "b.kicad_pcb";
        const fs::path project = fs::path(board).replace_extension(".kicad_pro");
        const fs::path custom = fs::path(board).replace_extension(".kicad_dru");
        write(board, "(kicad_pcb (version 20241229))");
        write(project, std::string(kProject).substr(0, 100));
        QVERIFY(model::readRules(board).error().text.starts_with(project.string() + ": the rules cannot be used"));
        QVERIFY(model::kicadRulesOf(board)->table.rules.empty());
        QCOMPARE(model::kicadRulesOf(board)->leftOut.front().file, project);

        write(custom, "(rule a (constraint clearance (min 1mm)))");
        QVERIFY(!model::readRules(board));
        QCOMPARE(model::kicadRulesOf(board)->table.rules.size(), std::size_t{1});

        fs::remove(project);
        const auto file = model::readRules(board);
        QCOMPARE(file->table.rules.size(), std::size_t{1});
        QCOMPARE(
            file->leftOut.front(),
            (model::LeftOutRule{"without a .kicad_pro beside it, the rules of the project are left out", 0, custom}));
    }

    void theProjectAndCustomRulesShareTheMostNetClasses() {
        QTemporaryDir folder;
        const fs::path board = fs::path(folder.path().toStdString()) / "b.kicad_pcb";
        const fs::path custom = fs::path(board).replace_extension(".kicad_dru");
        write(board, "(kicad_pcb (version 20241229))");
        write(fs::path(board).replace_extension(".kicad_pro"), kProject);
        std::string rules;
        for (std::size_t i = 1; i <= model::kMostNetClasses; ++i) {
            rules +=
                "(rule r (condition \"A.NetName == 'X" + std::to_string(i) + "'\") (constraint clearance (min 1mm)))\n";
        }
        write(custom, rules);
        for (const auto& file : {model::readRules(board), base::Result<model::RuleFile>(*model::kicadRulesOf(board))}) {
            QCOMPARE(model::netClassCount(file->table), model::kMostNetClasses);
            QCOMPARE(file->leftOut.back().file, custom);
            QVERIFY(
                file->leftOut.back().text.starts_with("copper-copper between X63 and any net, beyond the first 63"));
        }
    }

    void classesThatNoNetFitsAskForNothing() {
        QTemporaryDir folder;
        const fs::path path = fs::path(folder.path().toStdString()) / "b.kicad_pcb";
        write(path, "(kicad_pcb (version 20241229))");
        write(fs::path(path).replace_extension(".kicad_pro"), kProject);
        write(fs::path(path).replace_extension(".kicad_dru"),
              "(version 1)\n(rule x (condition \"A.NetName == 'CLK*'\") (constraint clearance (min 2mm)))");
        const model::RuleFile all = *model::kicadRulesOf(path);
        model::Document board;
        QVERIFY(model::kicadRulesFor(path, board)->table == all.table);  // it has no nets at all
        board.nets.push_back({"GND", {}});
        board.nets.push_back({"/A", {}});
        model::RuleFile fitting = all;
        model::leaveOutUnusedClasses(fitting, board);
        QVERIFY(model::kicadRulesFor(path, board)->table == fitting.table);
        QVERIFY(!model::kicadRulesFor(fs::path(path).replace_extension(".tgz"), board));
        QCOMPARE(fitting.leftOut, all.leftOut);  // classes that ask for nothing leave nothing unchecked
        const auto& rules = fitting.table.rules;
        const auto isOf = [](const Rule& rule, const char* name) { return std::ranges::count(rule.classes, name) > 0; };
        QVERIFY(std::ranges::any_of(rules, [&](const Rule& rule) { return isOf(rule, "Power"); }));
        QVERIFY(std::ranges::any_of(rules, [&](const Rule& rule) { return isOf(rule, "Fine"); }));
        QVERIFY(std::ranges::none_of(rules, [&](const Rule& rule) { return isOf(rule, "Finer"); }));
        QVERIFY(std::ranges::none_of(rules, [](const Rule& rule) { return rule.least == 2000 * kUm; }));
        QCOMPARE(
            std::ranges::count(fitting.unused, "no net of the board fits net class Finer; its rules ask for nothing"),
            1);
        QCOMPARE(
            std::ranges::count(fitting.unused, "no net of the board fits the name CLK*; its rules ask for nothing"), 1);

        // What KiCad would read as regular expressions is not taken for names.
        model::RuleFile regular = all;
        for (const char* pattern : {"/bus/.*", "D[PN]", "^X", "D[3]", "N$1", "/A"}) {
            regular.table.classes.push_back({std::string("C ") + pattern, {pattern}});
            regular.table.rules.push_back({RuleKind::TrackWidth, 1, {std::string("C ") + pattern}});
        }
        model::leaveOutUnusedClasses(regular, board);
        const std::vector<std::string> leftOut = textsOf(regular.leftOut);
        QCOMPARE(leftOut.size(), all.leftOut.size() + 3);
        QCOMPARE(leftOut.back(), std::string("pattern ^X of net class C ^X, a regular expression, is left out"));
        QCOMPARE(std::ranges::count(regular.unused,
                                    "no net of the board fits net class C /bus/.*; its rules ask for nothing"),
                 0);
        QCOMPARE(
            std::ranges::count(regular.unused, "no net of the board fits net class C D[3]; its rules ask for nothing"),
            1);

        // Nor is a name of a class amiss that older boards had.
        fitting = all;
        fitting.table.classes.push_back({"Mixed", {"GND", "OLD_5V"}});
        fitting.table.rules.push_back({RuleKind::TrackWidth, 1, {"Mixed"}});
        model::leaveOutUnusedClasses(fitting, board);
        QCOMPARE(fitting.table.classes.back().nets, std::vector<std::string>{"GND"});

        // Rules that somebody wrote for the board keep what fits nothing.
        fitting = all;
        fitting.isOfKicad = false;
        model::leaveOutUnusedClasses(fitting, board);
        QVERIFY(fitting.table == all.table);
    }
};

QTEST_APPLESS_MAIN(KicadProjectRulesTest)
#include "kicad_project_rules_test.moc"
