#include "ui/views/board_views.h"

#include <QMouseEvent>
#include <QSignalSpy>
#include <QtTest>

#include "tests/locations.h"
#include "tests/patience.h"
#include "tests/ui/window_fixture.h"
#include "ui/layers/layers_panel.h"
#include "ui/views/plan_painter.h"

using ui::ActionId;
using ui::Arrangement;
using ui::BoardView;

/// Two views of one board: each with its own camera, both with the same layers.
class BoardViewsTest : public QObject {
    Q_OBJECT

private slots:
    void initTestCase() {
        m_fixture = std::make_unique<WindowFixture>();
        QVERIFY(m_fixture->openAndWait(locations::kSample));
    }
    void init() {
        window().actions()[ActionId::ShowSideBySide].trigger();
        window().actions()[ActionId::RestoreLayers].trigger();
        views().setActive(views().flat());
        window().actions()[ActionId::ViewTop].trigger();
        window().actions()[ActionId::Fit].trigger();
        views().setActive(views().solid());
    }
    void cleanupTestCase() { QCOMPARE(validationErrorsOnClosing(m_fixture), 0U); }

    void arrangementKeysShowOneOrBoth() {
        QVERIFY(views().flat().isVisible() && views().solid().isVisible());
        QVERIFY(views().flat().x() < views().solid().x());
        m_fixture->key(Qt::Key_5);
        QVERIFY(views().flat().y() < views().solid().y());
        QCOMPARE(m_fixture->settings().choice<ui::Arrangement>(), Arrangement::Stacked);
        m_fixture->key(Qt::Key_3);
        QVERIFY(!views().flat().isVisible() && views().solid().isVisible());
        m_fixture->key(Qt::Key_2);
        QVERIFY(views().flat().isVisible() && !views().solid().isVisible());
        QCOMPARE(&views().active(), &views().flat());
    }

    void aCommandAboutAHiddenViewShowsIt() {
        const auto& actions = window().actions();
        for (const ActionId about3D : {ActionId::ViewIso, ActionId::Explode, ActionId::SectionPlane}) {
            actions[ActionId::ShowFlat].trigger();
            actions[about3D].trigger();
            QVERIFY(views().flat().isVisible() && views().solid().isVisible());
            QVERIFY(actions[ActionId::ShowSideBySide].isChecked());
        }
        actions[ActionId::Explode].trigger();
        views().setExplode(0.0F);  // at once
        actions[ActionId::SectionPlane].trigger();
        actions[ActionId::ShowSolid].trigger();
        m_fixture->key(Qt::Key_S, Qt::ShiftModifier);
        QVERIFY(views().flat().isVisible() && views().solid().isVisible());
        QVERIFY(actions[ActionId::DrawSection].isChecked());
        m_fixture->key(Qt::Key_Escape);
        actions[ActionId::ShowSolid].trigger();
        actions[ActionId::Fit].trigger();
        QVERIFY2(!views().flat().isVisible(), "this is about either");
    }

    void aHiddenViewStaysSoWhereNothingIsDoneInIt() {
        const auto& actions = window().actions();
        actions[ActionId::ShowFlat].trigger();
        for (const ActionId id : {ActionId::RotateSectionPlane, ActionId::MoveSectionPlaneOn,
                                  ActionId::MoveSectionPlaneBack, ActionId::OpenAlongSection}) {
            actions[id].trigger();
            QVERIFY2(!views().solid().isVisible(), qPrintable(actions[id].text()));
        }
        actions[ActionId::Explode].trigger();
        actions[ActionId::ShowFlat].trigger();
        actions[ActionId::Explode].trigger();
        views().setExplode(0.0F);  // at once
        QVERIFY2(!views().solid().isVisible(), "it was switched off");
        actions[ActionId::DrawSection].trigger();
        actions[ActionId::ShowSolid].trigger();
        actions[ActionId::MeasurePoints].trigger();
        QVERIFY(!actions[ActionId::DrawSection].isChecked());
        QVERIFY(!views().flat().isVisible());
        actions[ActionId::MeasurePoints].trigger();
    }

    void theSectionPlaneIsShownWhereItIsMoved() {
        const auto& actions = window().actions();
        const model::Box box = window().document()->board;
        window().sections().cutAlong({base::toDouble(box.min), base::toDouble(box.max)});
        for (const ActionId id : {ActionId::OpenAlongSection, ActionId::RotateSectionPlane,
                                  ActionId::MoveSectionPlaneOn, ActionId::MoveSectionPlaneBack}) {
            actions[ActionId::ShowFlat].trigger();
            actions[id].trigger();
            QVERIFY2(views().solid().isVisible(), qPrintable(actions[id].text()));
        }
        window().sections().cutAlong({});
        actions[ActionId::SectionPlane].trigger();
        QVERIFY(!actions[ActionId::SectionPlane].isChecked());
    }

    void commandsGoToTheViewInUse() {
        const float solidScale = solid().mmPerPixel();
        const float flatScale = flat().mmPerPixel();
        click(views().flat(), {60, 60});
        QCOMPARE(&views().active(), &views().flat());
        window().actions()[ActionId::ZoomIn].trigger();
        QVERIFY(flat().mmPerPixel() < flatScale * 0.9F);
        QCOMPARE(solid().mmPerPixel(), solidScale);
        key(views().solid(), Qt::Key_Plus);
        QCOMPARE(&views().active(), &views().solid());
        QVERIFY(solid().mmPerPixel() < solidScale * 0.99F);
    }

    void aPlanKeepsItsPartOfTheBoardOnTheOtherSide() {
        views().setActive(views().flat());
        const float fitted = flat().mmPerPixel();
        flat().zoomAtCentre(5.0F);
        const float near = flat().mmPerPixel();
        const glm::vec3 target = flat().camera().pose().target;
        window().actions()[ActionId::ViewBottom].trigger();
        QVERIFY(flat().camera().direction().z > 0.0F);
        QCOMPARE(flat().mmPerPixel(), near);
        QVERIFY(glm::distance(flat().camera().pose().target, target) < 1e-3F);
        window().actions()[ActionId::ViewBottom].trigger();
        QVERIFY(std::abs(flat().mmPerPixel() / fitted - 1.0F) < 0.01F);
        flat().zoomAtCentre(5.0F);
        window().actions()[ActionId::ViewTop].trigger();
        QVERIFY(flat().camera().direction().z < 0.0F);
        QVERIFY(flat().mmPerPixel() < fitted / 2.0F);
        views().setActive(views().solid());
        solid().zoomAtCentre(5.0F);
        window().actions()[ActionId::ViewBottom].trigger();
        const float whole = solid().mmPerPixel();
        window().actions()[ActionId::Fit].trigger();
        QVERIFY(std::abs(solid().mmPerPixel() / whole - 1.0F) < 0.01F);
    }

    void aViewThatThePointerCrossesGetsNoCommands() {
        window().activateWindow();
        QVERIFY(QTest::qWaitForWindowActive(&window()));
        views().solid().takeKeyboard();
        QTRY_VERIFY(views().solid().hasKeyboard());
        click(views().solid(), {60, 60});
        const float scale = flat().mmPerPixel();
        const float solidScale = solid().mmPerPixel();
        moveOver(views().flat());
        QCOMPARE(&views().active(), &views().solid());
        leave(views().flat());
        window().actions()[ActionId::ZoomIn].trigger();
        QCOMPARE(flat().mmPerPixel(), scale);
        QVERIFY(solid().mmPerPixel() < solidScale * 0.9F);
        QTest::qWait(50);  // the desktop may give the keyboard a moment after it was asked for
        QTRY_VERIFY(views().solid().hasKeyboard());
        moveOver(views().flat());
        QTRY_VERIFY(views().flat().hasKeyboard());
        leave(views().flat());
        QTRY_VERIFY(views().solid().hasKeyboard());
    }

    void keysActOnTheViewUnderThePointer() {
        moveOver(views().flat());
        const float scale = flat().mmPerPixel();
        const float solidScale = solid().mmPerPixel();
        key(views().solid(), Qt::Key_Plus);  // the keyboard is still there
        QCOMPARE(&views().active(), &views().flat());
        QVERIFY(flat().mmPerPixel() < scale * 0.99F);
        QCOMPARE(solid().mmPerPixel(), solidScale);
        leave(views().flat());
        QCOMPARE(&views().active(), &views().flat());
        key(views().solid(), Qt::Key_Plus);
        QCOMPARE(&views().active(), &views().solid());
        QVERIFY(solid().mmPerPixel() < solidScale * 0.99F);
    }

    void aFittedBoardLiesClearOfTheRulers() {
        flat().fit();
        constexpr double kRuler = 18.0;
        const model::Box box = window().document()->board;
        for (const base::Point corner : {box.min, box.max}) {
            const QPointF at = *views().flat().screenOf(base::toDouble(corner));
            QVERIFY2(at.x() > kRuler && at.y() > kRuler, qPrintable(QString("%1 %2").arg(at.x()).arg(at.y())));
        }
    }

    void numbersOfRulersAreNotCut() {
        using Ruler = ui::PlanPainter::Ruler;
        const auto& plan = window().find<ui::PlanPainter>();
        QFont font;
        font.setPixelSize(10);
        const QFontMetricsF letters(font);
        int shown = 0;
        int leftOut = 0;
        for (int i = 0; i < 40; ++i) {
            drag(views().flat(), Qt::RightButton, {200.0, 200.0}, {203.0, 203.0});
            for (const Ruler ruler : {Ruler::Upper, Ruler::Left}) {
                for (const ui::PlanPainter::RulerTick& tick : plan.ticks(ruler, font)) {
                    const double width = letters.horizontalAdvance(tick.number);
                    const double from = tick.at + (ruler == Ruler::Upper ? ui::PlanPainter::kBesideTick
                                                                         : -ui::PlanPainter::kBesideTick - width);
                    const double end = ruler == Ruler::Upper ? flat().viewport().width() : flat().viewport().height();
                    QVERIFY(tick.number.isEmpty() || (from >= ui::PlanPainter::kRulerPixels && from + width <= end));
                    ++(tick.number.isEmpty() ? leftOut : shown);
                }
            }
        }
        QVERIFY(shown > 100 && leftOut > 5);
    }

    void flatViewStaysFlat() {
        for (const Qt::Key pressed : {Qt::Key_I, Qt::Key_O, Qt::Key_Left, Qt::Key_Up}) {
            key(views().flat(), pressed);
            QVERIFY(flat().camera().direction().z < -0.99999F);
            QVERIFY(flat().camera().isOrthographic());
        }
        m_fixture->key(Qt::Key_O);
    }

    void turningOverShowsTheOtherSideOfTheSamePlace() {
        flat().zoomAt({100, 100}, 1.5F);  // a whole board stays whole instead
        const QImage top = picture(views().flat());
        const glm::vec3 target = flat().camera().target();
        key(views().flat(), Qt::Key_Space);
        QVERIFY(flat().camera().direction().z > 0.99999F);
        QCOMPARE(flat().camera().target(), target);
        QVERIFY(differingPixels(top, picture(views().flat())) > 1000);
        key(views().flat(), Qt::Key_Space);
        QCOMPARE(differingPixels(top, picture(views().flat())), 0);
    }

    void leftDragInTwoDDrawsABoxAndMovesNothing() {
        QSignalSpy finished(&flat(), &ui::CameraController::boxFinished);
        const glm::vec3 target = flat().camera().target();
        drag(views().flat(), Qt::LeftButton, {50, 60}, {120, 90});
        QCOMPARE(finished.count(), 1);
        QCOMPARE(finished.first()[0].toPointF(), QPointF(50, 60));
        QCOMPARE(finished.first()[1].toPointF(), QPointF(120, 90));
        QCOMPARE(flat().camera().target(), target);
        drag(views().flat(), Qt::RightButton, {50, 60}, {120, 90});
        QCOMPARE(finished.count(), 1);
        QVERIFY(flat().camera().target() != target);
    }

    void screenAndBoardAgree() {
        for (BoardView* view : views().both()) {
            const ui::CameraController& controller = view->controller();
            const QPointF location(70, 90);
            const auto ray = controller.rayAt(location);
            const std::optional<QPointF> back = controller.screenOf(ray.origin + 100.0F * ray.direction);
            QVERIFY(back.has_value());
            QVERIFY2(QLineF(*back, location).length() < 0.05,
                     qPrintable(QString::number(QLineF(*back, location).length())));
        }
    }

    void hiddenLayersAreHiddenInBoth() {
        const QImage before[] = {picture(views().flat()), picture(views().solid())};
        window().actions()[ActionId::ShowCopperOnly].trigger();
        QVERIFY(differingPixels(before[0], picture(views().flat())) > 100);
        QVERIFY(differingPixels(before[1], picture(views().solid())) > 100);
    }

    void contrastFadesTheOtherLayersInTwoDOnly() {
        window().layersPanel().select(model::LayerId{std::size_t(topCopper())});
        const QImage before[] = {picture(views().flat()), picture(views().solid())};
        m_fixture->key(Qt::Key_H, Qt::ShiftModifier);
        QVERIFY(differingPixels(before[0], picture(views().flat())) > 1000);
        QCOMPARE(differingPixels(before[1], picture(views().solid())), 0);
        const QImage contrast = picture(views().flat());
        m_fixture->key(Qt::Key_PageDown);
        QVERIFY2(differingPixels(contrast, picture(views().flat())) > 1000, "the layer below is the bright one now");
        m_fixture->key(Qt::Key_PageUp);
        m_fixture->key(Qt::Key_H, Qt::ShiftModifier);
        QCOMPARE(differingPixels(before[0], picture(views().flat())), 0);
    }

    void theCurrentLayerIsOnTopInTwoDOnly() {
        const auto trigger = [this](ActionId id) { window().actions()[id].trigger(); };
        trigger(ActionId::ShowCopperOnly);
        trigger(ActionId::TopCopper);
        const QImage top[] = {picture(views().flat()), picture(views().solid())};
        trigger(ActionId::BottomCopper);
        const std::size_t bottom = window().layersPanel().currentLayer().row();
        QVERIFY(differingPixels(picture(views().flat()), top[0]) > 1000);
        QCOMPARE(differingPixels(picture(views().solid()), top[1]), 0);
        const auto heights = views().flat().drawnHeights();  // by which clicks are resolved
        for (std::size_t row = 0; row < heights.size(); ++row) {
            const bool isHole = window().document()->layers[row].spans(model::LayerId{bottom});
            QCOMPARE(heights[row].z1 > heights[bottom].z1, isHole);
        }
        trigger(ActionId::TopCopper);
        QCOMPARE(differingPixels(picture(views().flat()), top[0]), 0);
    }

    void layerKeysStepThroughVisibleLayersAndCarrySoloAlong() {
        window().layersPanel().select(model::LayerId{std::size_t(topCopper())});
        m_fixture->key(Qt::Key_PageDown);
        const int next = static_cast<int>(window().layersPanel().currentLayer().row());
        QVERIFY(next > topCopper());
        QVERIFY(window().layers().effectiveStyles()[static_cast<std::size_t>(next)].isVisible);
        m_fixture->key(Qt::Key_PageUp);
        QCOMPARE(static_cast<int>(window().layersPanel().currentLayer().row()), topCopper());
        m_fixture->key(Qt::Key_H);
        m_fixture->key(Qt::Key_PageDown);
        QCOMPARE(window().layers().soloLayer(), window().layersPanel().currentLayer());
    }

private:
    TestWindow& window() { return m_fixture->window(); }
    ui::BoardViews& views() { return window().views(); }
    ui::CameraController& flat() { return views().flat().controller(); }
    ui::CameraController& solid() { return views().solid().controller(); }

    static QImage picture(BoardView& view) {
        base::Result<QImage> image = view.grabPicture();
        return image ? image->convertToFormat(QImage::Format_RGB32) : QImage();
    }
    static void key(BoardView& view, Qt::Key key) {
        if (auto* native = qobject_cast<QWindow*>(&view.canvas())) {
            QTest::keyClick(native, key);
        } else {
            QTest::keyClick(qobject_cast<QWidget*>(&view.canvas()), key);
        }
    }
    static void mouse(BoardView& view, QEvent::Type type, Qt::MouseButton button, QPointF at) {
        const Qt::MouseButtons held = type == QEvent::MouseButtonRelease ? Qt::NoButton : Qt::MouseButtons(button);
        QMouseEvent event(type, at, at, type == QEvent::MouseMove ? Qt::NoButton : button, held, Qt::NoModifier);
        QCoreApplication::sendEvent(&view.canvas(), &event);
    }
    static void moveOver(BoardView& view) {
        QMouseEvent event(QEvent::MouseMove, QPointF(60, 60), view.mapToGlobal(QPointF(60, 60)), Qt::NoButton,
                          Qt::NoButton, Qt::NoModifier);
        QCoreApplication::sendEvent(&view.canvas(), &event);
    }
    static void leave(BoardView& view) {
        QEvent event(QEvent::Leave);
        QCoreApplication::sendEvent(&view.canvas(), &event);
    }
    static void click(BoardView& view, QPointF at) {
        mouse(view, QEvent::MouseButtonPress, Qt::LeftButton, at);
        mouse(view, QEvent::MouseButtonRelease, Qt::LeftButton, at);
    }
    static void drag(BoardView& view, Qt::MouseButton button, QPointF from, QPointF to) {
        mouse(view, QEvent::MouseButtonPress, button, from);
        mouse(view, QEvent::MouseMove, button, (from + to) / 2);
        mouse(view, QEvent::MouseMove, button, to);
        mouse(view, QEvent::MouseButtonRelease, button, to);
    }
    int topCopper() {
        const auto& layers = window().document()->layers;
        const auto found =
            std::find_if(layers.begin(), layers.end(), [](const auto& layer) { return layer.isCopper(); });
        return static_cast<int>(found - layers.begin());
    }

    std::unique_ptr<WindowFixture> m_fixture;
};

QTEST_MAIN(BoardViewsTest)
#include "board_views_test.moc"
