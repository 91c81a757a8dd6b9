#include "ui/shell/guide_window.h"

#include <QLineEdit>
#include <QPushButton>
#include <QTextBlock>
#include <QTextBrowser>
#include <QToolButton>
#include <QtTest>

#include "tests/patience.h"
#include "tests/ui/window_fixture.h"

using ui::ActionId;

class GuideWindowTest : public QObject {
    Q_OBJECT

private slots:
    void init() { m_fixture = std::make_unique<WindowFixture>(); }
    void cleanup() { QCOMPARE(validationErrorsOnClosing(m_fixture), 0U); }

    void f1OpensItAndAClickFollowsALink() {
        pressF1();
        QVERIFY(guide() != nullptr && guide()->isVisible() && !guide()->isModal());
        QVERIFY(QTest::qWaitForWindowActive(guide()));
        QVERIFY(page().toPlainText().contains("Opening a board"));
        click("opening.md");
        QTRY_COMPARE(page().source().fileName(), "opening.md");
        QVERIFY(page().toPlainText().contains("ODB++"));
        QVERIFY2(!firstPicture().isNull(), "pictures are found beside the page");
        QTest::mouseClick(buttonNamed("&Back"), Qt::LeftButton);
        QCOMPARE(page().source().fileName(), "README.md");
        QTest::mouseClick(buttonNamed("&Forward"), Qt::LeftButton);
        QCOMPARE(page().source().fileName(), "opening.md");
        QTest::mouseClick(buttonNamed("&Contents"), Qt::LeftButton);
        QCOMPARE(page().source().fileName(), "README.md");
        QTest::keyClick(guide(), Qt::Key_Escape);
        QVERIFY(!guide()->isVisible());
        pressF1();
        QVERIFY(guide()->isVisible());
        QCOMPARE(window().findChildren<ui::GuideWindow*>().size(), 1);
    }

    void theStartPageOffersIt() {
        QPushButton* start = nullptr;
        for (auto* button : window().findChildren<QPushButton*>()) {
            start = button->text() == window().actions()[ActionId::ShowGuide].text() ? button : start;
        }
        QVERIFY(start != nullptr && start->isVisible());
        QTest::mouseClick(start, Qt::LeftButton);
        QVERIFY(guide() != nullptr && guide()->isVisible());
    }

    void wordsAreFoundOnAllPages() {
        pressF1();
        QVERIFY(guide() != nullptr);
        QTRY_VERIFY((guide()->activateWindow(), guide()->isActiveWindow()));
        auto* words = guide()->findChild<QLineEdit*>();
        QTest::keyClick(guide(), Qt::Key_F, Qt::ControlModifier);
        QTRY_VERIFY(words->hasFocus());
        QTest::keyClicks(words, "creepage");
        QTest::keyClick(words, Qt::Key_Return);
        QVERIFY(guide()->isVisible());
        QCOMPARE(page().source().fileName(), "clearances.md");
        QCOMPARE(page().textCursor().selectedText().toLower(), "creepage");
        QVERIFY(!guide()->find("no page says this"));
        QVERIFY(guide()->find("exit code"));
        QCOMPARE(page().source().fileName(), "command-line.md");
    }

    void aGuideThatIsNotInstalledIsSaidSo() {
        const ui::GuideWindow lost(m_fixture->folder() + "/nowhere", &window());
        const auto* text = lost.findChild<QTextBrowser*>();
        QVERIFY(text->toPlainText().contains("not installed"));
        QVERIFY(text->toPlainText().contains("nowhere"));
    }

private:
    TestWindow& window() { return m_fixture->window(); }
    void pressF1() {
        // Asked for once more when it is active, it would come to the front again after the guide.
        if (!window().isActiveWindow()) {
            window().activateWindow();
        }
        QVERIFY(QTest::qWaitForWindowActive(&window()));
        QTest::keyClick(&window(), Qt::Key_F1);
    }
    ui::GuideWindow* guide() { return window().findChild<ui::GuideWindow*>(); }
    QTextBrowser& page() { return *guide()->findChild<QTextBrowser*>(); }

    QToolButton* buttonNamed(const QString& text) {
        for (auto* button : guide()->findChildren<QToolButton*>()) {
            if (button->text() == text) {
                return button;
            }
        }
        qFatal("no button %s", qPrintable(text));
    }

    /// Clicks into the first link that leads there.
    void click(const QString& target) {
        for (QTextBlock block = page().document()->begin(); block.isValid(); block = block.next()) {
            for (auto part = block.begin(); !part.atEnd(); ++part) {
                if (part.fragment().charFormat().anchorHref() == target) {
                    QTextCursor cursor(page().document());
                    cursor.setPosition(part.fragment().position() + 1);
                    page().setTextCursor(cursor);
                    page().ensureCursorVisible();
                    QTest::mouseClick(page().viewport(), Qt::LeftButton, {}, page().cursorRect(cursor).center());
                    return;
                }
            }
        }
        qFatal("no link to %s", qPrintable(target));
    }

    QImage firstPicture() {
        for (QTextBlock block = page().document()->begin(); block.isValid(); block = block.next()) {
            for (auto part = block.begin(); !part.atEnd(); ++part) {
                const QTextImageFormat format = part.fragment().charFormat().toImageFormat();
                if (format.isValid()) {
                    const QVariant bytes = page().loadResource(QTextDocument::ImageResource, QUrl(format.name()));
                    return QImage::fromData(bytes.toByteArray());
                }
            }
        }
        return {};
    }

    std::unique_ptr<WindowFixture> m_fixture;
};

QTEST_MAIN(GuideWindowTest)
#include "guide_window_test.moc"
