#include "ui/shell/message_bar.h"

#include <QtTest>

#include "tests/locations.h"
#include "tests/ui/window_fixture.h"

/// Errors are shown, and what takes them away.
class MessageBarTest : public QObject {
    Q_OBJECT

private slots:
    void init() { m_fixture = std::make_unique<WindowFixture>(); }
    void cleanup() { QCOMPARE(validationErrorsOnClosing(m_fixture), 0U); }

    void errorsThatComeTogetherAreAllShown() {
        for (const char* text : {"one", "two", "one"}) {
            window().workspace().reportError(text);
        }
        QCOMPARE(window().error(), QString("one\ntwo"));
        window().messageBar().hide();
        window().workspace().reportError("three");
        QCOMPARE(window().error(), QString("three"));
        QTest::qWait(ui::MessageBar::kTogetherMs + 1);
        window().workspace().reportError("four");
        QCOMPARE(window().error(), QString("four"));
    }

    void escapeClosesTheErrorBeforeItClearsTheSelection() {
        QVERIFY(!m_fixture->openAndWait("/no/such/board.tgz"));
        QVERIFY(window().messageBar().isVisible());
        m_fixture->key(Qt::Key_Escape);
        QVERIFY2(!window().messageBar().isVisible(), "also without a board");
        QVERIFY(m_fixture->openAndWait(locations::kSample));
        window().selection().select({{0, model::ElementId{0}}});
        QVERIFY(!m_fixture->openAndWait("/no/such/board.tgz"));
        m_fixture->key(Qt::Key_Escape);
        QVERIFY(!window().messageBar().isVisible());
        QCOMPARE(window().selection().selected().size(), std::size_t{1});
        m_fixture->key(Qt::Key_Escape);
        QVERIFY(window().selection().selected().empty());
    }

    void nextSuccessTakesTheErrorAway() {
        QVERIFY(!m_fixture->openAndWait("/no/such/board.tgz"));
        QVERIFY(window().document() == nullptr);
        QVERIFY(window().messageBar().isVisible());
        QVERIFY(m_fixture->openAndWait(locations::kSample));
        QVERIFY(!window().messageBar().isVisible());
    }

private:
    TestWindow& window() { return m_fixture->window(); }

    std::unique_ptr<WindowFixture> m_fixture;
};

QTEST_MAIN(MessageBarTest)
#include "message_bar_test.moc"
