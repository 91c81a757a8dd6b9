// What a view shows that does not wait for its device.

#include "ui/canvas/image_canvas.h"

#include <QtTest>

#include "tests/locations.h"
#include "tests/ui/window_fixture.h"

namespace {

constexpr int kTries = 20;
constexpr QSize kSize(800, 600);
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

    /// What that needs has no room in memory for tiles.
    void whatTilesShowedStaysWhereTheNextFrameIsForTheDevice() {
        QTRY_VERIFY(m_fixture->window().views().scene() != nullptr);
        ui::Picture picture = ofFlatView();
        const std::vector<render::LayerStyle> all = picture.styles;
        const auto shown = std::ranges::find(picture.styles, true, &render::LayerStyle::isVisible);
        QVERIFY(shown != picture.styles.end());
        std::for_each(shown + 1, picture.styles.end(), [](render::LayerStyle& style) { style.isVisible = false; });
        ui::CameraController controller;
        controller.setPlan();
        controller.setViewport(kSize);
        controller.setPose(m_fixture->window().views().flat().controller().camera().pose());
        const std::shared_ptr<const render::BoardModel> model = m_fixture->window().workspace().board()->model;
        const auto draw = [&] { return ui::drawFlat(picture, controller.camera(), kSize, 0.0); };
        picture.flat = std::make_shared<render::FlatPicture>(model);
        QCOMPARE(draw(), render::FlatPicture::Quality::Exact);
        picture.flat = std::make_shared<render::FlatPicture>(model, picture.flat->bytes());
        QCOMPARE(draw(), render::FlatPicture::Quality::Exact);

        ui::ImageCanvas canvas(m_fixture->context(), controller, picture);
        canvas.resize(kSize);
        const QImage before = canvas.grab().toImage().convertToFormat(QImage::Format_RGB32);
        picture.styles = all;
        QCOMPARE(draw(), render::FlatPicture::Quality::None);
        canvas.update();
        QVERIFY(inkOf(canvas.grab().toImage().convertToFormat(QImage::Format_RGB32)) >= inkOf(before));
    }

private:
    [[nodiscard]] ui::BoardView& solid() { return m_fixture->window().views().solid(); }
    [[nodiscard]] ui::Picture ofFlatView() {
        ui::Picture picture;
        picture.scene = m_fixture->window().views().scene();
        picture.styles = m_fixture->window().views().flat().styles();
        picture.settings.is2d = true;
        picture.isBoardSame = [] { return true; };
        picture.preparePlane = [](QSize) {};
        picture.paintOver = [](QPainter&) {};
        return picture;
    }
    [[nodiscard]] QImage shownAtOnce() {
        return qobject_cast<QWidget*>(&solid().canvas())->grab().toImage().convertToFormat(QImage::Format_RGB32);
    }

    std::unique_ptr<WindowFixture> m_fixture;
};

QTEST_MAIN(ImageCanvasTest)
#include "image_canvas_test.moc"
