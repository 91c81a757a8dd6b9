// The search box finds commands by their name, their menu and what they do; keys alone suffice.
#include <QLineEdit>
#include <QListWidget>
#include <QtTest>

#include "tests/locations.h"
#include "tests/ui/window_fixture.h"
#include "ui/search/search_box.h"

class SearchCommandsTest : public QObject {
    Q_OBJECT

private slots:
    void init() {
        m_fixture = std::make_unique<WindowFixture>();
        QVERIFY(m_fixture->openAndWait(locations::kSample));
    }
    void cleanup() { QCOMPARE(validationErrorsOnClosing(m_fixture), 0U); }

    void commandsAreFoundAndDone() {
        m_fixture->key(Qt::Key_P, Qt::ControlModifier | Qt::ShiftModifier);
        QVERIFY(box().isVisible());
        const int all = box().list().count();
        QVERIFY(all > 40);
        QTest::keyClicks(&box().line(), "ortho");
        QCOMPARE(box().list().count(), 1);
        QTest::keyClick(&box().line(), Qt::Key_Return);
        QVERIFY(!box().isVisible());
        QVERIFY(window().actions()[ui::ActionId::Orthographic].isChecked());
    }

    void commandsAreFoundByWhatTheyDoAfterThoseOfThatName() {
        m_fixture->key(Qt::Key_P, Qt::ControlModifier | Qt::ShiftModifier);
        QTest::keyClicks(&box().line(), "drill table");
        QCOMPARE(box().list().count(), 1);
        QVERIFY(box().list().item(0)->text().startsWith("Statistics "));
        box().line().setText(">net");
        QVERIFY(box().list().item(0)->text().contains("net", Qt::CaseInsensitive));
        box().line().setText("drill table");
        QVERIFY2(!box().list().item(0)->text().startsWith("Statistics "), "among all there is, names alone count");
        QTest::keyClick(&box().line(), Qt::Key_Escape);
    }

    void commandsAreFoundByTheirMenuAndByWordsInAnyOrder() {
        QCOMPARE(rows(">theme").mid(0, 3), (QStringList{"System", "Dark", "Light"}));
        QCOMPARE(rows(">keys kicad"), QStringList{"KiCad"});
        QCOMPARE(rows(">net highlight").front(), "Highlight net");
        QCOMPARE(rows(">no such command"), QStringList{"Nothing is called no such command"});
        QTest::keyClick(&box().line(), Qt::Key_Escape);
    }

    /// As other programs call what they do, among all there is and among commands alone.
    void everydayWordsFindCommands_data() {
        QTest::addColumn<QStringList>("commands");
        QTest::newRow("measure") << QStringList{
            "Point to point", "Clearance (edge to edge)", "Angle of three points", "Angle of two lines",
            "Radius",         "Net path length"};
        QTest::newRow("distance") << QStringList{"Point to point", "Clearance (edge to edge)"};
        QTest::newRow("drc") << QStringList{"Check rules"};
        QTest::newRow("rule") << QStringList{"Check rules"};
        QTest::newRow("Mirror") << QStringList{"Flip board"};
        QTest::newRow("print") << QStringList{"Export…"};
        QTest::newRow("step") << QStringList{"Export…"};
        QTest::newRow("placement") << QStringList{"Parts"};
        QTest::newRow("annular") << QStringList{"Check rules", "Edit rules…"};
        QTest::newRow("compare") << QStringList{"Netlist check"};
        QTest::newRow("unconnected") << QStringList{"Netlist check"};
        QTest::newRow("test point") << QStringList{"Parts"};
        QTest::newRow("board size") << QStringList{"Statistics"};
        QTest::newRow("dimensions") << QStringList{"Statistics"};
        QTest::newRow("hole") << QStringList{"Statistics"};
        QTest::newRow("drill") << QStringList{"Statistics"};
    }
    void everydayWordsFindCommands() {
        QFETCH(const QStringList, commands);
        const QString word = QTest::currentDataTag();
        for (const QString& before : {QString(), QStringLiteral(">")}) {
            const QStringList found = rows(before + word);
            for (const QString& command : commands) {
                QVERIFY2(found.contains(command), qPrintable(found.join(", ")));
            }
        }
        QCOMPARE(rows('>' + word).front(), commands.front());
        QVERIFY(rows('>' + word + ' ' + commands.front().section(' ', 0, 0)).contains(commands.front()));
        QTest::keyClick(&box().line(), Qt::Key_Escape);
    }

    void anEverydayWordIsTypedAndDone() {
        m_fixture->key(Qt::Key_P, Qt::ControlModifier | Qt::ShiftModifier);
        QTest::keyClicks(&box().line(), "distance");
        QTest::keyClick(&box().line(), Qt::Key_Return);
        QVERIFY(window().actions()[ui::ActionId::MeasurePoints].isChecked());
    }

    void theBillOfMaterialsIsFound() {
        for (const char* words : {"bom", "bill of materials"}) {
            m_fixture->key(Qt::Key_P, Qt::ControlModifier | Qt::ShiftModifier);
            QTest::keyClicks(&box().line(), words);
            QCOMPARE(box().list().count(), 1);
            QVERIFY(box().list().item(0)->text().startsWith("Parts "));
            QTest::keyClick(&box().line(), Qt::Key_Escape);
        }
    }

private:
    TestWindow& window() { return m_fixture->window(); }
    ui::SearchBox& box() { return window().searchBox(); }
    /// What is listed for a text.
    QStringList rows(const QString& text) {
        box().open(text);
        QStringList all;
        for (int row = 0; row < box().list().count(); ++row) {
            all += box().list().item(row)->text().section("    ", 0, 0);
        }
        return all;
    }

    std::unique_ptr<WindowFixture> m_fixture;
};

QTEST_MAIN(SearchCommandsTest)
#include "search_commands_test.moc"
