#include <QComboBox>
#include <QDialogButtonBox>
#include <QLabel>
#include <QPushButton>
#include <QtTest>
#include <fstream>

#include "model/clearance/design_rules.h"
#include "tests/locations.h"
#include "tests/patience.h"
#include "tests/ui/window_fixture.h"
#include "ui/clearance/clearance_feature.h"
#include "ui/clearance/rule_dialog.h"
#include "ui/clearance/rule_model.h"
#include "ui/common/paths.h"
#include "ui/messages/message_model.h"
#include "ui/workspace/board_watch.h"

namespace fs = std::filesystem;
using model::RuleKind;
using ui::ActionId;

namespace {

constexpr const char* kProject = R"json({
"board": {"design_settings": {"rules": {"min_clearance": 0.17, "min_track_width": 0.13,
  "min_via_diameter": 0.5}}},
"net_settings": {
  "classes": [{"name": "Default", "clearance": 0.21}, {"name": "Power", "clearance": 0.43},
              {"name": "Elsewhere", "clearance": 0.9}],
  "netclass_patterns": [{"netclass": "Power", "pattern": "GN*"}, {"netclass": "Elsewhere", "pattern": "RF_*"}]}})json";

}  // namespace

/// The rules that a board of KiCad begins with, and what becomes of them.
class ProjectRulesTest : public QObject {
    Q_OBJECT

private slots:
    void init() {
        m_fixture = std::make_unique<WindowFixture>();
        window().find<ui::BoardWatch>().setQuietMs(100);
        m_board = fs::path(m_fixture->folder().toStdString()) / "small.kicad_pcb";
        fs::copy_file(fs::path(locations::kTestData) / "kicad" / "small.kicad_pcb", m_board);
        std::ofstream(fs::path(m_board).replace_extension(".kicad_pro")) << kProject;
        QVERIFY(m_fixture->openAndWait(ui::fromPath(m_board)));
    }
    void cleanup() { QCOMPARE(validationErrorsOnClosing(m_fixture), 0U); }

    void theWindowBeginsWithTheRulesOfTheProject() {
        const std::vector<model::Rule> expected = {{RuleKind::CopperToCopper, 210'000, {"", ""}},
                                                   {RuleKind::CopperToCopper, 430'000, {"Power", ""}},
                                                   {RuleKind::TrackWidth, 130'000, {}}};
        QVERIFY(rules().rules == expected);  // without those of the class that no net fits
        const ui::RuleModel& model = window().find<ui::RuleModel>();
        QCOMPARE(model.rowCount(), 3);
        QCOMPARE(model.index(1, ui::RuleModel::First).data().toString(), "Power");
    }

    /// min_via_diameter has no counterpart: neither list nor verdict may be silent about it.
    void whatIsLeftOutOfTheProjectIsSaid() {
        const QString said = "Design rules: min_via_diameter is left out";
        QCOMPARE(messageAt(said), QString("small.kicad_pro:3"));
        QVERIFY(!messageAt("Design rules: no net of the board fits net class Elsewhere; its rules ask for nothing")
                     .isNull());
        check();
        const QString verdict = window().panel("clearances").findChild<QLabel*>("summary")->text();
        QVERIFY2(!verdict.contains("All rules pass"), qPrintable(verdict));
        const QString notes = window().panel("clearances").findChild<QLabel*>("notes")->text();
        QVERIFY2(notes.contains("not checked: 1 entry of the file of rules"), qPrintable(notes));

        // Another file of rules has its own; undone, those of the project are back.
        const fs::path custom = m_board.parent_path() / "other.kicad_dru";
        std::ofstream(custom) << "(version 1)\n(rule a (constraint clearance (min 0.01mm)))\n(sheet)";
        QVERIFY(window().find<ui::ClearanceFeature>().openRules(ui::fromPath(custom)));
        QVERIFY(messageAt(said).isNull());
        QCOMPARE(messageAt("Design rules: (sheet) is left out"), QString("other.kicad_dru:3"));
        window().workspace().history().undo();
        QVERIFY(!messageAt(said).isNull());
        QVERIFY(messageAt("Design rules: (sheet) is left out").isNull());
    }

    void ofADamagedProjectTheCommonRulesAreLeft() {
        std::ofstream(fs::path(m_board).replace_extension(".kicad_pro")) << std::string(kProject).substr(0, 90);
        reload();
        QVERIFY(rules() == model::defaultRules());
        QCOMPARE(messageAt("Design rules: it cannot be read and is left out: ", Qt::MatchStartsWith),
                 QString("small.kicad_pro"));
        std::ofstream(fs::path(m_board).replace_extension(".kicad_pro")) << kProject;
        reload();  // nothing of it was kept
        QCOMPARE(rules().rules[1].least, model::Nm{430'000});
    }

    void commonRulesThatWereChosenLastOverAReload() {
        const model::RuleTable ofProject = rules();
        window().actions()[ActionId::EditRules].trigger();
        auto* dialog = window().findChild<ui::RuleDialog*>();
        QVERIFY(dialog != nullptr);
        auto* presets = dialog->findChild<QComboBox*>("presets");
        presets->setFocus();
        QTest::keyClick(presets, Qt::Key_Down);
        QTest::keyClick(presets, Qt::Key_Return);
        QTRY_VERIFY(dialog->rules().rules() == model::defaultRules());
        QTest::mouseClick(dialog->findChild<QDialogButtonBox*>()->button(QDialogButtonBox::Ok), Qt::LeftButton);
        QVERIFY(rules() == model::defaultRules());

        reload();
        QVERIFY(rules() == model::defaultRules());
        m_fixture->restart();
        QVERIFY(m_fixture->openAndWait(ui::fromPath(m_board)));
        QVERIFY(rules() == model::defaultRules());

        // Back to those of the project they are in no session again, and follow the project.
        window().workspace().history().clear();
        window().actions()[ActionId::EditRules].trigger();
        dialog = window().findChild<ui::RuleDialog*>();
        dialog->rules().replaceRules(ofProject);
        QTest::mouseClick(dialog->findChild<QDialogButtonBox*>()->button(QDialogButtonBox::Ok), Qt::LeftButton);
        QVERIFY(rules() == ofProject);
        std::string text = kProject;
        text.replace(text.find("0.43"), 4, "0.55");
        std::ofstream(fs::path(m_board).replace_extension(".kicad_pro")) << text;
        reload();
        QCOMPARE(rules().rules[1].least, model::Nm{550'000});
    }

    void checksOfTheProjectAreComplete() {
        check();
        const ui::RuleModel& model = window().find<ui::RuleModel>();
        for (int row = 0; row < model.rowCount(); ++row) {
            const QString result = model.index(row, ui::RuleModel::Result).data().toString();
            QVERIFY2(!result.contains("incomplete"), qPrintable(result));
        }
    }

private:
    [[nodiscard]] TestWindow& window() { return m_fixture->window(); }
    [[nodiscard]] const model::RuleTable& rules() { return window().find<ui::RuleModel>().rules(); }
    void check() {
        auto* what = window().panel("clearances").findChild<QComboBox*>("what");
        window().showPanel("clearances");
        what->setCurrentIndex(static_cast<int>(ui::ClearancePanel::What::Rules));
        window().actions()[ActionId::SearchClearances].trigger();
        const ui::RuleModel& model = window().find<ui::RuleModel>();
        QTRY_VERIFY(!model.index(0, ui::RuleModel::Result).data().toString().isEmpty() &&
                    !window().workspace().isWorking());
    }
    /// Where a message of the list is about; null if there is none.
    [[nodiscard]] QString messageAt(const QString& text, Qt::MatchFlags how = Qt::MatchExactly) {
        const ui::MessageModel& messages = window().find<ui::MessageModel>();
        const QModelIndexList found =
            messages.match(messages.index(0, ui::MessageModel::Text), Qt::DisplayRole, text, 1, how);
        return found.isEmpty() ? QString()
                               : found.front().siblingAtColumn(ui::MessageModel::Location).data().toString();
    }
    void reload() {
        const model::Document* before = window().document();
        window().workspace().reload();
        QTRY_VERIFY(window().document() != before && !window().loader().isLoading());
    }

    std::unique_ptr<WindowFixture> m_fixture;
    fs::path m_board;
};

QTEST_MAIN(ProjectRulesTest)
#include "project_rules_test.moc"
