#include "ui/canvas/camera_controller.h"

#include <QMouseEvent>
#include <QSignalSpy>
#include <QWheelEvent>
#include <QtTest>

using ui::CameraController;

namespace {

constexpr QSizeF kViewport{800.0, 600.0};
const glm::vec3 kBoxMin{-50.0F, -40.0F, 0.0F};
const glm::vec3 kBoxMax{50.0F, 40.0F, 1.6F};

/// Where a board point is drawn, in logical pixels.
QPointF onScreen(const CameraController& controller, const glm::vec3& point) {
    const auto aspect = static_cast<float>(kViewport.width() / kViewport.height());
    const glm::vec4 clip = controller.camera().projection(aspect) * controller.camera().view() * glm::vec4(point, 1.0F);
    return {(clip.x / clip.w + 1.0) / 2.0 * kViewport.width(), (clip.y / clip.w + 1.0) / 2.0 * kViewport.height()};
}

double distance(QPointF a, QPointF b) {
    return std::hypot(a.x() - b.x(), a.y() - b.y());
}

void send(CameraController& controller, QEvent::Type type, QPointF position, Qt::MouseButton button,
          Qt::KeyboardModifiers modifiers = Qt::NoModifier) {
    const Qt::MouseButtons held = type == QEvent::MouseButtonRelease ? Qt::NoButton : Qt::MouseButtons(button);
    QMouseEvent event(type, position, position, type == QEvent::MouseMove ? Qt::NoButton : button, held, modifiers);
    controller.handle(event);
}

void drag(CameraController& controller, QPointF from, QPointF to, Qt::MouseButton button,
          Qt::KeyboardModifiers modifiers = Qt::NoModifier) {
    send(controller, QEvent::MouseButtonPress, from, button, modifiers);
    send(controller, QEvent::MouseMove, (from + to) / 2.0, button, modifiers);
    send(controller, QEvent::MouseMove, to, button, modifiers);
    send(controller, QEvent::MouseButtonRelease, to, button, modifiers);
}

void wheel(CameraController& controller, QPointF position, int notches,
           Qt::KeyboardModifiers modifiers = Qt::NoModifier) {
    QWheelEvent event(position, position, {}, {0, notches * 120}, Qt::NoButton, modifiers, Qt::NoScrollPhase, false);
    controller.handle(event);
}

/// A point of the top face away from the centre, seen at a distance other than the target's.
const glm::vec3 kCorner{40.0F, 30.0F, 1.6F};

}  // namespace

class CameraControllerTest : public QObject {
    Q_OBJECT

private slots:
    void init() {
        m_controller = std::make_unique<CameraController>();
        m_controller->setViewport(kViewport);
        m_controller->setBox(kBoxMin, kBoxMax);
        m_controller->look(render::NamedView::Iso);
    }

    void wheelKeepsThePointUnderTheCursor_data() {
        QTest::addColumn<bool>("isOrthographic");
        QTest::newRow("perspective") << false;
        QTest::newRow("orthographic") << true;
    }
    void wheelKeepsThePointUnderTheCursor() {
        QFETCH(bool, isOrthographic);
        m_controller->setOrthographic(isOrthographic);
        const QPointF cursor = onScreen(*m_controller, kCorner);
        for (const int notches : {1, 3, -2, 5}) {
            wheel(*m_controller, cursor, notches);
            QVERIFY(distance(onScreen(*m_controller, kCorner), cursor) < 0.5);
        }
    }

    void wheelComesAsNearToTheCornerAsToTheMiddle() {
        wheel(*m_controller, onScreen(*m_controller, kCorner), 40);
        const glm::vec3 eye = m_controller->camera().eye();
        QVERIFY2(glm::length(eye - kCorner) < 1.0F, qPrintable(QString::number(glm::length(eye - kCorner))));
    }

    void theWheelWithShiftOrCtrlPansAsTheHabitsSay() {
        const auto movedBy = [&](Qt::KeyboardModifier modifier) {
            m_controller->fit();
            const QPointF before = onScreen(*m_controller, kCorner);
            const float zoom = m_controller->mmPerPixel();
            wheel(*m_controller, {400, 300}, 1, modifier);
            const QPointF way = onScreen(*m_controller, kCorner) - before;
            return m_controller->mmPerPixel() != zoom ? QStringLiteral("zoom")
                   : std::abs(way.y()) < 1.0          ? QStringLiteral("%1 right").arg(std::lround(way.x()))
                   : std::abs(way.x()) < 1.0          ? QStringLiteral("%1 down").arg(std::lround(way.y()))
                                                      : QStringLiteral("askew");
        };
        m_controller->setPlan();
        QCOMPARE(movedBy(Qt::ShiftModifier), "60 down");
        QCOMPARE(movedBy(Qt::ControlModifier), "60 right");
        QCOMPARE(movedBy(Qt::NoModifier), "zoom");
        m_controller->setHabits({.shiftWheel = ui::WheelMove::Sideways, .ctrlWheel = ui::WheelMove::Zoom});
        QCOMPARE(movedBy(Qt::ShiftModifier), "60 right");
        QCOMPARE(movedBy(Qt::ControlModifier), "zoom");
    }

    void wheelTowardsTheBoardEnlarges() {
        const float before = m_controller->camera().mmPerPixel(600.0F);
        wheel(*m_controller, {400, 300}, 1);
        QVERIFY(m_controller->camera().mmPerPixel(600.0F) < before);
        wheel(*m_controller, {400, 300}, -2);
        QVERIFY(m_controller->camera().mmPerPixel(600.0F) > before);
    }

    void leftDragTurnsTheBoardWithTheCursor() {
        const glm::vec3 nearEdge{-10.0F, -40.0F, 1.6F};  // the side towards the viewer
        const QPointF before = onScreen(*m_controller, nearEdge);
        drag(*m_controller, {400, 300}, {460, 300}, Qt::LeftButton);
        QVERIFY(onScreen(*m_controller, nearEdge).x() > before.x());
        const float height = m_controller->camera().direction().z;
        drag(*m_controller, {400, 300}, {400, 340}, Qt::LeftButton);
        QVERIFY2(m_controller->camera().direction().z < height, "dragging down shows more of the top");
    }

    void panGestures_data() {
        QTest::addColumn<Qt::MouseButton>("button");
        QTest::addColumn<Qt::KeyboardModifier>("modifier");
        QTest::newRow("middle") << Qt::MiddleButton << Qt::NoModifier;
        QTest::newRow("right") << Qt::RightButton << Qt::NoModifier;
        QTest::newRow("shift left") << Qt::LeftButton << Qt::ShiftModifier;
    }
    void panGestures() {
        QFETCH(Qt::MouseButton, button);
        QFETCH(Qt::KeyboardModifier, modifier);
        const glm::vec3 direction = m_controller->camera().direction();
        const QPointF from = onScreen(*m_controller, kCorner);
        const QPointF to = from + QPointF(-120, 75);
        drag(*m_controller, from, to, button, modifier);
        QVERIFY(distance(onScreen(*m_controller, kCorner), to) < 1.0);
        QVERIFY(glm::length(m_controller->camera().direction() - direction) < 1e-6F);
    }

    /// Fractions of pixels, as pens and fine screens tell them, add up.
    void plansArePannedByWholePixelsOfTheScreen_data() {
        QTest::addColumn<double>("ratio");
        QTest::newRow("pixels") << 1.0;
        QTest::newRow("fine ones") << 1.5;
    }
    void plansArePannedByWholePixelsOfTheScreen() {
        QFETCH(double, ratio);
        m_controller->setViewport(kViewport, ratio);
        m_controller->setPlan();
        const QPointF start(300.0, 200.0);
        const QPointF before = onScreen(*m_controller, kCorner);
        send(*m_controller, QEvent::MouseButtonPress, start, Qt::RightButton);
        for (int i = 1; i <= 40; ++i) {
            const QPointF way(1.27 * i, -0.81 * i);
            send(*m_controller, QEvent::MouseMove, start + way, Qt::RightButton);
            const QPointF moved = (onScreen(*m_controller, kCorner) - before) * ratio;
            QVERIFY(std::abs(moved.x() - std::round(moved.x())) < 0.01);
            QVERIFY(std::abs(moved.y() - std::round(moved.y())) < 0.01);
            QVERIFY(i < 4 || distance(moved / ratio, way) < 0.75 / ratio);
        }
    }

    void escGivesUpABox() {
        m_controller->setPlan();
        const QSignalSpy drawn(m_controller.get(), &CameraController::boxDrawn);
        const QSignalSpy finished(m_controller.get(), &CameraController::boxFinished);
        const QSignalSpy givenUp(m_controller.get(), &CameraController::boxGivenUp);
        const auto takesEscape = [this](QEvent::Type type) {
            QKeyEvent event(type, Qt::Key_Escape, Qt::NoModifier);
            event.ignore();
            return m_controller->handle(event);
        };
        QVERIFY(!takesEscape(QEvent::ShortcutOverride) && !takesEscape(QEvent::KeyPress));
        send(*m_controller, QEvent::MouseButtonPress, {200, 175}, Qt::LeftButton);
        send(*m_controller, QEvent::MouseMove, {300, 250}, Qt::LeftButton);
        QCOMPARE(drawn.count(), 1);
        QVERIFY(takesEscape(QEvent::ShortcutOverride) && takesEscape(QEvent::KeyPress));
        QCOMPARE(givenUp.count(), 1);
        send(*m_controller, QEvent::MouseMove, {400, 325}, Qt::LeftButton);
        send(*m_controller, QEvent::MouseButtonRelease, {400, 325}, Qt::LeftButton);
        QCOMPARE(drawn.count(), 1);
        QCOMPARE(finished.count(), 0);
        QVERIFY(!m_controller->isDragging());
        drag(*m_controller, {200, 175}, {400, 325}, Qt::LeftButton);
        QCOMPARE(finished.count(), 1);
    }

    void rightDragZoomsIntoABoxAndOutOfIt() {
        m_controller->setPlan();
        m_controller->setHabits({.rightDragZooms = true});
        QSignalSpy zoomed(m_controller.get(), &CameraController::zoomedToBox);
        QSignalSpy boxes(m_controller.get(), &CameraController::boxFinished);
        const glm::vec3 middle = m_controller->rayAt({300, 250}).origin;
        const float before = m_controller->mmPerPixel();
        drag(*m_controller, {200, 175}, {400, 325}, Qt::RightButton);  // a quarter of 800 x 600
        QVERIFY(std::abs(m_controller->mmPerPixel() / before - 0.25F) < 1e-4F);
        QVERIFY(glm::distance(glm::vec2(m_controller->rayAt({400, 300}).origin), glm::vec2(middle)) < 0.01F);
        drag(*m_controller, {500, 375}, {300, 225}, Qt::RightButton);
        QVERIFY(std::abs(m_controller->mmPerPixel() / before - 1.0F) < 1e-4F);
        QCOMPARE(zoomed.count(), 2);
        QCOMPARE(boxes.count(), 0);
        drag(*m_controller, {200, 175}, {400, 325}, Qt::RightButton, Qt::ShiftModifier);  // pans
        QVERIFY(std::abs(m_controller->mmPerPixel() / before - 1.0F) < 1e-4F);
    }

    void shiftAndRightDragOrbitsWhereThatIsTheHabit() {
        const glm::vec3 direction = m_controller->camera().direction();
        drag(*m_controller, {400, 300}, {460, 300}, Qt::RightButton, Qt::ShiftModifier);
        QVERIFY(glm::length(m_controller->camera().direction() - direction) < 1e-6F);
        m_controller->setHabits({.shiftRightDragOrbits = true});
        drag(*m_controller, {400, 300}, {460, 300}, Qt::RightButton, Qt::ShiftModifier);
        QVERIFY(glm::length(m_controller->camera().direction() - direction) > 0.1F);
    }

    void shortPressIsAClickAndMovesNothing() {
        QSignalSpy clicked(m_controller.get(), &CameraController::clicked);
        const glm::vec3 eye = m_controller->camera().eye();
        drag(*m_controller, {100, 100}, {102, 102}, Qt::LeftButton);
        QCOMPARE(clicked.count(), 1);
        QCOMPARE(clicked[0][0].toPointF(), QPointF(100, 100));
        QVERIFY(glm::length(m_controller->camera().eye() - eye) < 1e-4F);
        drag(*m_controller, {100, 100}, {110, 100}, Qt::LeftButton);
        QCOMPARE(clicked.count(), 1);
    }

    void secondButtonDoesNotDisturbADrag() {
        send(*m_controller, QEvent::MouseButtonPress, {100, 100}, Qt::MiddleButton);
        send(*m_controller, QEvent::MouseButtonPress, {100, 100}, Qt::LeftButton);
        send(*m_controller, QEvent::MouseButtonRelease, {100, 100}, Qt::LeftButton);
        const glm::vec3 direction = m_controller->camera().direction();
        send(*m_controller, QEvent::MouseMove, {200, 160}, Qt::MiddleButton);
        QVERIFY(glm::length(m_controller->camera().direction() - direction) < 1e-6F);
        QVERIFY(glm::length(m_controller->camera().target() - (kBoxMin + kBoxMax) / 2.0F) > 1.0F);
    }

    void boardStaysFittedUntilTheUserMoves() {
        const auto seesCorner = [&] {
            const QPointF p = onScreen(*m_controller, kBoxMax);
            return QRectF({0, 0}, kViewport).contains(p);
        };
        QVERIFY(seesCorner());
        m_controller->setBox(kBoxMin * 4.0F, kBoxMax * 4.0F);
        QVERIFY(QRectF({0, 0}, kViewport).contains(onScreen(*m_controller, kBoxMax * 4.0F)));
        wheel(*m_controller, {400, 300}, 3);
        const glm::vec3 eye = m_controller->camera().eye();
        m_controller->setBox(kBoxMin, kBoxMax);
        m_controller->setViewport({400.0, 300.0});
        QVERIFY(glm::length(m_controller->camera().eye() - eye) < 1e-4F);
        m_controller->setViewport(kViewport);
        m_controller->fit();
        QVERIFY(seesCorner());
    }

    void namedViewsLookWhereTheySay() {
        m_controller->look(render::NamedView::Top);
        QVERIFY(m_controller->camera().direction().z < -0.999F);
        m_controller->look(render::NamedView::Bottom);
        QVERIFY(m_controller->camera().direction().z > 0.999F);
    }

    void linesOfSightBesideOrAlongTheBoardMissIt() {
        QVERIFY(m_controller->boardPointAt(onScreen(*m_controller, kCorner)).has_value());
        QVERIFY(glm::length(*m_controller->boardPointAt(onScreen(*m_controller, kCorner)) - kCorner) < 0.05F);
        QVERIFY(!m_controller->boardPointAt({0, 0}).has_value());
        m_controller->look(render::NamedView::Top);
        drag(*m_controller, {400, 300}, {400, 0}, Qt::LeftButton);  // half a turn of 600 pixels: now edge on
        QVERIFY(!m_controller->boardPointAt({400, 300}).has_value());
        wheel(*m_controller, {400, 300}, 2);
        QVERIFY(std::isfinite(m_controller->camera().eye().x));
    }

    void doubleClicksAreOneClickAlsoWhereWindowsGetBothPresses() {
        QSignalSpy clicked(m_controller.get(), &CameraController::clicked);
        QSignalSpy doubled(m_controller.get(), &CameraController::doubleClicked);
        for (const bool isWindow : {true, false}) {
            clicked.clear();
            doubled.clear();
            send(*m_controller, QEvent::MouseButtonPress, {100, 100}, Qt::LeftButton);
            send(*m_controller, QEvent::MouseButtonRelease, {100, 100}, Qt::LeftButton);
            if (isWindow) {
                send(*m_controller, QEvent::MouseButtonPress, {100, 100}, Qt::LeftButton);
            }
            send(*m_controller, QEvent::MouseButtonDblClick, {100, 100}, Qt::LeftButton);
            send(*m_controller, QEvent::MouseButtonRelease, {100, 100}, Qt::LeftButton);
            QCOMPARE(clicked.count(), 1);
            QCOMPARE(doubled.count(), 1);
        }
    }

    void aClickOfTheRightButtonAsksForAMenuAndADragDoesNot() {
        QSignalSpy menus(m_controller.get(), &CameraController::menuRequested);
        QSignalSpy clicked(m_controller.get(), &CameraController::clicked);
        drag(*m_controller, {100, 100}, {140, 100}, Qt::RightButton);
        QCOMPARE(menus.count(), 0);
        drag(*m_controller, {100, 100}, {101, 100}, Qt::RightButton);
        QCOMPARE(menus.count(), 1);
        QCOMPARE(menus[0][0].toPointF(), QPointF(100, 100));
        QCOMPARE(clicked.count(), 0);
    }

    void aPartThatIsShownFillsFourFifthsOfTheCanvas_data() {
        QTest::addColumn<bool>("isPlan");
        QTest::newRow("2D") << true;
        QTest::newRow("3D") << false;
    }
    void aPartThatIsShownFillsFourFifthsOfTheCanvas() {
        QFETCH(bool, isPlan);
        isPlan ? m_controller->setPlan() : m_controller->look(render::NamedView::Top);
        const glm::vec3 low{-20.0F, -5.0F, 1.6F};
        const glm::vec3 high{10.0F, 5.0F, 1.6F};
        m_controller->show(low, high);
        const QPointF size = onScreen(*m_controller, high) - onScreen(*m_controller, low);
        QVERIFY2(std::abs(size.x() / kViewport.width() - 0.8) < 0.01, qPrintable(QString::number(size.x())));
    }

    void whatIsFittedOrShownStaysClearOfTheMargins() {
        m_controller->setPlan();
        m_controller->setMargins({100.0, 200.0, 0.0, 0.0});
        const QRectF room(100.0, 200.0, 700.0, 400.0);
        QRectF board(onScreen(*m_controller, kBoxMin), onScreen(*m_controller, kBoxMax));
        QVERIFY(room.contains(board.normalized()));
        QVERIFY(distance(board.center(), room.center()) < 0.5);
        m_controller->flip();
        board = QRectF(onScreen(*m_controller, kBoxMin), onScreen(*m_controller, kBoxMax));
        QVERIFY(board.width() < 0 && distance(board.center(), room.center()) < 0.5);
        m_controller->show(kBoxMin / 2.0F, kBoxMax / 2.0F);
        board = QRectF(onScreen(*m_controller, kBoxMin / 2.0F), onScreen(*m_controller, kBoxMax / 2.0F));
        QVERIFY(room.contains(board.normalized()));
        QVERIFY(std::abs(board.normalized().height() / room.height() - 0.8) < 0.01);
    }

    void zoomingBesideTheBoardDoesNotLoseIt_data() {
        QTest::addColumn<bool>("isPlan");
        QTest::newRow("2D") << true;
        QTest::newRow("3D") << false;
    }
    void zoomingBesideTheBoardDoesNotLoseIt() {
        QFETCH(bool, isPlan);
        if (isPlan) {
            m_controller->setPlan();
        }
        for (const QPointF beside : {QPointF(3, 3), QPointF(797, 300), QPointF(400, 597)}) {
            m_controller->fit();
            QVERIFY(!m_controller->boardPointAt(beside));
            for (int i = 0; i < 30; ++i) {
                wheel(*m_controller, beside, 1);
            }
            QVERIFY2(isSeen(), qPrintable(QString("%1 %2").arg(beside.x()).arg(beside.y())));
        }
    }

    /// All that is seen is a corner of the board, in a corner of the canvas, aslant.
    void zoomingFarFromABoardDoesNotLoseIt() {
        for (const double turn : {0.0, 60.0, 200.0, 330.0}) {
            m_controller->fit();
            m_controller->orbit({turn, 150.0});
            for (const QPointF corner : {QPointF(40, 560), QPointF(760, 40), QPointF(40, 40), QPointF(760, 560)}) {
                m_controller->show(kCorner - 5.0F, kCorner + 5.0F);
                const QPointF at = onScreen(*m_controller, glm::vec3(50.0F, 40.0F, 1.6F));
                drag(*m_controller, at, corner, Qt::MiddleButton);
                QVERIFY(isSeen());
                for (int i = 0; i < 40; ++i) {
                    wheel(*m_controller, QPointF(800, 600) - corner, 1);
                }
                QVERIFY2(isSeen(), qPrintable(QString("%1 %2").arg(corner.x()).arg(turn)));
            }
        }
    }

    void zoomingOutEndsWhileTheBoardCanBeSeen() {
        for (int i = 0; i < 100; ++i) {
            wheel(*m_controller, QPointF(3, 3), -1);
        }
        const QPointF across = onScreen(*m_controller, kBoxMax) - onScreen(*m_controller, kBoxMin);
        QVERIFY(std::hypot(across.x(), across.y()) > 10.0);
        QVERIFY(QRectF({}, kViewport).contains(onScreen(*m_controller, kCorner)));
    }

    void arrowsTurnAndWithShiftShiftTheView() {
        const auto press = [&](Qt::KeyboardModifiers modifiers) {
            QKeyEvent event(QEvent::KeyPress, Qt::Key_Right, modifiers);
            return m_controller->handle(event);
        };
        const QPointF before = onScreen(*m_controller, kCorner);
        QVERIFY(press(Qt::ShiftModifier));
        QVERIFY2(onScreen(*m_controller, kCorner).x() < before.x(), "the viewer goes right, the board left");
        const glm::vec3 direction = m_controller->camera().direction();
        QVERIFY(press(Qt::NoModifier));
        QVERIFY(glm::length(m_controller->camera().direction() - direction) > 0.01F);
        QKeyEvent other(QEvent::KeyPress, Qt::Key_A, Qt::NoModifier);
        QVERIFY(!m_controller->handle(other));
    }

private:
    /// A line of sight through the canvas meets the box of the board.
    bool isSeen() const {
        for (int x = 0; x <= 800; x += 10) {
            for (int y = 0; y <= 600; y += 10) {
                const auto [origin, direction] = m_controller->rayAt(QPointF(x, y));
                const glm::vec3 low = (kBoxMin - origin) / direction;
                const glm::vec3 high = (kBoxMax - origin) / direction;
                const glm::vec3 enter = glm::min(low, high);
                const glm::vec3 leave = glm::max(low, high);
                if (std::max({enter.x, enter.y, enter.z}) <= std::min({leave.x, leave.y, leave.z})) {
                    return true;
                }
            }
        }
        return false;
    }

    std::unique_ptr<CameraController> m_controller;
};

QTEST_MAIN(CameraControllerTest)
#include "camera_controller_test.moc"
