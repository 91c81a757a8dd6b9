// Rules and net classes as tables: what can be edited, what is refused, and that files keep it.
#include "ui/clearance/rule_model.h"

#include <QAbstractItemModelTester>
#include <QSignalSpy>
#include <QtTest>

#include "model/clearance/rule_file.h"
#include "ui/clearance/net_class_model.h"

using model::RuleKind;
using ui::NetClassModel;
using ui::RuleModel;

class RuleModelTest : public QObject {
    Q_OBJECT

    static bool set(RuleModel& rules, int row, int column, const QVariant& value) {
        const int role = column == RuleModel::On ? Qt::CheckStateRole : Qt::EditRole;
        return rules.setData(rules.index(row, column), value, role);
    }
    static bool set(NetClassModel& classes, int row, int column, const char* text) {
        return classes.setData(classes.index(row, column), text, Qt::EditRole);
    }
    static QString text(const QAbstractItemModel& model, int row, int column) {
        return model.index(row, column).data().toString();
    }

private slots:
    void aTableIsBuiltByHandAndOutlivesItsFile() {
        RuleModel rules;
        NetClassModel classes(rules, {"VCC1", "VCC2", "GND", "D0"});
        const QAbstractItemModelTester rulesKeepPromises(&rules);
        const QAbstractItemModelTester classesKeepPromises(&classes);
        classes.addClass();
        QVERIFY(set(classes, 0, NetClassModel::Name, "power"));
        QVERIFY(set(classes, 0, NetClassModel::Nets, " VCC*,, GND "));
        QCOMPARE(text(classes, 0, NetClassModel::Nets), "VCC*, GND");
        QCOMPARE(text(classes, 0, NetClassModel::Fits), "3 nets");
        rules.addRule();
        const int row = rules.rowCount() - 1;
        QVERIFY(set(rules, row, RuleModel::First, "power"));
        QVERIFY(set(rules, row, RuleModel::Least, "0.25"));  // millimetres
        QVERIFY(set(rules, 1, RuleModel::On, Qt::Unchecked));
        const model::RuleTable& table = rules.rules();
        QVERIFY(table.rules.back() == (model::Rule{RuleKind::CopperToCopper, 250'000, {"power", ""}}));
        QVERIFY(!table.rules[1].isOn);
        QCOMPARE(text(rules, row, RuleModel::Title), "copper-copper between power and any net");
        QCOMPARE(text(rules, 1, RuleModel::Result), "off");
        const auto again = model::parseRules(model::toJson(table));
        QVERIFY2(again, again ? "" : again.error().text.c_str());
        QVERIFY(*again == table);
    }

    void aClassIsRenamedInItsRulesAndKeptWhileTheySpeakOfIt() {
        RuleModel rules;
        NetClassModel classes(rules, {});
        classes.addClass();
        classes.addClass();
        QVERIFY(set(rules, 0, RuleModel::Second, "class 1"));
        QVERIFY(set(classes, 0, NetClassModel::Name, "bus"));
        QCOMPARE(rules.rules().rules[0].classes[1], std::string("bus"));
        const QSignalSpy refused(&rules, &RuleModel::refused);
        QVERIFY(!set(classes, 1, NetClassModel::Name, "bus"));
        QVERIFY(!set(classes, 1, NetClassModel::Name, "  "));
        classes.removeClass(0);
        QCOMPARE(refused.count(), 3);
        QVERIFY(refused.last()[0].toString().startsWith("Rule 1 uses bus"));
        QCOMPARE(classes.rowCount(), 2);
        classes.removeClass(1);
        QVERIFY(set(rules, 0, RuleModel::Second, "any net"));
        classes.removeClass(0);
        QCOMPARE(classes.rowCount(), 0);
        QVERIFY(rules.rules() == model::defaultRules());
    }

    /// As a preset is chosen in the dialog, whose table of classes has a current row.
    void otherRulesBringTheirClasses() {
        RuleModel rules;
        NetClassModel classes(rules, {});
        const QAbstractItemModelTester classesKeepPromises(&classes);
        classes.addClass();
        const QPersistentModelIndex current(classes.index(0, NetClassModel::Name));
        const QSignalSpy reset(&classes, &QAbstractItemModel::modelReset);
        rules.replaceRules(model::defaultRules());
        QCOMPARE(reset.count(), 1);
        QCOMPARE(classes.rowCount(), 0);
        QVERIFY(!current.isValid());
        classes.removeClass(0);
        QVERIFY(rules.rules() == model::defaultRules());
        model::RuleTable withClass = model::defaultRules();
        withClass.classes.push_back({"power", {"VCC*"}});
        rules.replaceRules(withClass);
        QCOMPARE(reset.count(), 2);
        QCOMPARE(text(classes, 0, NetClassModel::Name), "power");
    }

    void whatIsNoRuleIsRefused() {
        RuleModel rules;
        const model::RuleTable before = rules.rules();
        QVERIFY(!set(rules, 0, RuleModel::Kind, "copper-sky"));
        QVERIFY(!set(rules, 0, RuleModel::First, "nobody"));
        QVERIFY(!set(rules, 5, RuleModel::First, "any net"));  // not of nets
        QVERIFY(!set(rules, 3, RuleModel::Layer, "outer"));    // on all layers at once
        QVERIFY(!set(rules, 0, RuleModel::Layer, "sky"));
        QVERIFY(!set(rules, 0, RuleModel::FirstObject, "microvia"));
        for (const char* least : {"0", "-1", "apple", "1e9", "0.0000001"}) {
            QVERIFY2(!set(rules, 0, RuleModel::Least, least), least);
        }
        QVERIFY(!set(rules, 0, RuleModel::Title, "x"));
        QVERIFY(rules.rules() == before);
    }

    /// What is shown is rounded to the unit; a cell that was looked at and left keeps its length.
    void anEditThatChangesNothingChangesNothing() {
        RuleModel rules;
        rules.setUnit(ui::LengthUnit::Mil);
        const QSignalSpy edited(&rules, &RuleModel::edited);
        QVERIFY(set(rules, 0, RuleModel::Least, rules.index(0, RuleModel::Least).data(Qt::EditRole)));
        QCOMPARE(rules.rules().rules[0].least, model::Nm{100'000});
        QVERIFY(set(rules, 0, RuleModel::Kind, "copper-copper"));
        QCOMPARE(edited.count(), 0);
    }

    void aKindKeepsWhatItKnows() {
        RuleModel rules;
        NetClassModel classes(rules, {});
        classes.addClass();
        QVERIFY(set(rules, 0, RuleModel::First, "class 1"));
        QVERIFY(set(rules, 0, RuleModel::Kind, "hole-hole"));
        QVERIFY(rules.rules().rules[0] == (model::Rule{RuleKind::HoleToHole, 100'000, {"class 1", ""}}));
        QVERIFY(model::parseRules(model::toJson(rules.rules())));
        QCOMPARE(text(rules, 0, RuleModel::FirstObject), "any");
        QVERIFY(set(rules, 0, RuleModel::SecondObject, "microvia"));
        QVERIFY(!set(rules, 0, RuleModel::SecondObject, "track"));
        QCOMPARE(text(rules, 0, RuleModel::Title),
                 "hole-hole between class 1 and any net between any holes and microvias");
        QVERIFY(set(rules, 0, RuleModel::Kind, "mask-sliver"));
        QVERIFY(rules.rules().rules[0] == (model::Rule{RuleKind::MaskSliver, 100'000, {}}));
        QCOMPARE(text(rules, 0, RuleModel::First), "");
        QVERIFY(set(rules, 0, RuleModel::Kind, "floating-copper"));
        QCOMPARE(text(rules, 0, RuleModel::Least), "");
        QVERIFY((rules.flags(rules.index(0, RuleModel::Least)) & Qt::ItemIsEditable) == 0);
        QVERIFY(model::parseRules(model::toJson(rules.rules())));
    }

    /// Which has no unit.
    void anAspectRatioIsTyped() {
        RuleModel rules;
        rules.setUnit(ui::LengthUnit::Mil);
        QVERIFY(set(rules, 0, RuleModel::Kind, "aspect-ratio"));
        QCOMPARE(text(rules, 0, RuleModel::Least), "10 : 1");
        QVERIFY((rules.flags(rules.index(0, RuleModel::Least)) & Qt::ItemIsEditable) != 0);
        QVERIFY(set(rules, 0, RuleModel::FirstObject, "microvia"));
        for (const auto& [typed, ratio] : {std::pair("8", 8.0), {"0.8 : 1", 0.8}, {" 7.5:1 ", 7.5}}) {
            QVERIFY2(set(rules, 0, RuleModel::Least, typed), typed);
            QVERIFY(rules.rules().rules[0] ==
                    (model::Rule{
                        RuleKind::AspectRatio, 0, {}, true, {model::HoleClass::Microvia}, {}, "", false, 0, ratio}));
        }
        const QSignalSpy refused(&rules, &RuleModel::refused);
        for (const char* typed : {"0", "101", "8 mm", "8 : 2", ": 1", "8 :", "apple", "-8"}) {
            QVERIFY2(!set(rules, 0, RuleModel::Least, typed), typed);
        }
        QCOMPARE(refused.count(), 8);
        QVERIFY(model::parseRules(model::toJson(rules.rules())));
        QVERIFY(set(rules, 0, RuleModel::Kind, "hole-size"));
        QVERIFY(rules.rules().rules[0] ==
                (model::Rule{RuleKind::HoleSize, 100'000, {}, true, {model::HoleClass::Microvia}}));
    }

    void objectsAndLayersAreChosen() {
        RuleModel rules;
        rules.setLayers({"TOP"});
        QVERIFY(set(rules, 0, RuleModel::Kind, "copper-copper within a net"));
        QVERIFY(set(rules, 0, RuleModel::FirstObject, "track"));
        QVERIFY(set(rules, 0, RuleModel::SecondObject, "plane"));
        QVERIFY(set(rules, 0, RuleModel::Layer, "TOP"));
        QCOMPARE(text(rules, 0, RuleModel::Title), "copper-copper within a net between tracks and planes on TOP");
        QVERIFY(set(rules, 1, RuleModel::SecondObject, "microvia"));  // copper-hole: the second side
        QCOMPARE(text(rules, 1, RuleModel::Title), "copper-hole of microvias");
        const auto again = model::parseRules(model::toJson(rules.rules()));
        QVERIFY(again);
        QVERIFY(*again == rules.rules());
    }

    void rowsAreAddedMovedAndRemovedButTheLast() {
        RuleModel rules;
        const QAbstractItemModelTester promises(&rules);
        const auto first = rules.rules().rules[0];
        QCOMPARE(rules.moveRule(0, -1), 0);
        QCOMPARE(rules.moveRule(0, 1), 1);
        QVERIFY(rules.rules().rules[1] == first);
        for (int row = rules.rowCount(); row > 0; --row) {
            rules.removeRule(0);
        }
        QCOMPARE(rules.rowCount(), 1);
    }

    void theToleranceIsALengthOfAtMostTenMicrometres() {
        RuleModel rules;
        const QSignalSpy edited(&rules, &RuleModel::edited);
        QVERIFY(rules.setTolerance(rules.tolerance()));
        QCOMPARE(edited.count(), 0);
        QVERIFY(rules.setTolerance("1.5 um"));
        QCOMPARE(rules.rules().tolerance, model::Nm{1500});
        QVERIFY(rules.setTolerance("0"));
        QCOMPARE(rules.rules().tolerance, model::Nm{0});
        QVERIFY(!rules.setTolerance("11 um") && !rules.setTolerance("apple") && !rules.setTolerance("-1"));
        QCOMPARE(edited.count(), 2);
    }

    void resultsAreForgottenByEveryEdit() {
        RuleModel rules;
        using model::Verdict;
        rules.setResults({{Verdict::Passed, 0, 0},
                          {Verdict::Failed, 1, 0},
                          {Verdict::Failed, 2, 1},
                          {Verdict::Incomplete, 0, 1},
                          {Verdict::Passed, 0, 0},
                          {Verdict::Passed, 0, 0}});
        QCOMPARE(text(rules, 0, RuleModel::Result), "pass");
        QCOMPARE(text(rules, 1, RuleModel::Result), "FAIL: 1");
        QCOMPARE(text(rules, 2, RuleModel::Result), "FAIL: 2; incomplete");
        QCOMPARE(text(rules, 3, RuleModel::Result), "incomplete, see below");
        QVERIFY(set(rules, 3, RuleModel::Least, "1 um"));
        QCOMPARE(text(rules, 0, RuleModel::Result), "not checked");
    }
};

QTEST_GUILESS_MAIN(RuleModelTest)
#include "rule_model_test.moc"
