// What a view shows that does not wait for its device.

#include "ui/canvas/image_canvas.h"

#include <QtTest>

#include "tests/locations.h"
#include "tests/ui/window_fixture.h"

namespace {

constexpr int kTries = 20;
constexpr int kRestMs = 700;  // until a view at rest has asked for all that it prepares

}  // namespace

class ImageCanvasTest : public QObject {
    Q_OBJECT

private slots:
    void init() {
        m_fixture = std::make_unique<WindowFixture>();
        m_fixture->window().actions()[ui::ActionId::ShowViewCube].trigger();  // it is no part of pictures
        QVERIFY(m_fixture->openAndWait(locations::kSample));
        if (qobject_cast<ui::ImageCanvas*>(&solid().canvas()) == nullptr) {
            QSKIP("the device presents to the window");
        }
    }
    void cleanup() { QCOMPARE(validationErrorsOnClosing(m_fixture), 0U); }

    void aViewThatMovesShowsAllOfTheBoard() {
        const render::CameraPose far = solid().controller().camera().pose();
        const double whole = inkOf(m_fixture->picture());
        QVERIFY(whole > 0.1);
        double seen = 0.0;
        for (int i = 0; i < kTries && seen < 0.9 * whole; ++i) {
            solid().controller().zoomAtCentre(6.0F);
            QTest::qWait(kRestMs);
            solid().controller().setPose(far);
            seen = inkOf(shownAtOnce());  // before the device can have drawn it
        }
        QVERIFY2(seen >= 0.9 * whole, qPrintable(QStringLiteral("%1 of %2").arg(seen).arg(whole)));
    }

private:
    [[nodiscard]] ui::BoardView& solid() { return m_fixture->window().views().solid(); }
    [[nodiscard]] QImage shownAtOnce() {
        return qobject_cast<QWidget*>(&solid().canvas())->grab().toImage().convertToFormat(QImage::Format_RGB32);
    }

    std::unique_ptr<WindowFixture> m_fixture;
};

QTEST_MAIN(ImageCanvasTest)
#include "image_canvas_test.moc"
