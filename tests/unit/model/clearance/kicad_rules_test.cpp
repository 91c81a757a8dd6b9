// KiCad's custom rules, and the presets that come with the program.
#include "model/clearance/kicad_rules.h"

#include <QTemporaryDir>
#include <QtTest>
#include <algorithm>
#include <filesystem>
#include <fstream>

#include "model/clearance/rule_presets.h"

using model::Rule;
using model::RuleKind;

namespace {

namespace fs = std::filesystem;

constexpr model::Nm kUm = 1000;

model::RuleFile import(const std::string& text) {
    const auto file = model::parseKicadRules(text);
    return file ? *file : model::RuleFile{};
}

}  // namespace

class KicadRulesTest : public QObject {
    Q_OBJECT

private slots:
    void minimumsAreImported() {
        const model::RuleFile file = import(R"dru((version 1)
(rule "spacing" (constraint clearance (min 0.2mm) (opt 0.3mm)))
(rule power (layer outer) (condition "A.NetClass == 'HV' && B.NetName == 'GND*'") (constraint clearance (min 20mil)))
(rule planes (condition "A.Type == 'Track' && B.Type == 'Zone'") (constraint clearance (min 0.25mm)))
(rule off (severity ignore) (constraint edge_clearance (min 0.5mm)))
(rule holes (constraint hole_to_hole (min 0.25mm)) (constraint hole_clearance (min 0.2mm)))
(rule rest (constraint annular_width (min 0.1mm)) (constraint track_width (min 100um) (max 3mm))
           (constraint silk_clearance (min 0.15mm)) (constraint creepage (min 8mm))))dru");
        QVERIFY(file.leftOut.empty());
        const std::vector<Rule>& rules = file.table.rules;
        QCOMPARE(rules.size(), std::size_t{10});
        QVERIFY(rules[0] == (Rule{RuleKind::CopperToCopper, 200 * kUm, {}}));
        QVERIFY(rules[1] == (Rule{RuleKind::CopperToCopper, 508 * kUm, {"HV", "net:GND*"}, true, {}, {}, "outer"}));
        QCOMPARE(model::titleOf(rules[2]), std::string("copper-copper between tracks and planes"));
        QVERIFY(rules[3] == (Rule{RuleKind::CopperToEdge, 500 * kUm, {}, false}));
        QVERIFY(rules[8].kind == RuleKind::SilkToPad && rules[9].kind == RuleKind::Creepage);
        QVERIFY(file.table.classes == (std::vector<model::NetClass>{{"HV", {}}}));
        QVERIFY(model::parseRules(model::toJson(file.table)));
    }

    void whatHasNoCounterpartIsNamed() {
        const model::RuleFile file = import(R"dru((version 1)
(rule a (constraint clearance (min 0.2mm)))
(rule b (constraint length (min 1mm)))
(rule c
  (condition "A.insideArea('x')")
  (constraint clearance (min 0.2mm)))
(rule d (constraint track_width (max 1mm)))
(rule e (layer "F.Cu") (constraint hole_to_hole (min 1mm)))
(rule f (constraint clearance (min 0mm)))
(sheet x))dru");
        QCOMPARE(file.table.rules.size(), std::size_t{1});
        std::vector<std::string> leftOut;
        std::ranges::transform(file.leftOut, std::back_inserter(leftOut), model::textOf);
        QCOMPARE(
            leftOut,
            (std::vector<std::string>{
                "line 3: rule b, length 1mm is left out", "line 5: rule c, condition A.insideArea('x') is left out",
                "line 7: rule d, track_width without min is left out", "line 8: rule e, layer F.Cu is left out",
                "line 9: rule f, clearance 0mm is left out", "line 10: (sheet) is left out"}));
    }

    /// Conditions as fabricators' rules for KiCad have them.
    void conditionsBecomeSidesOfRules() {
        using model::CopperObject;
        using model::HoleClass;
        const auto of = [](const std::string& constraint, const std::string& condition) {
            const model::RuleFile file =
                import("(rule x (constraint " + constraint + " (min 0.2mm)) (condition \"" + condition + "\"))");
            return file.table.rules;
        };
        const auto is = [](const std::vector<Rule>& rules, const std::vector<Rule>& expected) {
            return rules == expected;
        };
        const Rule between{RuleKind::CopperToCopper, 200 * kUm, {}};
        Rule one = between;
        one.classes = {"HV", ""};
        QVERIFY(is(of("clearance", "A.hasNetclass('HV')"), {one}));
        QVERIFY(is(of("clearance", " ( A.NetClass=='HV' ) "), {one}));
        one.classes = {"HV", "LV"};
        QVERIFY(is(of("clearance", "A.hasNetclass('HV') && B.hasExactNetclass('LV') && A.Net != B.Net"), {one}));
        one = between;
        one.objects = {CopperObject::Track, CopperObject::Track};
        one.layer = "F.Cu";
        QVERIFY(is(of("clearance", "A.Type == 'track' && B.Type == A.Type && A.Layer == 'F.Cu'"), {one}));
        Rule pad = between;
        Rule via = between;
        pad.isSameNet = via.isSameNet = true;
        pad.objects = {CopperObject::Via, CopperObject::Pad};
        via.objects = {CopperObject::Via, CopperObject::Via};
        QVERIFY(is(of("clearance", "A.Type == 'Via' && (B.Type == 'Pad' || B.Type == 'Via') && A.NetName == B.NetName"),
                   {pad, via}));
        Rule hole{RuleKind::CopperToHole, 200 * kUm, {}, true, {HoleClass::NonPlated}, {CopperObject::Track}};
        QVERIFY(is(of("hole_clearance", "!A.isPlated() && B.Type == 'Track'"), {hole}));
        Rule micro = hole;
        hole.holes = {HoleClass::Plated};
        micro.holes = {HoleClass::Microvia};
        QVERIFY(is(of("hole_clearance", "A.isPlated() && B.Type == 'Track' && A.Net != B.Net"), {hole, micro}));
        const Rule silk{RuleKind::SilkToPad, 200 * kUm, {}};
        QVERIFY(is(of("silk_clearance", "A.Type == 'pad' && B.Layer == '?.Silkscreen'"), {silk}));
    }

    /// To KiCad the size of a hole is the width of a slot, too. All of its vias are round, and all of its NPTHs are
    /// pads.
    void sizesOfHolesAreThoseOfSlotsToo() {
        using model::HoleClass;
        const auto of = [](const std::string& condition) {
            return import("(rule x (constraint hole_size (min 0.3mm) (max 6.3mm)) " + condition + ")").table.rules;
        };
        const auto is = [](const std::vector<Rule>& rules, const std::vector<Rule>& expected) {
            return rules == expected;
        };
        const auto size = [](HoleClass holes) { return Rule{RuleKind::HoleSize, 300 * kUm, {}, true, {holes}}; };
        const auto slot = [](HoleClass holes) { return Rule{RuleKind::SlotWidth, 300 * kUm, {}, true, {holes}}; };
        QVERIFY(is(of(""), {size(HoleClass::Any), slot(HoleClass::Any)}));
        QVERIFY(is(of("(condition \"A.isMicroVia()\")"), {size(HoleClass::Microvia)}));
        QVERIFY(is(of("(condition \"A.isPlated()\")"),
                   {size(HoleClass::Plated), size(HoleClass::Microvia), slot(HoleClass::Plated)}));
        const std::vector<Rule> npth{size(HoleClass::NonPlated), slot(HoleClass::NonPlated)};
        QVERIFY(is(of("(condition \"!A.isPlated()\")"), npth));
        QVERIFY(is(of("(condition \"A.Type == 'Pad' && !A.isPlated()\")"), npth));
        QVERIFY(is(of("(condition \"A.Type == 'Pad' && A.Pad_Type == 'NPTH, mechanical' && !A.isPlated()\")"), npth));
        for (const char* condition :
             {"A.Type == 'Via'", "A.Type == 'Pad'", "A.Type == 'Pad' && A.isPlated()", "A.Pad_Type == 'Through-hole'",
              "A.Pad_Type == 'NPTH, mechanical' && A.isPlated()"}) {
            QVERIFY2(of("(condition \"" + std::string(condition) + "\")").empty(), condition);
        }
        const model::RuleFile largest = import("(rule x (constraint hole_size (max 6.3mm)))");
        QCOMPARE(model::textOf(largest.leftOut.at(0)),
                 std::string("line 1: rule x, hole_size without min is left out"));
    }

    void conditionsWithoutACounterpartAreNotCutShort() {
        for (const char* condition :
             {"A.hasNetclass('HV') || A.insideArea('x')", "A.hasNetclass('Default')", "!A.hasNetclass('HV')",
              "A.NetClass != 'HV'", "A.Type == 'Via' && A.Type == 'Pad'", "A.isPlated()", "A.Type == B.Type",
              "A.Width > 1mm", "(A.Type == 'Via'", "A.Type == 'Via')", "A.Type = 'Via'", "A.Type == A.Type", "", "A.",
              "A.Type == 'Via' &&", "A.Net == 'GND' B", "!(A.Type == 'Via')",
              "A.Layer == 'F.Cu' && A.Layer == 'B.Cu'"}) {
            const model::RuleFile file =
                import("(rule x (constraint clearance (min 0.2mm)) (condition \"" + std::string(condition) + "\"))");
            QVERIFY2(file.table.rules.empty() && file.leftOut.size() == 1, condition);
        }
        for (const char* condition : {"A.Type == 'Via' && B.Type == 'Track'", "A.Net == B.Net"}) {  // holes of vias
            QVERIFY2(import("(rule x (constraint hole_clearance (min 0.2mm)) (condition \"" + std::string(condition) +
                            "\"))")
                         .table.rules.empty(),
                     condition);
        }
        std::string deep(10'000, '(');
        QVERIFY(import("(rule x (constraint clearance (min 1mm)) (condition \"" + deep + "\"))").table.rules.empty());
        std::string many = "(A.Type == 'Via' || A.Type == 'Pad')";
        for (int i = 0; i < 10; ++i) {
            many += " && (B.NetName == 'A' || B.NetName == 'B')";
        }
        QVERIFY(import("(rule x (constraint clearance (min 1mm)) (condition \"" + many + "\"))").table.rules.empty());
    }

    void namesThatAreNoUtf8AreLeftOut() {
        const auto file = model::parseKicadRules(
            "(version 1)(rule a (condition \"A.NetClass == 'gr\xFC"
            "n'\") (constraint clearance (min 0.2mm)))(rule b (layer \"\xE0\x80\x80\") (constraint clearance (min "
            "0.2mm)))(rule c (constraint clearance (min 0.3mm)))");
        QVERIFY(file);
        QCOMPARE(file->table.rules.size(), std::size_t{1});
        QCOMPARE(file->leftOut.size(), std::size_t{2});
        QVERIFY(file->leftOut[0].text.find("no UTF-8") != std::string::npos);
    }

    /// Whoever makes a table may name what JSON does not know.
    void aTableWithSuchNamesIsPrinted() {
        model::RuleTable table = model::defaultRules();
        table.classes.push_back({"gr\xFCn", {"\xFF*"}});
        table.rules.push_back({RuleKind::CopperToCopper, 100'000, {"gr\xFCn", ""}});
        QVERIFY(model::parseRules(model::commentedJson(table)));
        QVERIFY(model::parseRules(model::toJson(table)));
    }

    void rulesThatKicadIgnoresAreNamed() {
        const model::RuleFile file =
            import("(version 1)\n(rule a (severity ignore) (constraint clearance (min 0.2mm)))\n");
        QVERIFY(!file.table.rules.front().isOn);
        QCOMPARE(file.unused.size(), std::size_t{1});
        QVERIFY(file.unused.front().starts_with("line 2: rule a has severity ignore"));
        QVERIFY(import("(rule a (severity error) (constraint clearance (min 0.2mm)))").unused.empty());
    }

    void aFileOfNothingIsAnErrorThatNamesAllOfIt() {
        QTemporaryDir folder;
        const fs::path path = fs::path(folder.path().toStdString()) / "b.kicad_dru";
        const auto errorOf = [&](const char* text) {
            std::ofstream(path, std::ios::binary) << text;
            const auto file = model::readRules(path);
            return file ? std::string() : file.error().text;
        };
        QVERIFY(!errorOf("").empty());
        QVERIFY(!errorOf("(rule").empty());
        QCOMPARE(errorOf("(version 1)\n(rule x (constraint length (min 1mm)))\n"
                         "(rule y (condition \"A.insideArea('HV')\") (constraint clearance (min 1mm)))"),
                 std::string("the rules cannot be used: no minimum in KiCad's files has a counterpart; line 2: rule x, "
                             "length 1mm is left out; line 3: rule y, condition A.insideArea('HV') is left out"));
        std::string many;
        for (int i = 0; i < 30; ++i) {
            many += "(sheet)\n";
        }
        QVERIFY(errorOf(many.c_str()).ends_with("line 20: (sheet) is left out; and 10 more"));
    }

    /// What a check cannot tell apart would hold for every net.
    void rulesBeyondTheLastNetClassAreLeftOut() {
        const auto rulesOf = [](const char* property, int count) {
            std::string text;
            for (int i = 1; i <= count; ++i) {
                text += "(rule r (condition \"A." + std::string(property) + " == 'X" + std::to_string(i) +
                        "'\") (constraint clearance (min 1mm)))\n";
            }
            return text;
        };
        const std::string last = "(rule last (constraint clearance (min 0.1mm)))";
        const model::RuleFile names = import(rulesOf("NetName", 65) + last);
        QCOMPARE(names.table.rules.size(), std::size_t{64});
        QCOMPARE(names.table.rules[62].classes[0], std::string("net:X63"));
        QVERIFY(names.table.rules[63] == (Rule{RuleKind::CopperToCopper, 100 * kUm, {}}));
        QCOMPARE(names.leftOut.size(), std::size_t{2});
        QCOMPARE(model::textOf(names.leftOut[0]), std::string("copper-copper between X64 and any net, beyond the first "
                                                              "63 net classes and names of nets, is left out"));
        QVERIFY(model::parseRules(model::toJson(names.table)));

        const model::RuleFile both = import(rulesOf("NetClass", 40) + rulesOf("NetName", 25));
        QCOMPARE(both.table.rules.size(), std::size_t{63});
        QCOMPARE(both.table.classes.size(), std::size_t{40});
        QCOMPARE(both.leftOut.size(), std::size_t{2});
        const model::RuleFile classes = import(rulesOf("NetClass", 65));
        QCOMPARE(classes.table.classes.size(), model::kMostNetClasses);
        QCOMPARE(classes.table.rules.size(), model::kMostNetClasses);
    }

    void presetsAreRules() {
        QVERIFY(model::rulePresets().size() >= 5);
        for (const model::RulePreset& preset : model::rulePresets()) {
            const auto table = model::parseRules(preset.text);
            QVERIFY2(table, table ? "" : table.error().text.c_str());
            QVERIFY(model::titleOf(preset).size() > 5);
            QVERIFY(model::readRules(preset.name));
        }
        QVERIFY(!model::readRules("no such preset"));
    }
};

QTEST_APPLESS_MAIN(KicadRulesTest)
#include "kicad_rules_test.moc"
