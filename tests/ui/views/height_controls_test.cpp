// Sliders of the tool bar for how heights are drawn in 3D, and the mark on the view that says so.

#include "ui/views/height_controls.h"

#include <QSlider>
#include <QtTest>

#include "tests/locations.h"
#include "tests/patience.h"
#include "tests/ui/window_fixture.h"
#include "ui/theme/theme.h"

using ui::ActionId;

class HeightControlsTest : public QObject {
    Q_OBJECT

private slots:
    void init() {
        m_fixture = std::make_unique<WindowFixture>();
        QVERIFY(m_fixture->openAndWait(locations::kTestData + QStringLiteral("/odb/everything")));
    }
    void cleanup() { m_fixture.reset(); }

    void theSpreadIsDrawnMarkedAndReset() {
        const QImage before = m_fixture->picture();
        slider("spread").setFocus();
        QTest::keyClick(&slider("spread"), Qt::Key_End);
        QCOMPARE(views().exploded(), 3.0F);
        QVERIFY(window().actions()[ActionId::Explode].isChecked());
        QCOMPARE(controls().text(), QString("Explode 3.0×"));
        QVERIFY(differingPixels(before, m_fixture->picture()) > 1000);
        QTest::mouseDClick(&slider("spread"), Qt::LeftButton);
        QCOMPARE(views().exploded(), 0.0F);
        QVERIFY(!window().actions()[ActionId::Explode].isChecked());
        QVERIFY(controls().text().isEmpty());
    }

    void theCommandMovesTheSlider() {
        m_fixture->key(Qt::Key_E);
        QVERIFY(slider("spread").value() > 0);
        QTRY_COMPARE(views().exploded(), 1.0F);
        m_fixture->key(Qt::Key_E);
        QCOMPARE(slider("spread").value(), 0);
        QTRY_COMPARE(views().exploded(), 0.0F);
    }

    void scalesMultiplyAndAreMarked() {
        slider("heightScale").setValue(5);
        QCOMPARE(controls().text(), QString("Height ×5"));
        QVERIFY(views().zScale() == (render::ZScale{5.0F, 5.0F}));
        m_fixture->key(Qt::Key_C);
        QCOMPARE(controls().text(), QString("Copper ×50 · Dielectric ×5"));
        QTest::mouseDClick(&slider("heightScale"), Qt::LeftButton);
        QCOMPARE(controls().text(), QString("Copper ×10 · Dielectric ×1"));
        m_fixture->key(Qt::Key_C);
        QVERIFY(controls().text().isEmpty());
    }

    void theGrooveIsSeenOnADarkGround() {
        ui::applyTheme(ui::Theme::Dark);
        QSlider own(Qt::Horizontal);
        own.resize(slider("spread").size());
        const QImage drawn = own.grab().toImage();
        const int ground = qGray(QGuiApplication::palette().color(QPalette::Window).rgb());
        int brightest = 0;
        for (int y = 0; y < drawn.height(); ++y) {
            brightest = std::max(brightest, qGray(drawn.pixel(3 * drawn.width() / 4, y)));  // the handle is at the left
        }
        ui::applyTheme(ui::Theme::System);
        QVERIFY2(brightest > ground + 50, qPrintable(QString::number(brightest)));
    }

    void whatIsSelectedStaysInSight() {
        const model::Document& document = *window().document();
        ui::CameraController& camera = views().solid().controller();
        std::size_t row = 0;
        while (!document.layer(document.elements.layer[row]).isCopper()) {
            ++row;
        }
        const model::ElementId element{row};
        const std::size_t layer = document.elements.layer[row].row();
        window().selection().select({{0, element}});
        window().workspace().showElements({{0, element}});
        const auto place = [&] {
            const model::PointD middle = base::toDouble(document.boxOf(element).middle());
            const glm::vec3 at = window().probing().position().toModel(middle);
            return camera.screenOf({at.x, at.y, views().solid().drawnHeights()[layer].z1});
        };
        const auto before = place();
        slider("spread").setValue(slider("spread").maximum());
        const auto after = place();
        QVERIFY(before && after);
        QVERIFY2((*after - *before).manhattanLength() < 2.0, "it stays where it is on the canvas");
        slider("heightScale").setValue(10);
        QVERIFY((*place() - *before).manhattanLength() < 2.0);
    }

    void facesOfTheBoardAreScaledToo() {
        const model::Document& document = *window().document();
        slider("heightScale").setValue(5);
        const std::vector<model::PickLayer> layers = window().probing().layersOf(views().solid());
        slider("heightScale").setValue(1);
        double low = 1e12;
        double high = -1e12;
        for (std::size_t row = 0; row < layers.size(); ++row) {
            low = document.layers[row].isBoardCopper() ? std::min(low, layers[row].bottom) : low;
            high = document.layers[row].isBoardCopper() ? std::max(high, layers[row].top) : high;
        }
        QVERIFY2(std::abs(layers.front().faces - low - high) < 10.0, qPrintable(QString::number(low + high)));
    }

    void theMarkIsOnTheView() {
        const QImage plain = m_fixture->picture();
        slider("heightScale").setValue(2);
        slider("heightScale").setValue(1);
        // The board is fitted again, which may round differently.
        QVERIFY(differingPixels(plain, m_fixture->picture()) < plain.width() * plain.height() / 10000);
        slider("heightScale").setValue(2);
        window().actions()[ActionId::HideAllLayers].trigger();  // nothing else is seen
        const QImage marked = m_fixture->picture();
        int ink = 0;
        for (int x = 0; x < marked.width() / 2; ++x) {
            for (int y = 0; y < 40; ++y) {
                ink += marked.pixel(x, y) != marked.pixel(marked.width() - 1, marked.height() - 1) ? 1 : 0;
            }
        }
        QVERIFY(ink > 200);
    }

    void anotherBoardIsShownAsItIs() {
        slider("heightScale").setValue(4);
        m_fixture->key(Qt::Key_V);
        slider("spread").setValue(40);
        window().actions()[ActionId::Reload].trigger();
        QTRY_VERIFY(!window().loader().isLoading());
        QCOMPARE(slider("heightScale").value(), 4);  // the same board
        QCOMPARE(slider("spread").value(), 40);
        QVERIFY(m_fixture->openAndWait(locations::kTestData + QStringLiteral("/odb/rigid_flex")));
        QVERIFY(controls().text().isEmpty());
        QCOMPARE(slider("heightScale").value(), 1);
        QCOMPARE(slider("spread").value(), 0);
        QVERIFY(!window().actions()[ActionId::Explode].isChecked());
        QVERIFY(!window().actions()[ActionId::ExaggerateDielectricHeight].isChecked());
    }

    void anotherBoardOfTheSameArchiveIsShownAsItIs() {
        slider("heightScale").setValue(4);
        ui::LoadedBoard next = *window().workspace().board();
        emit window().loader().loaded(next);
        QCOMPARE(slider("heightScale").value(), 4);
        next.request.member = "other.kicad_pcb";
        emit window().loader().loaded(next);
        QCOMPARE(slider("heightScale").value(), 1);
        QVERIFY(controls().text().isEmpty());
    }

private:
    TestWindow& window() { return m_fixture->window(); }
    ui::BoardViews& views() { return window().views(); }
    const ui::HeightControls& controls() { return window().find<ui::HeightControls>(); }
    QSlider& slider(const char* name) { return *window().findChild<QSlider*>(name); }

    std::unique_ptr<WindowFixture> m_fixture;
};

QTEST_MAIN(HeightControlsTest)
#include "height_controls_test.moc"
