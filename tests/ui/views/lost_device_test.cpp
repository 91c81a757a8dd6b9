// What the views do when the graphics device is lost, and what they leave to software devices.
#include <QSignalSpy>
#include <QtTest>
#include <algorithm>

#include "tests/locations.h"
#include "tests/patience.h"
#include "tests/ui/window_fixture.h"
#include "ui/canvas/image_canvas.h"
#include "ui/shell/message_bar.h"
#include "ui/views/board_views.h"

class LostDeviceTest : public QObject {
    Q_OBJECT

private slots:
    void init() {
        m_fixture = std::make_unique<WindowFixture>();
        window().actions()[ui::ActionId::ShowViewCube].trigger();  // it is on the screen and not in pictures
    }
    void cleanup() { QCOMPARE(validationErrorsOnClosing(m_fixture), 0U); }

    void lostDeviceIsRenewedAndTheBoardShownAgain() {
        QVERIFY(m_fixture->openAndWait(locations::kSample));
        const QImage before = m_fixture->picture();
        // Either view may notice first, and the other one then has a device again.
        QSignalSpy lost(&window().views().solid(), &ui::BoardView::deviceLost);
        QSignalSpy lostFlat(&window().views().flat(), &ui::BoardView::deviceLost);
        m_fixture->context().device().markLost();
        window().views().solid().requestFrame();
        QTRY_VERIFY(!lost.isEmpty() || !lostFlat.isEmpty());
        QTRY_VERIFY(!m_fixture->context().device().isLost());
        QVERIFY(window().messageBar().isVisible());
        window().messageBar().hide();  // it takes some of the canvas
        // The canvas was resized and the camera fitted anew, which may round differently: 1 pixel in 10,000.
        QTRY_VERIFY(differingPixels(m_fixture->picture(), before) < before.width() * before.height() / 10000);
        QTRY_VERIFY(differingPixels(m_fixture->shown(), before) < before.width() * 4);
    }

    /// Whose frames take long.
    void softwareDevicesArePresentedToByNoView() {
        if (!m_fixture->context().device().caps().isCpu) {
            QSKIP("needs a software device");
        }
        const auto areShownFromMemory = [this] {
            return std::ranges::all_of(window().views().both(), [](ui::BoardView* view) {
                return qobject_cast<ui::ImageCanvas*>(&view->canvas()) != nullptr;
            });
        };
        QVERIFY(areShownFromMemory());
    }

    void flatViewNoticesALostDeviceThoughItDrawsWithoutIt() {
        QVERIFY(m_fixture->openAndWait(locations::kSample));
        ui::BoardView& flat = window().views().flat();
        QSignalSpy lost(&flat, &ui::BoardView::deviceLost);
        m_fixture->context().device().markLost();
        QSignalSpy drawn(&flat, &ui::BoardView::drawn);  // not as long as the device is lost
        flat.requestFrame();
        QTRY_VERIFY(!lost.isEmpty());
        QTRY_VERIFY(!m_fixture->context().device().isLost());
        QTRY_VERIFY(!drawn.isEmpty());
    }

    /// What needs no device says nothing of one that was started again.
    void aDeviceThatIsLostBeforeItDrewAFrameKeepsFailing() {
        if (!m_fixture->context().device().caps().isCpu) {
            QSKIP("needs a software device: others draw the flat view too");
        }
        QVERIFY(m_fixture->openAndWait(locations::kSample));
        ui::BoardView& flat = window().views().flat();
        window().views().setArrangement(ui::Arrangement::Flat);
        QVERIFY(m_fixture->awaitRest());
        QSignalSpy troubled(&window().views(), &ui::BoardViews::troubled);
        QSignalSpy timed(&flat, &ui::BoardView::timed);
        const auto keepsFailing = [&] {
            const qsizetype before = troubled.count();
            m_fixture->context().device().markLost();
            flat.requestFrame();
            return QTest::qWaitFor([&] { return troubled.count() > before; }, kPatienceMs) &&
                   troubled.last().first().toString().contains("keeps failing");
        };
        QVERIFY(!keepsFailing());
        QCOMPARE(troubled.count(), 1);
        QVERIFY(!m_fixture->context().device().isLost());
        bool isSaid = false;
        for (int i = 0; i < 5 && !isSaid; ++i) {  // where tiles are late the device draws the flat view, too, and works
            timed.clear();
            flat.requestFrame();
            QTRY_VERIFY(!timed.isEmpty());
            isSaid = keepsFailing();
        }
        QVERIFY(isSaid);
        QVERIFY(m_fixture->context().device().isLost());
    }

private:
    TestWindow& window() { return m_fixture->window(); }

    std::unique_ptr<WindowFixture> m_fixture;
};

QTEST_MAIN(LostDeviceTest)
#include "lost_device_test.moc"
