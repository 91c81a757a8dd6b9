// Where a logical pixel is more than one of the screen (ctest sets QT_SCALE_FACTOR): nothing is drawn coarser or found
// beside where it is seen.

#include <QPainter>
#include <QtTest>
#include <cmath>

#include "tests/locations.h"
#include "tests/ui/window_fixture.h"
#include "ui/views/view_cube.h"

using ui::ActionId;

class HidpiTest : public QObject {
    Q_OBJECT

private slots:
    void initTestCase() {
        if (qEnvironmentVariableIsEmpty("QT_SCALE_FACTOR")) {
            QSKIP("ctest sets QT_SCALE_FACTOR for this test");
        }
        m_fixture = std::make_unique<WindowFixture>();
        QVERIFY(m_fixture->openAndWait(locations::kSample));
        m_ratio = m_fixture->window().devicePixelRatioF();
        QVERIFY(m_ratio > 1.2);
    }
    void cleanupTestCase() { m_fixture.reset(); }

    void picturesHaveThePixelsOfTheScreen() {
        for (ui::BoardView* view : m_fixture->window().views().both()) {
            const base::Result<QImage> picture = view->grabPicture();
            QVERIFY(picture.ok());
            QVERIFY(std::abs(picture->width() - view->width() * m_ratio) <= 1.0);
            QVERIFY(std::abs(picture->height() - view->height() * m_ratio) <= 1.0);
            QCOMPARE(view->controller().viewport().toSize(), view->size());  // input counts logical pixels
        }
    }

    void overlaysAreSharp() {
        ui::BoardView& flat = m_fixture->window().views().flat();
        const auto isOn = std::make_shared<bool>(true);  // the view keeps the painter
        flat.addPainter([isOn](QPainter& painter) {
            if (*isOn) {
                painter.fillRect(QRect(40, 40, 10, 10), Qt::magenta);
            }
        });
        const base::Result<QImage> picture = flat.grabPicture();
        *isOn = false;
        QVERIFY(picture.ok());
        int painted = 0;
        for (int y = 0; y < picture->height(); ++y) {
            for (int x = 0; x < picture->width(); ++x) {
                painted += picture->pixelColor(x, y) == Qt::magenta ? 1 : 0;
            }
        }
        const double side = 10.0 * m_ratio;  // a whole number at the scales ctest sets; drawn coarser edges would blur
        QVERIFY2(std::abs(painted - side * side) <= 2.0 * side, qPrintable(QString::number(painted)));
    }

    void aClickHitsWhatIsSeenThere() {
        TestWindow& window = m_fixture->window();
        ui::BoardView& flat = window.views().flat();
        const model::Document& board = *window.document();
        int hits = 0;
        for (std::size_t row = 0; row < board.elements.size() && hits < 5; row += 7) {
            const model::ElementId element{row};
            if (board.elements.kind[row] != model::ElementKind::Circle ||
                board.layers[board.elements.layer[row].row()].side != model::LayerSide::Top) {
                continue;
            }
            const model::Box box = board.boxOf(element);
            const base::PointD middle{(double{1} * box.min.x + box.max.x) / 2, (double{1} * box.min.y + box.max.y) / 2};
            const glm::vec3 location = window.probing().position().toModel(middle);
            flat.controller().show(location - glm::vec3(1, 1, 0), location + glm::vec3(1, 1, 0));
            click(flat, *flat.controller().screenOf(location));
            QVERIFY(!window.selection().selected().empty());
            const model::Box found = board.boxOf(window.selection().current()->element);
            QVERIFY(found.min.x <= middle.x && middle.x <= found.max.x);
            QVERIFY(found.min.y <= middle.y && middle.y <= found.max.y);
            ++hits;
        }
        QVERIFY(hits > 0);
    }

    void theCubeIsClickedWhereItIsSeen() {
        TestWindow& window = m_fixture->window();
        window.actions()[ActionId::ShowSolid].trigger();
        window.actions()[ActionId::ViewIso].trigger();
        QTest::qWait(50);
        QVERIFY(!window.viewCube().place().isEmpty());
        click(window.views().solid(), window.viewCube().positionOf({0, 0, 1}));
        QVERIFY(glm::distance(window.views().solid().controller().camera().direction(), glm::vec3(0, 0, -1)) < 1e-4F);
    }

private:
    static void click(ui::BoardView& view, QPointF at) {
        if (auto* native = qobject_cast<QWindow*>(&view.canvas())) {
            QTest::mouseClick(native, Qt::LeftButton, Qt::NoModifier, at.toPoint());
        } else {
            QTest::mouseClick(qobject_cast<QWidget*>(&view.canvas()), Qt::LeftButton, Qt::NoModifier, at.toPoint());
        }
    }

    std::unique_ptr<WindowFixture> m_fixture;
    double m_ratio = 1.0;
};

QTEST_MAIN(HidpiTest)
#include "hidpi_test.moc"
