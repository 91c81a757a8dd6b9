// The button of the status line that counts warnings and errors, and opens the list of them.

#include "ui/messages/message_badge.h"

#include <QtTest>

#include "tests/locations.h"
#include "tests/patience.h"
#include "tests/ui/window_fixture.h"

using model::Severity;

class MessageBadgeTest : public QObject {
    Q_OBJECT

private slots:
    void init() { m_fixture = std::make_unique<WindowFixture>(); }
    void cleanup() { m_fixture.reset(); }

    void itCountsWhatTheBoardCameWith() {
        QVERIFY(badge().isHidden());
        QVERIFY(m_fixture->openAndWait(locations::kTestData + QStringLiteral("/odb/everything")));
        const auto warnings = window().document()->diagnostics.count(Severity::Warning);
        QVERIFY(warnings > 1);
        QVERIFY(badge().isVisible());
        QVERIFY2(badge().text().contains(QString("%1 warnings").arg(warnings)), qPrintable(badge().text()));
    }

    /// A badge alone is overlooked, and half a board is no small matter.
    void aBoardThatIsCutOffSaysSoAboveTheViews() {
        const QTemporaryDir folder;
        const QString path = folder.filePath("cut.kicad_pcb");
        QFile whole(locations::kTestData + QStringLiteral("/kicad/small.kicad_pcb"));
        QFile cut(path);
        QVERIFY(whole.open(QIODevice::ReadOnly) && cut.open(QIODevice::WriteOnly));
        cut.write(whole.read(whole.size() * 2 / 3));
        cut.close();
        QVERIFY(m_fixture->openAndWait(path));
        QVERIFY(badge().text().startsWith("1 error"));
        const QWidget& bar = *window().findChild<QWidget*>("messageBar");
        QVERIFY(bar.isVisible());
        const QString text = bar.findChild<QLabel*>()->text();
        QVERIFY2(text.startsWith("Not all of cut.kicad_pcb could be read. The file ends") &&
                     text.contains("(cut.kicad_pcb:"),
                 qPrintable(text));
        QVERIFY(m_fixture->openAndWait(whole.fileName()));
        QVERIFY(bar.isHidden());
    }

    void aClickOpensTheListAndASecondClosesIt() {
        QVERIFY(m_fixture->openAndWait(locations::kTestData + QStringLiteral("/odb/everything")));
        const QDockWidget& panel = *window().findChild<QDockWidget*>("messages");
        QVERIFY(panel.isHidden());
        QTest::mouseClick(&badge(), Qt::LeftButton);
        QTRY_VERIFY(panel.isVisible() && badge().isChecked());
        QTest::mouseClick(&badge(), Qt::LeftButton);
        QTRY_VERIFY(panel.isHidden() && !badge().isChecked());
        QTest::mouseClick(&badge(), Qt::LeftButton);
        window().actions()[ui::ActionId::ShowStatisticsDock].trigger();  // lies over the list
        QTRY_VERIFY(panel.visibleRegion().isEmpty() && !badge().isChecked());
        QTest::mouseClick(&badge(), Qt::LeftButton);
        QTRY_VERIFY(!panel.visibleRegion().isEmpty());
    }

    void errorsStandOut() {
        ui::MessageModel messages;
        QAction panel;
        ui::MessageBadge badge(messages, panel);
        model::Diagnostics found;
        found.report(Severity::Warning, "matrix/matrix", 1, "Row left out");
        messages.setMessages(nullptr, found);
        QCOMPARE(badge.text(), QString("1 warning"));
        QVERIFY(badge.styleSheet().isEmpty());
        found.report(Severity::Error, "matrix/matrix", 2, "No such layer");
        messages.setMessages(nullptr, found);
        QCOMPARE(badge.text(), QString("1 error, 1 warning"));
        const QColor ground = badge.grab().toImage().pixelColor(2, badge.height() / 2);
        QVERIFY(ground.red() > 2 * ground.green());
        messages.setMessages(nullptr, {});
        QCOMPARE(badge.text(), QString("No warnings"));
        QVERIFY(badge.styleSheet().isEmpty());
    }

private:
    TestWindow& window() { return m_fixture->window(); }
    ui::MessageBadge& badge() { return window().find<ui::MessageBadge>(); }

    std::unique_ptr<WindowFixture> m_fixture;
};

QTEST_MAIN(MessageBadgeTest)
#include "message_badge_test.moc"
