// What the frame display counts, and that it shows times without drawing forever.

#include "ui/views/frame_display.h"

#include <QSignalSpy>
#include <QtTest>

#include "model/base/progress.h"
#include "tests/locations.h"
#include "tests/patience.h"
#include "tests/ui/window_fixture.h"

using ui::ActionId;

class FrameDisplayTest : public QObject {
    Q_OBJECT

private slots:
    void initTestCase() {
        m_fixture = std::make_unique<WindowFixture>();
        QVERIFY(display().lines().isEmpty());
        QVERIFY(m_fixture->openAndWait(locations::kSample));
    }
    void cleanupTestCase() { QCOMPARE(validationErrorsOnClosing(m_fixture), 0U); }

    void elementsAreCountedInAllCopiesAndWhatIsStoredOnce() {
        base::Progress progress;
        const auto panel =
            ui::loadBoard({.path = std::string(locations::kTestData) + "/odb/panel", .noSession = true}, progress);
        QVERIFY(panel.ok());
        const ui::BoardCounts counts = ui::countsOf(*panel->document, *panel->model);
        const auto tree = model::unfoldCopies(*panel->document);
        QVERIFY(counts.copies > 1);
        std::uint64_t once = 0;
        for (const model::Document* step : tree.steps) {
            once += step->elements.size();
        }
        QVERIFY(counts.elements > once);
        std::uint64_t lets = panel->model->lets.size();
        for (const render::BoardModel& step : panel->model->steps) {
            lets += step.lets.size();
        }
        QVERIFY(lets > 0);
        QCOMPARE(counts.lets, lets);
    }

    void itStandsOnTheCanvasAndNotInPictures() {
        QVERIFY(m_fixture->awaitRest());
        const QImage shown = m_fixture->shown();
        const QImage picture = m_fixture->picture();
        turn();
        QTRY_VERIFY(value("Last frame").contains("ms to record it"));
        QTRY_VERIFY(differingPixels(shown, m_fixture->shown()) > 1000);
        QCOMPARE(differingPixels(picture, m_fixture->picture()), 0);
        QVERIFY(value("Memory").contains("MiB"));
        turn();
        QTRY_COMPARE(differingPixels(shown, m_fixture->shown()), 0);
    }

    void aViewAtRestIsNotDrawn() {
        turn();
        m_fixture->key(Qt::Key_Plus);
        QVERIFY(m_fixture->awaitRest());
        QSignalSpy drawn(&window().views().solid(), &ui::BoardView::drawn);
        QTest::qWait(1500);
        QCOMPARE(drawn.count(), 0);
        turn();
    }

private:
    TestWindow& window() { return m_fixture->window(); }
    ui::FrameDisplay& display() { return window().frameDisplay(); }

    void turn() {
        m_fixture->key(Qt::Key_K, Qt::ControlModifier);
        m_fixture->key(Qt::Key_F);
    }
    QString value(const QString& name) {
        for (const auto& [title, text] : display().lines()) {
            if (title == name) {
                return text;
            }
        }
        return {};
    }

    std::unique_ptr<WindowFixture> m_fixture;
};

QTEST_MAIN(FrameDisplayTest)
#include "frame_display_test.moc"
