// Rules as files: what is written is read back, and what is wrong in one is named by line and key.
#include <QtTest>
#include <algorithm>

#include "model/clearance/rule_file.h"
#include "tests/unit/model/hand_made.h"

using hand_made::kUm;
using model::RuleKind;
using model::RuleTable;

class RulesFileTest : public QObject {
    Q_OBJECT

private slots:
    void rulesOutliveTheirFile() {
        RuleTable table = model::defaultRules();
        table.classes = {{"power", {"VCC*", "GND"}}, {"clk", {"CLK?"}}};
        table.rules.push_back({RuleKind::CopperToCopper, 123'456, {"power", "clk"}});
        table.rules.push_back({RuleKind::CopperToCopper, 200 * kUm, {"", "power"}});
        table.rules[2].isOn = false;
        table.tolerance = 1250;
        table.rules.push_back(
            {RuleKind::HoleToHole, 1, {}, true, {model::HoleClass::NonPlated, model::HoleClass::Any}});
        const auto again = model::parseRules(model::toJson(table));
        QVERIFY2(again, again ? "" : again.error().text.c_str());
        QVERIFY(*again == table);
    }

    void ratiosAndHolesAreRead() {
        const auto table = model::parseRules(
            R"({"copperscope_rules": 1, "rules": [{"kind": "hole-size", "least_um": 300, "holes": "non-plated"},
                {"kind": "slot-width", "least_um": 500.5, "of": "net:A"},
                {"kind": "aspect-ratio", "most_ratio": 0.8, "holes": "microvia"}]})");
        QVERIFY2(table, table ? "" : table.error().text.c_str());
        const model::Rule expected[] = {
            {RuleKind::HoleSize, 300 * kUm, {}, true, {model::HoleClass::NonPlated}},
            {RuleKind::SlotWidth, 500'500, {"net:A", ""}},
            {RuleKind::AspectRatio, 0, {}, true, {model::HoleClass::Microvia}, {}, "", false, 0, 0.8}};
        QVERIFY(std::ranges::equal(table->rules, expected));
        QCOMPARE(model::titleOf(expected[0]), std::string("hole-size of NPTHs"));
        QCOMPARE(model::titleOf(expected[1]), std::string("slot-width of A"));
        QCOMPARE(model::titleOf(expected[2]), std::string("aspect-ratio of microvias"));
        QVERIFY(*model::parseRules(model::toJson(*table)) == *table);
    }

    void rulesArePrintedWithComments() {
        RuleTable table = model::defaultRules();
        table.classes = {{"power", {"VCC*", "GND"}}};
        const std::string text = model::commentedJson(table);
        QVERIFY2(text.find("// Between nets, on one layer") != std::string::npos, text.c_str());
        const auto again = model::parseRules(text);
        QVERIFY2(again, again ? "" : again.error().text.c_str());
        QVERIFY(*again == table);
    }

    void errorsNameLineAndKey() {
        const auto error = [](const char* second) {
            const std::string text = std::string(
                                         "// mine\n{\"copperscope_rules\": 1,\n \"rules\": [\n"
                                         "  {\"kind\": \"hole-hole\", \"least_um\": 1},\n"
                                         "  {\"kind\": \"hole-hole\",\n   ") +
                                     second + "}]}";
            const auto table = model::parseRules(text);
            return table ? std::string() : table.error().text;
        };
        QCOMPARE(error("\"least_um\": 1"), std::string());
        const std::string unknown = error("\"least_um\": 1, \"side\": \"TOP\"");
        QVERIFY2(unknown.find("line 6: unknown key \"side\"") != std::string::npos, unknown.c_str());
        const std::string zero = error("\"least_um\": 0");
        QVERIFY2(zero.find("line 6, rule 2: \"least_um\" must be above 0") != std::string::npos, zero.c_str());
        const std::string tiny = error("\"least_um\": 0.0001");
        QVERIFY2(tiny.find("line 6, rule 2: \"least_um\"") != std::string::npos, tiny.c_str());
        const std::string twice = error("\"least_um\": 1,\n \"least_um\": 2");
        QVERIFY2(twice.find("the key least_um is there twice") != std::string::npos, twice.c_str());
        const std::string broken = error("\"least_um\": ");
        QVERIFY2(broken.find("line 6") != std::string::npos, broken.c_str());
    }

    void badRulesAreNamed_data() {
        QTest::addColumn<QByteArray>("json");
        QTest::addColumn<QByteArray>("word");
        QTest::newRow("no JSON") << QByteArray("{") << QByteArray("no file");
        QTest::newRow("other version") << QByteArray(R"({"copperscope_rules": 2})") << QByteArray("version");
        QTest::newRow("empty") << QByteArray(R"({"copperscope_rules": 1})") << QByteArray("none");
        const auto rules = [](const char* rule) {
            return QByteArray(R"({"copperscope_rules": 1, "classes": {"p": ["V*"]}, "rules": [)") + rule + "]}";
        };
        QTest::newRow("no kind") << rules(R"({"least_um": 1})") << QByteArray("rule 1");
        QTest::newRow("unknown") << rules(R"({"kind": "copper-sky", "least_um": 1})") << QByteArray("copper-sky");
        QTest::newRow("negative") << rules(R"({"kind": "hole-hole", "least_um": -1})") << QByteArray("least_um");
        QTest::newRow("vast") << rules(R"({"kind": "hole-hole", "least_um": 1e300})") << QByteArray("least_um");
        QTest::newRow("class") << rules(R"({"kind": "copper-copper", "least_um": 1, "between": ["p", "q"]})")
                               << QByteArray("\"q\"");
        QTest::newRow("kind of class") << rules(R"({"kind": "mask-sliver", "least_um": 1, "between": ["p", ""]})")
                                       << QByteArray("copper-copper");
        QTest::newRow("switch") << rules(R"({"kind": "hole-hole", "least_um": 1, "on": 2})") << QByteArray("\"on\"");
        QTest::newRow("no ratio") << rules(R"({"kind": "aspect-ratio"})")
                                  << QByteArray("needs a number \"most_ratio\"");
        QTest::newRow("ratio of none") << rules(R"({"kind": "aspect-ratio", "most_ratio": 0})")
                                       << QByteArray("\"most_ratio\" must be a number from 0.1 to 100");
        QTest::newRow("vast ratio") << rules(R"({"kind": "aspect-ratio", "most_ratio": 101})")
                                    << QByteArray("from 0.1 to 100");
        QTest::newRow("ratio as text") << rules(R"({"kind": "aspect-ratio", "most_ratio": "8 : 1"})")
                                       << QByteArray("from 0.1 to 100");
        QTest::newRow("length for ratio") << rules(R"({"kind": "aspect-ratio", "most_ratio": 8, "least_um": 1})")
                                          << QByteArray("has no \"least_um\"");
        QTest::newRow("ratio for length")
            << rules(R"({"kind": "hole-size", "least_um": 1, "most_ratio": 8})") << QByteArray("has no \"most_ratio\"");
        QTest::newRow("layer of holes") << rules(R"({"kind": "slot-width", "least_um": 1, "layer": "top"})")
                                        << QByteArray("a rule like hole-hole has none");
        QTest::newRow("holes") << rules(R"({"kind": "annular-ring", "least_um": 1, "holes": "round"})")
                               << QByteArray("\"round\"");
        QTest::newRow("two holes") << rules(R"({"kind": "hole-hole", "least_um": 1, "holes": "plated"})")
                                   << QByteArray("two of a hole-hole rule");
        QTest::newRow("tolerance") << QByteArray(R"({"copperscope_rules": 1, "tolerance_um": 10.1, "rules": []})")
                                   << QByteArray("tolerance_um");
        QTest::newRow("list") << QByteArray(R"({"copperscope_rules": 1, "classes": {"p": "V"}, "rules": []})")
                              << QByteArray("\"p\"");
        QTest::newRow("odd classes") << QByteArray(R"({"copperscope_rules": 1, "classes": 3, "rules": 4})")
                                     << QByteArray("rules");
    }
    void badRulesAreNamed() {
        QFETCH(QByteArray, json);
        QFETCH(QByteArray, word);
        const auto table = model::parseRules(json.toStdString());
        QVERIFY(!table);
        QVERIFY2(table.error().text.find(word.toStdString()) != std::string::npos, table.error().text.c_str());
    }
};

QTEST_GUILESS_MAIN(RulesFileTest)
#include "design_rules_file_test.moc"
