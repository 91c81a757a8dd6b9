#include "ui/clearance/clearance_feature.h"

#include <QAbstractItemModelTester>
#include <QComboBox>
#include <QDialogButtonBox>
#include <QFile>
#include <QFileDialog>
#include <QLabel>
#include <QLineEdit>
#include <QPointer>
#include <QPushButton>
#include <QRegularExpression>
#include <QScrollBar>
#include <QSlider>
#include <QStatusBar>
#include <QToolButton>
#include <QWheelEvent>
#include <QtTest>

#include "model/design_rules/design_rule_check.h"
#include "tests/locations.h"
#include "tests/patience.h"
#include "tests/ui/clearance/clearance_fixture.h"
#include "tests/ui/window_fixture.h"
#include "ui/clearance/rule_dialog.h"
#include "ui/common/table_view.h"
#include "ui/layers/layers_panel.h"
#include "ui/shell/message_bar.h"

using ui::ActionId;
using ui::ClearanceModel;
using ui::ClearancePanel;

/// From the keys to the narrow place on the screen, on the sample board.
class ClearanceFeatureTest : public QObject, protected ClearanceFixture {
    Q_OBJECT

private slots:
    void initTestCase() { open(); }
    void init() {
        while (window().selection().clearStep()) {
        }
        box("what").setCurrentIndex(static_cast<int>(ClearancePanel::What::Smallest));
        box("where").setCurrentIndex(static_cast<int>(ClearancePanel::Where::Board));
        if (window().actions()[ActionId::Lens].isChecked()) {
            window().actions()[ActionId::Lens].trigger();
        }
    }
    void cleanupTestCase() { QCOMPARE(validationErrorsOnClosing(m_fixture), 0U); }

    void modelsKeepTheirPromises() {
        const QAbstractItemModelTester locations(&window().find<ui::ClearanceModel>());
        const QAbstractItemModelTester rules(&window().find<ui::RuleModel>());
        measure();
        QVERIFY(window().find<ui::ClearanceModel>().rowCount() > 3);
    }

    void lengthsInListsHaveAllTheirDigitsAndBothUnitsInTheirTips() {
        measure();
        const ClearanceModel& locations = window().find<ui::ClearanceModel>();
        static const QRegularExpression inMm(R"(^-?\d+\.\d{4} mm$)");
        for (const int column : {ClearanceModel::Spacing, ClearanceModel::X}) {
            const QModelIndex at = locations.index(0, column);
            QVERIFY2(inMm.match(at.data().toString()).hasMatch(), qPrintable(at.data().toString()));
            QVERIFY(at.data(Qt::ToolTipRole).toString().contains(" mil"));
        }
    }

    void theButtonOfTheSearchSaysWhatItDoes() {
        auto* search = panel().findChild<QToolButton*>("search");
        for (const int what : {1, 0}) {
            box("what").setCurrentIndex(what);
            const bool isOfRules = what == static_cast<int>(ClearancePanel::What::Rules);
            const QString name = isOfRules ? "Check rules" : "Find clearances";
            QCOMPARE(search->text(), name);
            QTest::mouseClick(search, Qt::LeftButton);
            QTRY_VERIFY(!window().workspace().isWorking());
            QCOMPARE(window().find<ui::ClearanceModel>().isOfRules(), isOfRules);
            QCOMPARE(search->text(), name);
        }
    }

    void aClickOnARuleShowsItsFirstLocation() {
        box("what").setCurrentIndex(static_cast<int>(ClearancePanel::What::Rules));
        measure();
        const ClearanceModel& locations = window().find<ui::ClearanceModel>();
        const std::size_t last = locations.location(locations.rowCount() - 1).found.rule;
        QVERIFY(locations.rowCount() > 1);
        auto* rules = panel().findChildren<ui::TableView*>().last();
        for (ui::TableView* table : panel().findChildren<ui::TableView*>()) {
            rules = table != &panel().table() ? table : rules;
        }
        const QModelIndex row = rules->model()->index(static_cast<int>(last), ui::RuleModel::Result);
        rules->scrollTo(row);
        QTest::mouseClick(rules->viewport(), Qt::LeftButton, {}, rules->visualRect(row).center());
        QCOMPARE(panel().currentRow(), locations.firstOf(last));
    }

    void aSelectedRuleListsItsOwnLocationsAlone() {
        box("what").setCurrentIndex(static_cast<int>(ClearancePanel::What::Rules));
        ui::RuleModel& model = window().find<ui::RuleModel>();
        const model::RuleTable before = model.rules();
        QVERIFY(model.setData(model.index(0, ui::RuleModel::Least), "5 mm", Qt::EditRole));
        measure();
        const ClearanceModel& locations = window().find<ui::ClearanceModel>();
        const std::size_t last = locations.location(locations.rowCount() - 1).found.rule;
        QVERIFY(last != locations.location(0).found.rule);
        const QAbstractItemModel& listed = *panel().table().model();
        auto& rules = *panel().findChild<ui::TableView*>("rules");
        rules.clearSelection();
        const auto click = [&] {
            const QModelIndex row = model.index(static_cast<int>(last), ui::RuleModel::Result);
            rules.scrollTo(row);
            QTest::mouseClick(rules.viewport(), Qt::LeftButton, {}, rules.visualRect(row).center());
        };
        click();
        QVERIFY(listed.rowCount() > 0 && listed.rowCount() < locations.rowCount());
        QCOMPARE(panel().currentRow(), locations.firstOf(last));
        QVERIFY2(label("summary").startsWith("FAIL: "), qPrintable(label("summary")));
        QVERIFY2(label("summary").contains("; shown: "), qPrintable(label("summary")));
        click();
        QCOMPARE(listed.rowCount(), locations.rowCount());
        QVERIFY2(label("summary").startsWith("FAIL: "), qPrintable(label("summary")));
        QVERIFY2(!label("summary").contains("shown"), qPrintable(label("summary")));
        model.replaceRules(before);
    }

    void theLocationThatIsShownIsSeenInTheList() {
        box("what").setCurrentIndex(static_cast<int>(ClearancePanel::What::Rules));
        ui::RuleModel& model = window().find<ui::RuleModel>();
        const model::RuleTable before = model.rules();
        for (const int row : {0, 1}) {  // copper to copper, and to holes
            QVERIFY(model.setData(model.index(row, ui::RuleModel::Least), "8 mm", Qt::EditRole));
        }
        measure();
        auto& rules = *panel().findChild<ui::TableView*>("rules");
        rules.clearSelection();
        panel().setCurrentRow(1);
        const QModelIndex second = model.index(1, ui::RuleModel::Result);
        rules.scrollTo(second);
        QTest::mouseClick(rules.viewport(), Qt::LeftButton, {}, rules.visualRect(second).center());
        ui::TableView& table = panel().table();
        QCOMPARE(panel().currentRow(), window().find<ui::ClearanceModel>().firstOf(1));
        QTRY_VERIFY(table.verticalScrollBar()->maximum() > 0);
        QVERIFY(table.viewport()->rect().contains(table.visualRect(table.currentIndex()).center()));
        rules.clearSelection();
        model.replaceRules(before);
    }

    /// Rows of another question would read as the answer to this one.
    void eachQuestionListsItsOwnAnswer() {
        QVERIFY(m_fixture->openAndWait(m_fixture->copyOfSample()));
        measure();
        const ClearanceModel& locations = window().find<ui::ClearanceModel>();
        const int smallest = locations.rowCount();
        QVERIFY(smallest > 0 && !locations.isOfRules());
        QVERIFY2(label("summary").startsWith("Smallest spacing "), qPrintable(label("summary")));
        box("what").setCurrentIndex(static_cast<int>(ClearancePanel::What::Rules));
        QCOMPARE(locations.rowCount(), 0);
        QCOMPARE(label("summary"), "No search yet");
        measure();
        QVERIFY(locations.isOfRules());
        box("what").setCurrentIndex(static_cast<int>(ClearancePanel::What::Smallest));
        QCOMPARE(locations.rowCount(), smallest);
        box("what").setCurrentIndex(static_cast<int>(ClearancePanel::What::Rules));
        QVERIFY(locations.isOfRules());
    }

    void aToleranceThatIsNoneKeepsTheDialogOpen() {
        window().actions()[ui::ActionId::EditRules].trigger();
        QPointer<ui::RuleDialog> dialog = window().findChild<ui::RuleDialog*>();
        auto& line = *dialog->findChild<QLineEdit*>("tolerance");
        line.selectAll();
        QTest::keyClicks(&line, "xyz");
        QTest::mouseClick(dialog->findChild<QDialogButtonBox*>()->button(QDialogButtonBox::Ok), Qt::LeftButton);
        QVERIFY(dialog && dialog->isVisible());
        QCOMPARE(line.text(), "xyz");
        const auto labels = dialog->findChildren<QLabel*>();
        QVERIFY(std::ranges::any_of(labels, [](QLabel* each) { return each->text().contains("xyz"); }));
        line.setText("1,5 um");
        dialog->accept();
        QVERIFY(!dialog || !dialog->isVisible());
        QCOMPARE(window().find<ui::RuleModel>().rules().tolerance, model::Nm{1'500});
        window().actions()[ActionId::Undo].trigger();
        QTRY_VERIFY(!dialog);
        window().activateWindow();
        QVERIFY(QTest::qWaitForWindowActive(&window()));
    }

    /// The wheel over a box that one scrolls past.
    void theWheelChangesNothingWithoutTheKeyboard() {
        const auto turn = [](QWidget& over) {
            const QPointF at = over.rect().center();
            QWheelEvent wheel(at, over.mapToGlobal(at), {}, {0, -120}, Qt::NoButton, {}, Qt::NoScrollPhase, false);
            QCoreApplication::sendEvent(&over, &wheel);
        };
        QComboBox& where = box("where");
        QVERIFY(where.focusPolicy() != Qt::WheelFocus);
        const int reach = lensSlider().value();
        panel().table().setFocus();
        turn(where);
        turn(lensSlider());
        QCOMPARE(where.currentIndex(), 0);
        QCOMPARE(lensSlider().value(), reach);
        where.setFocus();
        turn(where);
        QCOMPARE(where.currentIndex(), 1);
        where.setCurrentIndex(0);
    }

    void theNarrowestIsShownInBothViewsAndWalkedThrough() {
        measure();
        const ClearanceModel& locations = window().find<ui::ClearanceModel>();
        double last = 0.0;
        for (int row = 0; row < locations.rowCount(); ++row) {
            const double gap = locations.data(locations.index(row, ClearanceModel::Spacing), Qt::EditRole).toDouble();
            QVERIFY(gap >= last);
            last = gap;
        }
        const QImage before = window().views().flat().grabPicture()->copy();
        m_fixture->key(Qt::Key_F8);
        const model::RuleFinding& first = locations.location(0).found;
        const std::vector<model::BoardElement> sides{{0, std::min(first.a, first.b)}, {0, std::max(first.a, first.b)}};
        QCOMPARE(window().selection().selected(), sides);
        QVERIFY(differingPixels(before, *window().views().flat().grabPicture()) > 100);
        for (ui::BoardView* view : window().views().both()) {
            const auto at = view->controller().screenOf(
                window().probing().position().toModel(first.spacing.from, heightOf(first.layer)));
            QVERIFY(at && QRectF(QPointF(), view->controller().viewport()).contains(*at));
        }
        m_fixture->key(Qt::Key_F8);
        QCOMPARE(panel().table().currentIndex().row(), 1);
        m_fixture->key(Qt::Key_F8, Qt::ShiftModifier);
        m_fixture->key(Qt::Key_F8, Qt::ShiftModifier);
        QCOMPARE(panel().table().currentIndex().row(), locations.rowCount() - 1);  // round the corner
    }

    /// On a hidden layer, and below all others: as bright as if it were alone, until something else is selected.
    void aCoveredLayerIsSeenAsLongAsItsGapIsShown() {
        const model::Document& board = *window().document();
        model::LayerId bottom;
        for (std::size_t row = 0; row < board.layers.size(); ++row) {
            bottom = board.layers[row].isCopper() ? model::LayerId{row} : bottom;
        }
        window().layersPanel().select(bottom);
        ask(ClearancePanel::Where::Layer);
        const QModelIndex check = window().layers().index(int(bottom.row()), ui::LayerModel::Visible);
        QVERIFY(window().layers().setData(check, Qt::Unchecked, Qt::CheckStateRole));
        m_fixture->key(Qt::Key_F8);
        for (ui::BoardView* view : window().views().both()) {
            const auto styles = view->styles();
            QVERIFY(styles[bottom.row()].isVisible);
            QCOMPARE(styles[bottom.row()].opacity, 1.0F);
            for (std::size_t row = 0; row < styles.size(); ++row) {
                const model::RuleFinding& found = window().find<ui::ClearanceModel>().location(0).found;
                const bool isOfSpacing = row == bottom.row() || board.elements.layer[found.a.row()].row() == row ||
                                         board.elements.layer[found.b.row()].row() == row;
                QVERIFY(isOfSpacing || styles[row].opacity < 0.2F);
            }
        }
        const QImage highlighted = window().views().flat().grabPicture()->copy();
        QCOMPARE(check.data(Qt::CheckStateRole).value<Qt::CheckState>(), Qt::Unchecked);  // untouched
        m_fixture->key(Qt::Key_Escape);
        QVERIFY(window().selection().selected().empty());
        for (ui::BoardView* view : window().views().both()) {
            QVERIFY(!view->styles()[bottom.row()].isVisible);
        }
        QVERIFY(differingPixels(highlighted, *window().views().flat().grabPicture()) > 100);
        QVERIFY(window().layers().setData(check, Qt::Checked, Qt::CheckStateRole));
    }

    void questionsAreNarrowedToLayerViewAndNets() {
        measure();
        const ClearanceModel& locations = window().find<ui::ClearanceModel>();
        const ClearanceModel::Location first = locations.location(0);
        const int all = locations.rowCount();
        const auto nets = [&] {
            const model::Document& board = *window().document();
            return std::vector<model::BoardNet>{{0, board.elements.net[first.found.a.row()]},
                                                {0, board.elements.net[first.found.b.row()]}};
        }();

        window().layersPanel().select(first.found.layer);
        ask(ClearancePanel::Where::Layer);
        QVERIFY(locations.rowCount() > 0 && locations.rowCount() < all);
        for (int row = 0; row < locations.rowCount(); ++row) {
            QCOMPARE(locations.location(row).found.layer, first.found.layer);
        }
        window().selection().setNets(nets);
        ask(ClearancePanel::Where::Nets);
        QVERIFY(locations.rowCount() >= 1);
        QCOMPARE(locations.location(0).found.spacing.distance, first.found.spacing.distance);

        window().probing().showPosition(first.found.spacing.from, first.found.layer);
        ask(ClearancePanel::Where::View);
        QVERIFY(locations.rowCount() > 0 && locations.rowCount() < all);
        QCOMPARE(locations.location(0).found.spacing.distance, first.found.spacing.distance);
    }

    void aQuestionThatCannotBeAskedIsTold() {
        window().selection().setNets({});
        box("where").setCurrentIndex(static_cast<int>(ClearancePanel::Where::Nets));
        window().messageBar().hide();
        window().actions()[ActionId::SearchClearances].trigger();
        QVERIFY(window().messageBar().isVisible());
        QVERIFY(!window().workspace().isWorking());
        window().messageBar().hide();
    }

    void rulesAreEditedCheckedAndKeptInAFile() {
        box("what").setCurrentIndex(static_cast<int>(ClearancePanel::What::Rules));
        ui::RuleModel& rules = window().find<ui::RuleModel>();
        const QModelIndex least = rules.index(0, ui::RuleModel::Least);
        QVERIFY(rules.setData(least, "5 mm", Qt::EditRole));
        QVERIFY(!rules.setData(least, "-3", Qt::EditRole));
        QVERIFY(!rules.setData(least, "apple", Qt::EditRole));
        measure();
        QVERIFY(rules.index(0, ui::RuleModel::Result).data().toString().startsWith("FAIL"));
        const ClearanceModel& locations = window().find<ui::ClearanceModel>();
        QVERIFY(locations.index(0, ClearanceModel::Rule).data().toString().startsWith("copper-copper"));

        const QString path = m_fixture->folder() + "/rules.json";
        emit panel().rulesSaved();
        window().nameFile(path);
        const model::RuleTable saved = rules.rules();
        QVERIFY(rules.setData(least, "1 um", Qt::EditRole));
        QVERIFY(clearances().openRules(path));
        QVERIFY(rules.rules() == saved);
        QVERIFY(!clearances().openRules(locations::kSample));
        QVERIFY(rules.rules() == saved);
        emit panel().rulesSaved();
        window().nameFile("/nowhere/rules.json");
        QVERIFY2(window().error().startsWith("/nowhere/rules.json cannot be written"), qPrintable(window().error()));
    }

    void rulesThatADialogLeavesAsTheyAreKeepTheirResults() {
        auto& rules = window().find<ui::RuleModel>();
        rules.setResults(std::vector<ui::RuleResult>(rules.rules().rules.size()));
        const auto result = [&] { return rules.index(0, ui::RuleModel::Result).data().toString(); };
        const QString before = result();
        QVERIFY2(!before.isEmpty() && before != "not checked", qPrintable(before));
        window().actions()[ui::ActionId::EditRules].trigger();
        window().findChild<ui::RuleDialog*>()->accept();
        QCOMPARE(result(), before);
        QTRY_VERIFY(window().findChild<ui::RuleDialog*>() == nullptr);
        rules.setResults({});
        window().activateWindow();
        QVERIFY(QTest::qWaitForWindowActive(&window()));
    }

    void rulesAreEditedInADialogByKeysAndUndone() {
        const model::RuleTable before = window().find<ui::RuleModel>().rules();
        window().actions()[ui::ActionId::EditRules].trigger();
        auto* dialog = window().findChild<ui::RuleDialog*>();
        QVERIFY(dialog != nullptr && dialog->isVisible());
        const QList<ui::TableView*> tables = dialog->findChildren<ui::TableView*>();  // rules, classes
        const QAbstractItemModel& classes = *tables[1]->model();
        press(*dialog, "Add &class");
        QCOMPARE(classes.rowCount(), 1);
        type(*tables[1], classes.index(0, ui::NetClassModel::Name), "gnd");
        type(*tables[1], classes.index(0, ui::NetClassModel::Nets), "GND*");
        QTRY_COMPARE(dialog->rules().rules().classes, (std::vector<model::NetClass>{{"gnd", {"GND*"}}}));
        press(*dialog, "&Add rule");
        const int row = dialog->rules().rowCount() - 1;
        QCOMPARE(row, static_cast<int>(before.rules.size()));
        QVERIFY(dialog->rules().setData(dialog->rules().index(row, ui::RuleModel::Second), "gnd", Qt::EditRole));
        type(*tables[0], dialog->rules().index(row, ui::RuleModel::Least), "7 mil");
        QTRY_COMPARE(dialog->rules().rules().rules.back().least, model::Nm{177'800});
        tables[0]->setCurrentIndex(dialog->rules().index(0, ui::RuleModel::On));
        QTest::keyClick(tables[0], Qt::Key_Space);
        QVERIFY(!dialog->rules().rules().rules[0].isOn);
        QVERIFY(window().find<ui::RuleModel>().rules() == before);  // nothing counts yet
        const model::RuleTable after = dialog->rules().rules();
        dialog->accept();
        QVERIFY(window().find<ui::RuleModel>().rules() == after);
        window().actions()[ActionId::Undo].trigger();
        QVERIFY(window().find<ui::RuleModel>().rules() == before);
        window().actions()[ActionId::Redo].trigger();
        QVERIFY(window().find<ui::RuleModel>().rules() == after);
        window().actions()[ActionId::Undo].trigger();

        QTRY_VERIFY(window().findChild<ui::RuleDialog*>() == nullptr);
        window().actions()[ui::ActionId::EditRules].trigger();
        window().findChild<ui::RuleDialog*>()->rules().addRule();
        window().findChild<ui::RuleDialog*>()->reject();
        QVERIFY(window().find<ui::RuleModel>().rules() == before);
        QTRY_VERIFY(window().findChild<ui::RuleDialog*>() == nullptr);
        window().activateWindow();
        QVERIFY(QTest::qWaitForWindowActive(&window()));
    }

    void whatWasFoundIsExportedAsTheCommandLineWritesIt() {
        QVERIFY(m_fixture->openAndWait(m_fixture->copyOfSample()));
        const QString path = m_fixture->folder() + "/found";
        QVERIFY(!clearances().report(path + ".csv"));  // nothing was searched for
        box("what").setCurrentIndex(static_cast<int>(ClearancePanel::What::Rules));
        measure();
        base::Progress progress;
        const model::Document& board = *window().document();
        const model::RuleTable& table = window().find<ui::RuleModel>().rules();
        const model::StepRules expected[] = {{&board, *model::checkRules(board, table, progress)}};
        QCOMPARE(exported(path + ".csv"), model::ruleReport(table, expected, model::ReportFormat::Csv, 1'000'000));
        QCOMPARE(exported(path + ".txt"), model::ruleReport(table, expected, model::ReportFormat::Text, 1'000'000));
        box("what").setCurrentIndex(static_cast<int>(ClearancePanel::What::Smallest));
        measure();
        model::ClearanceRequest question;
        question.count = 500;
        const model::StepClearances found[] = {{&board, *model::smallestClearances(board, question, progress)}};
        QCOMPARE(exported(path + ".JSON"), model::clearanceReport(found, model::ReportFormat::Json));
        QVERIFY(!clearances().report(path + ".html"));  // of rules alone
        QVERIFY(!clearances().report(path + ".pdf"));
    }

    void theLensFollowsSliderAndSelection() {
        measure();
        const model::RuleFinding found = window().find<ui::ClearanceModel>().location(0).found;
        panel().setCurrentRow(0);  // in the middle of the views
        window().selection().select({{0, found.a}});
        m_fixture->key(Qt::Key_L);
        QVERIFY(window().find<ui::Lens>().isOn());
        QTRY_VERIFY(!window().find<ui::Lens>().isSearching());
        lensSlider().setFocus();
        std::size_t last = 0;
        bool hasOther = false;
        for (int value = lensSlider().minimum(); value <= lensSlider().maximum(); value += 20) {
            lensSlider().setValue(value);
            const auto highlighted = window().find<ui::Lens>().highlighted();
            QVERIFY(highlighted.size() >= last);
            QTRY_COMPARE(window().selection().nearby().size(), highlighted.size());
            for (const model::Nearby& near : highlighted) {
                QVERIFY(near.spacing.distance <= panel().lensReach());
                hasOther = hasOther || near.element == found.b;
            }
            last = highlighted.size();
        }
        QVERIFY(hasOther);
        const QImage withLens = *window().views().flat().grabPicture();
        const ui::Lens& lens = window().find<ui::Lens>();
        QVERIFY(!lens.numbers().empty());
        QVERIFY(lens.numbers().size() <= ui::LensPainter::kMostNumbers);
        for (const ui::LensPainter::Number& number : lens.numbers()) {
            QVERIFY(number.line < lens.highlighted().size());
        }
        m_fixture->key(Qt::Key_L);
        QVERIFY(window().selection().nearby().empty());
        QVERIFY(differingPixels(withLens, *window().views().flat().grabPicture()) > 10);
    }

    void aReloadForgetsWhatWasFound() {
        measure();
        QVERIFY(m_fixture->openAndWait(m_fixture->copyOfSample()));
        QCOMPARE(window().find<ui::ClearanceModel>().rowCount(), 0);
        QCOMPARE(label("summary"), "No search yet");
        m_fixture->key(Qt::Key_F8);
        QVERIFY2(said().startsWith("There is no list to step through"), qPrintable(said()));
        window().actions()[ActionId::ExportClearances].trigger();
        QVERIFY2(said().startsWith("There is nothing to export"), qPrintable(said()));
        QVERIFY(window().findChild<QFileDialog*>() == nullptr);
    }

    void aReloadWhileMeasuringEndsTheSearch() {
        window().actions()[ActionId::SearchClearances].trigger();
        QVERIFY(m_fixture->openAndWait(m_fixture->copyOfSample()));
        QTest::qWait(100);
        QVERIFY(!window().workspace().isWorking());
        QCOMPARE(window().find<ui::ClearanceModel>().rowCount(), 0);
    }

    void aBoardWithCopperButNoNetsIsTold() {
        QVERIFY(m_fixture->openAndWait(QString::fromStdString(m_fixture->copyOfJob("drills").string())));
        measure();
        QCOMPARE(window().find<ui::ClearanceModel>().rowCount(), 0);
        QVERIFY2(label("notes").contains("has copper but no nets"), qPrintable(label("notes")));
        box("what").setCurrentIndex(static_cast<int>(ClearancePanel::What::Rules));
        measure();
        const ui::RuleModel& rules = window().find<ui::RuleModel>();
        QCOMPARE(rules.index(0, ui::RuleModel::Result).data().toString(), "incomplete, see below");
        QVERIFY2(label("notes").contains("the board has no nets"), qPrintable(label("notes")));
        QVERIFY(m_fixture->openAndWait(m_fixture->copyOfSample()));
        QVERIFY(label("notes").isEmpty());
    }

    void ruleLimitAndResultAreSeenBesideEachOtherInANarrowPanel() {
        box("what").setCurrentIndex(static_cast<int>(ClearancePanel::What::Rules));
        measure();
        ui::TableView* rules = nullptr;
        for (ui::TableView* table : panel().findChildren<ui::TableView*>()) {
            rules = table != &panel().table() ? table : rules;
        }
        auto& dock = *qobject_cast<QDockWidget*>(panel().parentWidget());
        const QByteArray arrangement = window().saveState();
        dock.setFloating(true);
        for (const int width : {560, 700, 1000}) {
            dock.resize(width, 500);
            QTRY_VERIFY(std::abs(panel().width() - width) < 20);
            QTRY_VERIFY(rules->viewport()->width() > 200);
            const auto left = [&](int column) { return rules->columnViewportPosition(column); };
            QVERIFY(left(ui::RuleModel::Title) < left(ui::RuleModel::Least));
            QVERIFY(left(ui::RuleModel::Least) < left(ui::RuleModel::Result));
            QCOMPARE(left(ui::RuleModel::Least), left(ui::RuleModel::Title) + rules->columnWidth(ui::RuleModel::Title));
            const int verdict = rules->fontMetrics().horizontalAdvance("FAIL: 12");
            QVERIFY2(left(ui::RuleModel::Result) + verdict < rules->viewport()->width(),
                     qPrintable(QString::number(width)));
        }
        QVERIFY(window().restoreState(arrangement));
        box("what").setCurrentIndex(static_cast<int>(ClearancePanel::What::Smallest));
    }

private:
    [[nodiscard]] ui::ClearanceFeature& clearances() { return window().clearances(); }
    QSlider& lensSlider() { return *panel().findChild<QSlider*>("lensReach"); }

    double heightOf(model::LayerId layer) { return window().document()->layer(layer).z; }

    static void press(const QDialog& dialog, const char* text) {
        for (QPushButton* button : dialog.findChildren<QPushButton*>()) {
            if (button->text() == QLatin1String(text)) {
                QTest::keyClick(button, Qt::Key_Space);
                return;
            }
        }
        QFAIL(text);
    }
    static void type(ui::TableView& table, const QModelIndex& at, const char* text) {
        table.setCurrentIndex(at);
        table.edit(at);
        auto* line = table.findChild<QLineEdit*>();
        QVERIFY(line != nullptr);
        line->setText(text);
        QTest::keyClick(line, Qt::Key_Return);
        QTRY_VERIFY(table.findChild<QLineEdit*>() == nullptr);
    }
    QString said() { return window().statusBar()->currentMessage(); }
    std::string exported(const QString& path) {
        window().save(ActionId::ExportClearances, path);
        QFile file(path);
        return file.open(QIODevice::ReadOnly) ? file.readAll().toStdString() : std::string();
    }
    void ask(ClearancePanel::Where where) {
        box("where").setCurrentIndex(static_cast<int>(where));
        measure();
    }
};

QTEST_MAIN(ClearanceFeatureTest)
#include "clearance_feature_test.moc"
