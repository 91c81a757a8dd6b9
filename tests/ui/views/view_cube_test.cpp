// The cube in the corner of the 3D view: what of it lies where, and what clicks and drags on it do.

#include "ui/views/view_cube.h"

#include <QMouseEvent>
#include <QSignalSpy>
#include <QtTest>

#include "tests/locations.h"
#include "tests/patience.h"
#include "tests/ui/window_fixture.h"

using ui::ActionId;
using Part = ui::ViewCube::Part;

class ViewCubeTest : public QObject {
    Q_OBJECT

private slots:
    void initTestCase() {
        m_fixture = std::make_unique<WindowFixture>();
        QVERIFY(m_fixture->openAndWait(locations::kSample));
    }
    void init() {
        window().actions()[ActionId::ShowSolid].trigger();
        window().actions()[ActionId::ViewIso].trigger();
        send(QEvent::MouseMove, {200, 300}, Qt::NoButton);
        QTRY_VERIFY(!cube().place().isEmpty());  // the view has got its size
    }
    void cleanupTestCase() { QCOMPARE(validationErrorsOnClosing(m_fixture), 0U); }

    void everyPartIsFoundWhereItIsSeen() {
        int seen = 0;
        for (const Part& part : parts()) {
            solid().lookFrom(glm::vec3(part));
            const auto found = cube().partAt(cube().positionOf(part));
            QVERIFY(found.has_value());
            QCOMPARE(*found, part);
            seen++;
        }
        QCOMPARE(seen, 26);
        QVERIFY(!cube().partAt(cube().place().topLeft() + QPointF(1, 1)));
        QVERIFY(!cube().partAt({10, 10}));
    }

    void lookingFromAPartTurnsItToTheViewer() {
        for (const Part& part : parts()) {
            solid().lookFrom(glm::vec3(part));
            const glm::vec3 from = -solid().camera().direction();
            QVERIFY(glm::distance(from, glm::normalize(glm::vec3(part))) < 1e-4F);
        }
    }

    void facesLookAsTheNamedViewsDo() {
        window().views().setActive(window().views().solid());
        window().actions()[ActionId::ViewBottom].trigger();
        const glm::mat4 named = solid().camera().view();
        solid().lookFrom({1, 1, 1});
        solid().lookFrom({0, 0, -1});
        QVERIFY(glm::distance(glm::vec3(named[1]), glm::vec3(solid().camera().view()[1])) < 1e-4F);
        QVERIFY(glm::distance(glm::vec3(named[0]), glm::vec3(solid().camera().view()[0])) < 1e-4F);
    }

    void aClickLooksFromThereAndDoesNotReachTheBoard() {
        QSignalSpy clicks(&solid(), &ui::CameraController::clicked);
        const Part front{0, -1, 0};
        click(cube().positionOf(front));
        QVERIFY(glm::distance(solid().camera().direction(), glm::vec3(0, 1, 0)) < 1e-4F);
        click(cube().positionOf({0, -1, 1}));
        QVERIFY(glm::distance(solid().camera().direction(), glm::normalize(glm::vec3(0, 1, -1))) < 1e-4F);
        QCOMPARE(clicks.count(), 0);
        click({200, 300});
        QCOMPARE(clicks.count(), 1);
    }

    void aDragTurnsTheBoard() {
        const glm::vec3 before = solid().camera().direction();
        const QPointF from = cube().place().center();
        send(QEvent::MouseButtonPress, from, Qt::LeftButton);
        send(QEvent::MouseMove, from + QPointF(30, 0), Qt::LeftButton);
        send(QEvent::MouseMove, from + QPointF(60, 200), Qt::LeftButton);  // goes on beside the cube
        send(QEvent::MouseButtonRelease, from + QPointF(60, 200), Qt::LeftButton);
        QVERIFY(glm::distance(solid().camera().direction(), before) > 0.2F);
        const glm::vec3 after = solid().camera().direction();
        send(QEvent::MouseMove, from, Qt::NoButton);
        QCOMPARE(solid().camera().direction(), after);
    }

    void theCursorLightsAPartUpAndNothingOfTheBoard() {
        QSignalSpy hovers(&solid(), &ui::CameraController::hovered);
        const Part top{0, 0, 1};
        const QImage plain = painted();
        send(QEvent::MouseMove, cube().positionOf(top), Qt::NoButton);
        QCOMPARE(cube().hovered(), std::optional(top));
        QCOMPARE(hovers.count(), 0);
        QTRY_VERIFY(differingPixels(plain, painted()) > 100);
        send(QEvent::MouseMove, {200, 300}, Qt::NoButton);
        QVERIFY(!cube().hovered());
        QCOMPARE(hovers.count(), 1);
    }

    void itIsOffWhereTheViewIsSmallAndWhenAskedAndInPictures() {
        QVERIFY(!cube().place().isEmpty());
        const QImage picture = m_fixture->picture();
        m_fixture->key(Qt::Key_K);
        QVERIFY(cube().place().isEmpty());
        QCOMPARE(differingPixels(picture, m_fixture->picture()), 0);
        m_fixture->key(Qt::Key_K);
        QVERIFY(!cube().place().isEmpty());
        solid().setViewport({200, 900});
        QVERIFY(cube().place().isEmpty());
        solid().setViewport(window().views().solid().size());
    }

private:
    TestWindow& window() { return m_fixture->window(); }
    ui::ViewCube& cube() { return window().viewCube(); }
    ui::CameraController& solid() { return window().views().solid().controller(); }

    static std::vector<Part> parts() {
        std::vector<Part> all;
        for (int i = 0; i < 27; ++i) {
            const Part part{i % 3 - 1, i / 3 % 3 - 1, i / 9 - 1};
            if (part != Part(0)) {
                all.push_back(part);
            }
        }
        return all;
    }

    void send(QEvent::Type type, QPointF at, Qt::MouseButton button) {
        const bool isMove = type == QEvent::MouseMove;
        QMouseEvent event(type, at, at, isMove ? Qt::NoButton : button,
                          type == QEvent::MouseButtonRelease ? Qt::NoButton : button, Qt::NoModifier);
        QCoreApplication::sendEvent(&window().views().solid().canvas(), &event);
    }

    void click(QPointF at) {
        QObject& canvas = window().views().solid().canvas();
        if (auto* native = qobject_cast<QWindow*>(&canvas)) {
            QTest::mouseClick(native, Qt::LeftButton, Qt::NoModifier, at.toPoint());
        } else {
            QTest::mouseClick(qobject_cast<QWidget*>(&canvas), Qt::LeftButton, Qt::NoModifier, at.toPoint());
        }
    }

    /// The corner of the canvas as it is on the screen.
    QImage painted() { return !m_fixture->awaitRest() ? QImage() : m_fixture->shown().copy(cube().place().toRect()); }

    std::unique_ptr<WindowFixture> m_fixture;
};

QTEST_MAIN(ViewCubeTest)
#include "view_cube_test.moc"
