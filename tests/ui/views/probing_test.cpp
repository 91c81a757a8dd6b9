#include "ui/views/probing.h"

#include <QLineEdit>
#include <QMenu>
#include <QMouseEvent>
#include <QtTest>

#include "tests/locations.h"
#include "tests/patience.h"
#include "tests/ui/window_fixture.h"
#include "ui/common/table_view.h"
#include "ui/element/element_panel.h"
#include "ui/nets/nets_panel.h"
#include "ui/views/element_outlines.h"

using model::BoardElement;
using ui::ActionId;
using ui::BoardView;

/// From the cursor to the selection and back into both views, with real mouse events on the sample board.
class ProbingTest : public QObject {
    Q_OBJECT

private slots:
    void initTestCase() {
        m_fixture = std::make_unique<WindowFixture>();
        QVERIFY(m_fixture->openAndWait(locations::kSample));
        m_position = window().probing().position();
    }
    void init() {
        while (window().selection().clearStep()) {
        }
        views().flat().controller().look(render::NamedView::Top);
        views().solid().controller().look(render::NamedView::Top);
    }
    void cleanupTestCase() { QCOMPARE(validationErrorsOnClosing(m_fixture), 0U); }

    void aClickSelectsThePadUnderItInEitherView() {
        const model::ElementId pad = aPad();
        for (BoardView* view : views().both()) {
            window().selection().select({});
            view->controller().show(boxMin(pad), boxMax(pad));
            click(*view, centreOf(*view, pad));
            QVERIFY2(!window().selection().selected().empty(), "something is selected");
            // The pad itself or the hole through it; the other one lies beneath.
            bool isFound = window().selection().current() == BoardElement{0, pad};
            if (!isFound) {
                tab(*view);
                isFound = window().selection().current() == BoardElement{0, pad};
            }
            QVERIFY(isFound);
            QVERIFY(!window().fact("Layer").isEmpty());
            QCOMPARE(window().label("elementHeading"), "One element");
        }
    }

    void selectingLightsTheElementUpInBothViews() {
        const model::ElementId pad = aPad();
        for (BoardView* view : views().both()) {
            view->controller().show(boxMin(pad), boxMax(pad));
        }
        const QImage before[] = {picture(views().flat()), picture(views().solid())};
        window().selection().select({{0, pad}});
        QVERIFY(differingPixels(before[0], picture(views().flat())) > 20);
        QVERIFY(differingPixels(before[1], picture(views().solid())) > 20);
        m_fixture->key(Qt::Key_Escape);
        QVERIFY(window().selection().selected().empty());
        QCOMPARE(differingPixels(before[0], picture(views().flat())), 0);
        QCOMPARE(differingPixels(before[1], picture(views().solid())), 0);
    }

    /// Filled it would cover all that lies over it.
    void aPlaneThatIsSelectedIsOutlinedAloneAndFilledWithItsNet() {
        const BoardElement plane{0, largestElement()};
        const QImage before = picture(views().flat());
        window().selection().select({plane});
        QCOMPARE(differingPixels(before, picture(views().flat())), 0);
        QTRY_VERIFY(!window().find<ui::ElementOutlines>().strokesOver(views().flat()).lines().empty());
        m_fixture->key(Qt::Key_N);
        QVERIFY(!window().selection().nets().empty());
        QVERIFY(differingPixels(before, picture(views().flat())) > 1000);
    }

    void tabWalksThroughWhatLiesBeneathAndComesBack() {
        const model::ElementId pad = aPad();
        BoardView& view = views().flat();
        view.controller().show(boxMin(pad), boxMax(pad));
        const QPointF location = centreOf(view, pad);
        std::vector<BoardElement> seen;
        click(view, location);
        do {
            seen.push_back(*window().selection().current());
            tab(view);
        } while (seen.size() < 50 && *window().selection().current() != seen.front());
        seen.push_back(*window().selection().current());
        QVERIFY2(seen.size() > 2, "several layers lie under a pad");
        QVERIFY2(seen.size() < 50, "the first one comes again");
        seen.pop_back();
        std::sort(seen.begin(), seen.end());
        QVERIFY2(std::adjacent_find(seen.begin(), seen.end()) == seen.end(), "each comes once");
    }

    void whatLiesBeneathNeedsAPause() {
        const model::ElementId pad = aPad();
        BoardView& view = views().flat();
        view.controller().show(boxMin(pad), boxMax(pad));
        const QPointF location = centreOf(view, pad);
        QApplication::setDoubleClickInterval(60'000);
        click(view, location);
        const auto first = window().selection().current();
        QVERIFY(first.has_value());
        click(view, location);
        QCOMPARE(window().selection().current(), first);
        tab(view);
        const auto beneath = window().selection().current();
        QVERIFY(beneath && beneath != first);
        tab(view, Qt::Key_Backtab);
        QCOMPARE(window().selection().current(), first);
        QApplication::setDoubleClickInterval(1);
        QTest::qWait(10);
        click(view, location);
        QCOMPARE(window().selection().current(), beneath);
        QApplication::setDoubleClickInterval(400);
    }

    /// Its first click would take what lies beneath, if it stayed alone.
    void aDoubleClickAfterAPauseKeepsWhatIsSelected() {
        const model::ElementId pad = aPad();
        BoardView& view = views().flat();
        view.controller().show(boxMin(pad), boxMax(pad));
        const QPointF location = centreOf(view, pad);
        click(view, location);
        const auto first = window().selection().current();
        QVERIFY(first.has_value());
        QApplication::setDoubleClickInterval(1);
        QTest::qWait(10);
        click(view, location);
        QVERIFY(window().selection().current() != first);
        QApplication::setDoubleClickInterval(400);
        const float scale = view.controller().mmPerPixel();
        mouse(view, QEvent::MouseButtonDblClick, Qt::LeftButton, location);
        mouse(view, QEvent::MouseButtonRelease, Qt::LeftButton, location);
        QCOMPARE(window().selection().current(), first);
        QVERIFY(view.controller().mmPerPixel() != scale);
    }

    void aDoubleClickKeepsWhatItHitFirstAndZoomsBothViews() {
        const model::ElementId pad = aPad();
        BoardView& view = views().flat();
        const QPointF location = centreOf(view, pad);
        const float scales[] = {view.controller().mmPerPixel(), views().solid().controller().mmPerPixel()};
        click(view, location);
        const auto first = window().selection().current();
        QVERIFY(first.has_value());
        mouse(view, QEvent::MouseButtonPress, Qt::LeftButton, location);  // as a window gets it
        mouse(view, QEvent::MouseButtonDblClick, Qt::LeftButton, location);
        mouse(view, QEvent::MouseButtonRelease, Qt::LeftButton, location);
        QCOMPARE(window().selection().current(), first);
        QVERIFY(view.controller().mmPerPixel() < scales[0] * 0.5F);
        QVERIFY(views().solid().controller().mmPerPixel() < scales[1] * 0.5F);
    }

    void aRightClickSelectsAndOffersWhatCanBeDone() {
        const model::ElementId pad = aPad();
        BoardView& view = views().flat();
        view.controller().show(boxMin(pad), boxMax(pad));
        const QPointF location = centreOf(view, pad);
        const QStringList texts = menuAt(view, location);
        QVERIFY(window().selection().selected().size() == 1);
        const auto chosen = window().selection().current();
        for (const char* text : {"Highlight net", "Isolate net", "Select component", "Show in both views"}) {
            QVERIFY2(texts.contains(text), text);
        }
        QVERIFY(!texts.filter("Hide layer ").isEmpty());
        tab(view);
        const auto beneath = window().selection().current();
        QVERIFY(beneath != chosen);
        menuAt(view, location);
        QCOMPARE(window().selection().current(), beneath);  // what was taken from beneath stays
        window().selection().select({});
        view.controller().fit();
        view.controller().zoomAtCentre(0.3F);
        QVERIFY(menuAt(view, {22, 22}).contains("Show all nets"));
        QVERIFY(window().selection().isEmpty());
    }

    void zShowsTheHighlightedNet() {
        window().selection().setNets({boardNet(smallNet())});
        const float before = views().flat().controller().mmPerPixel();
        m_fixture->key(Qt::Key_Z);
        QVERIFY(views().flat().controller().mmPerPixel() < before * 0.9F);
    }

    void keysAreAboutWhatThePointerIsOnNow() {
        BoardView& view = views().flat();
        view.controller().fit();
        const model::ElementId first = aPad();
        const model::ElementId second = aPad(board().elements.net[first.row()]);
        const auto moveTo = [&](model::ElementId pad) {
            const QPointF at = centreOf(view, pad);
            QMouseEvent event(QEvent::MouseMove, at, view.mapToGlobal(at), Qt::NoButton, Qt::NoButton, Qt::NoModifier);
            QCoreApplication::sendEvent(&view.canvas(), &event);
        };
        moveTo(first);
        QTRY_VERIFY(window().selection().hovered().has_value());
        QCOMPARE(board().elements.net[window().selection().hovered()->element.row()],
                 board().elements.net[first.row()]);
        moveTo(second);
        m_fixture->key(Qt::Key_N);
        QCOMPARE(window().selection().nets(), (std::vector<model::BoardNet>{{0, board().elements.net[second.row()]}}));
    }

    void ctrlAddsAndTakesAway() {
        const model::ElementId pad = aPad();
        BoardView& view = views().flat();
        view.controller().show(boxMin(pad), boxMax(pad));
        click(view, centreOf(view, pad), Qt::ControlModifier);
        QCOMPARE(window().selection().selected().size(), std::size_t{1});
        click(view, centreOf(view, pad), Qt::ControlModifier);
        QVERIFY(window().selection().selected().empty());
    }

    void aBoxSelectsWhatIsInsideAndDrawnBackwardsWhatItTouches() {
        BoardView& view = views().flat();
        const QSizeF size = view.controller().viewport();
        const QPointF corner(size.width() * 0.35, size.height() * 0.35);
        const QPointF opposite(size.width() * 0.65, size.height() * 0.65);
        drag(view, corner, opposite);
        const auto inside = window().selection().selected();
        QVERIFY(inside.size() > 10);
        drag(view, opposite, corner);
        const auto touched = window().selection().selected();
        QVERIFY(touched.size() > inside.size());
        QVERIFY(std::includes(touched.begin(), touched.end(), inside.begin(), inside.end()));
        QVERIFY(window().label("elementHeading").contains("elements"));
    }

    void theBoxIsSeenWhileItIsDrawn() {
        BoardView& view = views().flat();
        const QImage before = picture(view);
        mouse(view, QEvent::MouseButtonPress, Qt::LeftButton, {40, 60});
        mouse(view, QEvent::MouseMove, Qt::LeftButton, {90, 120});
        QVERIFY(differingPixels(before, picture(view)) > 100);
        mouse(view, QEvent::MouseButtonRelease, Qt::LeftButton, {90, 120});
        window().selection().select({});
        QCOMPARE(differingPixels(before, picture(view)), 0);
        mouse(view, QEvent::MouseButtonPress, Qt::LeftButton, {40, 60});
        mouse(view, QEvent::MouseMove, Qt::LeftButton, {90, 120});
        QKeyEvent escape(QEvent::KeyPress, Qt::Key_Escape, Qt::NoModifier);
        QCoreApplication::sendEvent(&view.canvas(), &escape);
        QCOMPARE(differingPixels(before, picture(view)), 0);
        mouse(view, QEvent::MouseButtonRelease, Qt::LeftButton, {90, 120});
    }

    void hoveringLightsUpAndLeavingEndsIt() {
        const model::ElementId pad = aPad();
        BoardView& view = views().flat();
        view.controller().show(boxMin(pad), boxMax(pad));
        mouse(view, QEvent::MouseMove, Qt::NoButton, centreOf(view, pad));
        QTRY_VERIFY(window().selection().hovered().has_value());
        QVERIFY(window().label("position").contains("mm"));
        QEvent leave(QEvent::Leave);
        QCoreApplication::sendEvent(&view.canvas(), &leave);
        QVERIFY(!window().selection().hovered().has_value());
        QVERIFY(window().label("position").isEmpty());
    }

    void thePositionIsThatUnderThePointerHoweverTheBoardMoves() {
        BoardView& view = views().flat();
        const QPointF at(view.width() * 0.4, view.height() * 0.4);
        mouse(view, QEvent::MouseMove, Qt::NoButton, at);
        for (const ActionId id : {ActionId::Flip, ActionId::ZoomIn, ActionId::ViewTop}) {
            const QString before = window().label("position");
            window().actions()[id].trigger();
            const base::PointD nm = view.locationAt(at);
            QVERIFY(window().label("position") != before);
            QVERIFY(window().label("position").startsWith(ui::positionText(nm.x, nm.y, ui::LengthUnit::Millimetre)));
        }
    }

    void hoveringEndsWhenThePointerOrTheBoardMovesAway() {
        const model::ElementId pad = aPad();
        BoardView& view = views().flat();
        view.controller().show(boxMin(pad), boxMax(pad));
        const QPointF at = centreOf(view, pad);
        const auto hover = [&] {
            mouse(view, QEvent::MouseMove, Qt::NoButton, at);
            QTRY_VERIFY(window().selection().hovered().has_value());
        };
        hover();
        mouse(view, QEvent::MouseMove, Qt::NoButton, at + QPointF(1, 1));
        QVERIFY(window().selection().hovered().has_value());  // still on it
        mouse(view, QEvent::MouseMove, Qt::NoButton, {1, 1});
        QVERIFY(!window().selection().hovered().has_value());  // at once, not when the pointer rests
        hover();
        drag(view, at, at + QPointF(60, 60));  // a box
        QVERIFY(!window().selection().hovered().has_value());
        hover();
        mouse(view, QEvent::MouseButtonPress, Qt::MiddleButton, at);
        mouse(view, QEvent::MouseMove, Qt::MiddleButton, at + QPointF(60, 0));
        QVERIFY(!window().selection().hovered().has_value());
        mouse(view, QEvent::MouseButtonRelease, Qt::MiddleButton, at + QPointF(60, 0));
        QTest::qWait(100);
        QVERIFY(!window().selection().hovered().has_value());  // where the pointer is now it has not said
        view.controller().show(boxMin(pad), boxMax(pad));
        hover();
        view.controller().zoomAtCentre(1.2F);
        QVERIFY(!window().selection().hovered().has_value());
        QTRY_VERIFY(window().selection().hovered().has_value());  // the pad is still under the pointer
        QEvent leave(QEvent::Leave);
        QCoreApplication::sendEvent(&view.canvas(), &leave);
    }

    void netKeyLightsUpTheNetAndEscapeTakesBackOneStepAtATime() {
        const model::ElementId pad = aPad();
        window().selection().select({{0, pad}});
        m_fixture->key(Qt::Key_N);
        QCOMPARE(window().selection().nets(), (std::vector{boardNet(board().elements.net[pad.row()])}));
        QVERIFY(window().selection().selected().empty());
        window().selection().select({{0, pad}});
        m_fixture->key(Qt::Key_Escape);
        QVERIFY(window().selection().selected().empty());
        QCOMPARE(window().selection().nets().size(), std::size_t{1});
        m_fixture->key(Qt::Key_Escape);
        QVERIFY(window().selection().nets().empty());
    }

    void dimmingDarkensTheRestOnlyWhileSomethingIsSelected() {
        const QImage before = picture(views().flat());
        m_fixture->key(Qt::Key_D);
        QCOMPARE(differingPixels(before, picture(views().flat())), 0);
        window().selection().select({{0, aPad()}});
        QVERIFY(differingPixels(before, picture(views().flat())) > 1000);
        m_fixture->key(Qt::Key_D);
    }

    void altAndAClickBringTheElementToTheOtherView() {
        const model::ElementId pad = aPad();
        const float before = views().solid().controller().mmPerPixel();
        const float own = views().flat().controller().mmPerPixel();
        click(views().flat(), centreOf(views().flat(), pad), Qt::AltModifier);
        QCOMPARE(views().flat().controller().mmPerPixel(), own);
        QVERIFY(views().solid().controller().mmPerPixel() < before * 0.5F);
        const QPointF at = centreOf(views().solid(), pad);
        const QSizeF size = views().solid().controller().viewport();
        QVERIFY(QLineF(at, QPointF(size.width() / 2, size.height() / 2)).length() < 3.0);
    }

    void camerasFollowOnlyWhenAsked() {
        const model::ElementId pad = aPad();
        views().flat().controller().show(boxMin(pad), boxMax(pad));
        const float before = views().solid().controller().mmPerPixel();
        click(views().flat(), centreOf(views().flat(), pad));
        QCOMPARE(views().solid().controller().mmPerPixel(), before);
        window().actions()[ActionId::FollowInSolid].trigger();
        click(views().flat(), centreOf(views().flat(), pad) + QPointF(9, 0));
        click(views().flat(), centreOf(views().flat(), pad));
        QVERIFY(views().solid().controller().mmPerPixel() < before * 0.9F);
        window().actions()[ActionId::FollowInSolid].trigger();
    }

    void nFindsWhatLiesUnderAPointerThatHasNotMovedSinceADrag() {
        const model::ElementId pad = aPad();
        BoardView& view = views().flat();
        view.controller().show(boxMin(pad), boxMax(pad));
        const QPointF at = centreOf(view, pad);
        QCursor::setPos(view.mapToGlobal(at).toPoint());
        QTRY_VERIFY(view.underMouse());
        mouse(view, QEvent::MouseButtonPress, Qt::RightButton, at + QPointF(30, 0));
        mouse(view, QEvent::MouseMove, Qt::RightButton, at + QPointF(50, 0));
        mouse(view, QEvent::MouseMove, Qt::RightButton, at + QPointF(30, 0));
        mouse(view, QEvent::MouseButtonRelease, Qt::RightButton, at + QPointF(30, 0));
        QVERIFY(!window().selection().hovered());
        m_fixture->key(Qt::Key_N);
        QCOMPARE(window().selection().nets(), std::vector{boardNet(board().elements.net[pad.row()])});
    }

    void unitKeyChangesWhatIsRead() {
        window().selection().select({{0, aPad()}});
        const QString before = window().fact("Extent");
        QVERIFY(before.contains("mm"));
        m_fixture->key(Qt::Key_Q);
        QVERIFY(window().fact("Extent").contains("mil"));
        m_fixture->key(Qt::Key_Q);
        m_fixture->key(Qt::Key_Q);
        QCOMPARE(window().fact("Extent"), before);
    }

    void netsTableAndViewsShowTheSameNets() {
        QTRY_VERIFY(window().nets().isArranged());
        QVERIFY(window().nets().rowCount() > 5);
        ui::TableView& table = window().netsPanel().table();
        const QImage before = picture(views().flat());
        const int row = *window().nets().rowOf(board().elements.net[aPad().row()]);
        table.scrollTo(window().nets().index(row, 0));
        QTest::mouseClick(table.viewport(), Qt::LeftButton, {},
                          table.visualRect(window().nets().index(row, 0)).center());
        QCOMPARE(window().selection().nets(), (std::vector{boardNet(board().elements.net[aPad().row()])}));
        QVERIFY(differingPixels(before, picture(views().flat())) > 20);
        views().solid().takeKeyboard();
        m_fixture->key(Qt::Key_Escape);
        QTRY_VERIFY(table.selectionModel()->selectedRows().isEmpty());
        window().selection().setNets({boardNet(window().nets().netAt(2))});
        QCOMPARE(table.selectionModel()->selectedRows().size(), 1);
        QCOMPARE(table.selectionModel()->selectedRows()[0].row(), 2);
    }

    void netsAreFilteredByTypingAndHighlightsStay() {
        QTRY_VERIFY(window().nets().isArranged());
        const int all = window().nets().rowCount();
        const model::NetId net = board().elements.net[aPad().row()];
        window().selection().setNets({boardNet(net)});
        QTest::keyClicks(&window().netsPanel().filterEdit(), QString::fromStdString(board().nets[net.row()].name));
        QTRY_VERIFY(window().nets().isArranged() && window().nets().rowCount() < all);
        QVERIFY(window().nets().rowOf(net).has_value());
        QVERIFY(window().label("netsShown").contains(" of "));
        QCOMPARE(window().selection().nets(), std::vector{boardNet(net)});
        window().netsPanel().filterEdit().clear();
        QTRY_COMPARE(window().nets().rowCount(), all);
        QCOMPARE(window().selection().nets(), std::vector{boardNet(net)});
    }

    void enterInTheTableBringsTheNetToBothViews() {
        QTRY_VERIFY(window().nets().isArranged());
        const float before = views().flat().controller().mmPerPixel();
        ui::TableView& table = window().netsPanel().table();
        table.setCurrentIndex(window().nets().index(*window().nets().rowOf(smallNet()), 0));
        QTest::keyClick(&table, Qt::Key_Return);
        QVERIFY(views().flat().controller().mmPerPixel() < before * 0.9F);
    }

    void gridAndNamesComeAndGo() {
        const model::ElementId pad = aPad();
        views().flat().controller().show(boxMin(pad), boxMax(pad));
        const QImage before = picture(views().flat());
        for (const QKeyCombination keys :
             {QKeyCombination(Qt::Key_G), QKeyCombination(Qt::Key_W), Qt::SHIFT | Qt::Key_W}) {
            m_fixture->key(keys.key(), keys.keyboardModifiers());
            QVERIFY(differingPixels(before, picture(views().flat())) > 50);
            m_fixture->key(keys.key(), keys.keyboardModifiers());
            QCOMPARE(differingPixels(before, picture(views().flat())), 0);
        }
    }

    void nothingIsPickedInViewsThatWaitForTheirBoard() {
        QObject other;                                           // something else has the device
        QTRY_VERIFY(m_fixture->context().turns().begin(other));  // after the picture that is being made, if any
        views().setArrangement(ui::Arrangement::Solid);  // the flat view would show the board without the device
        window().open(m_fixture->copyOfJob("everything"));
        QTRY_VERIFY(!window().loader().isLoading());
        QVERIFY(!views().solid().hasScene());
        for (BoardView* view : views().both()) {
            QVERIFY(!view->hasScene());
            QCOMPARE(view->styles().size(), board().layers.size());
            const std::vector<model::PickLayer> layers = window().probing().layersOf(*view);
            QCOMPARE(layers.size(), board().layers.size());
            QVERIFY(std::ranges::none_of(layers, &model::PickLayer::isVisible));
            const QPointF corner(view->width() * 0.05, view->height() * 0.05);
            const QPointF opposite(view->width() * 0.95, view->height() * 0.95);
            click(*view, (corner + opposite) / 2.0);
            drag(*view, corner, opposite);
            drag(*view, opposite, corner);
            QVERIFY(window().selection().selected().empty());
            window().actions()[ActionId::MeasurePoints].trigger();
            click(*view, (corner + opposite) / 2.0);
            click(*view, corner);
            window().actions()[ActionId::MeasurePoints].trigger();
            QVERIFY(window().measurements().measurements().empty());
        }
        m_fixture->context().turns().end(other);
        QTRY_VERIFY(views().solid().hasScene() && views().flat().hasScene());
        views().setArrangement(ui::Arrangement::SideBySide);
        QVERIFY(m_fixture->openAndWait(locations::kSample));
    }

    void gridStepsAreRoundNumbersOfTheUnit() {
        using ui::LengthUnit;
        using ui::PlanPainter;
        QCOMPARE(PlanPainter::gridStep(1000.0, LengthUnit::Millimetre, 24.0), 5e4);
        QCOMPARE(PlanPainter::gridStep(1e6 / 20.0, LengthUnit::Millimetre, 20.0), 1e6);
        QCOMPARE(PlanPainter::gridStep(25400.0, LengthUnit::Mil, 24.0), 50 * 25400.0);
        for (double scale = 10.0; scale < 1e7; scale *= 1.7) {
            const double step = PlanPainter::gridStep(scale, LengthUnit::Inch, 24.0);
            QVERIFY(step >= scale * 24.0 * 0.999 && step <= scale * 24.0 * 2.6);
        }
    }

private:
    TestWindow& window() { return m_fixture->window(); }
    ui::BoardViews& views() { return window().views(); }
    const model::Document& board() { return *window().document(); }

    /// A pad on the uppermost copper layer that has a net.
    /// Not of this net.
    model::ElementId aPad(model::NetId other = {}) {
        const auto& elements = board().elements;
        for (std::size_t row = 0; row < elements.size(); ++row) {
            const model::Layer& layer = board().layer(elements.layer[row]);
            if (layer.isCopper() && layer.side == model::LayerSide::Top && (elements.flags[row] & model::kPad) != 0 &&
                elements.kind[row] == model::ElementKind::Circle && elements.net[row].isValid() &&
                elements.net[row] != other) {
                return model::ElementId{row};
            }
        }
        return {};
    }
    /// Of those on the uppermost copper layer that have a net: others may be lines without width, which are not drawn.
    model::ElementId largestElement() {
        model::ElementId largest;
        std::int64_t size = 0;
        for (std::size_t row = 0; row < board().elements.size(); ++row) {
            const model::Box box = board().boxOf(model::ElementId{row});
            if (board().layer(board().elements.layer[row]).side == model::LayerSide::Top &&
                board().layer(board().elements.layer[row]).isCopper() && board().elements.net[row].isValid() &&
                box.width() > size) {
                size = box.width();
                largest = model::ElementId{row};
            }
        }
        return largest;
    }
    static model::BoardNet boardNet(model::NetId net) { return {0, net}; }
    /// The net of the smallest extent that has copper.
    model::NetId smallNet() {
        model::NetId smallest;
        std::int64_t size = std::numeric_limits<std::int64_t>::max();
        for (std::size_t row = 0; row < board().nets.size(); ++row) {
            model::Box box;
            for (const model::ElementId element : board().elementsOf(model::NetId{row})) {
                box.include(board().boxOf(element));
            }
            if (!box.isEmpty() && box.width() + box.height() < size) {
                size = box.width() + box.height();
                smallest = model::NetId{row};
            }
        }
        return smallest;
    }
    glm::vec3 boxMin(model::ElementId element) {
        return m_position.toModel(base::toDouble(board().boxOf(element).min));
    }
    glm::vec3 boxMax(model::ElementId element) {
        return m_position.toModel(base::toDouble(board().boxOf(element).max));
    }
    QPointF centreOf(BoardView& view, model::ElementId element) {
        const model::Layer& layer = board().layer(board().elements.layer[element.row()]);
        glm::vec3 centre = (boxMin(element) + boxMax(element)) / 2.0F;
        centre.z = static_cast<float>(base::toMm(layer.z + layer.thickness));
        return view.controller().screenOf(centre).value_or(QPointF(-1, -1));
    }
    static QImage picture(BoardView& view) {
        base::Result<QImage> image = view.grabPicture();
        return image ? image->convertToFormat(QImage::Format_RGB32) : QImage();
    }
    static void mouse(BoardView& view, QEvent::Type type, Qt::MouseButton button, QPointF at,
                      Qt::KeyboardModifiers modifiers = Qt::NoModifier) {
        const Qt::MouseButtons held = type == QEvent::MouseButtonRelease ? Qt::NoButton : Qt::MouseButtons(button);
        QMouseEvent event(type, at, view.mapToGlobal(at), type == QEvent::MouseMove ? Qt::NoButton : button, held,
                          modifiers);
        QCoreApplication::sendEvent(&view.canvas(), &event);
    }
    static void click(BoardView& view, QPointF at, Qt::KeyboardModifiers modifiers = Qt::NoModifier) {
        mouse(view, QEvent::MouseButtonPress, Qt::LeftButton, at, modifiers);
        mouse(view, QEvent::MouseButtonRelease, Qt::LeftButton, at, modifiers);
    }
    static void tab(BoardView& view, Qt::Key key = Qt::Key_Tab) {
        QKeyEvent event(QEvent::KeyPress, key, Qt::NoModifier);
        QCoreApplication::sendEvent(&view.canvas(), &event);
    }
    /// The texts of the menu that a right click opens; it is closed again.
    static QStringList menuAt(BoardView& view, QPointF at) {
        mouse(view, QEvent::MouseButtonPress, Qt::RightButton, at);
        mouse(view, QEvent::MouseButtonRelease, Qt::RightButton, at);
        QStringList texts;
        if (auto* menu = qobject_cast<QMenu*>(QApplication::activePopupWidget())) {
            for (const QAction* action : menu->actions()) {
                texts += action->text().remove('&');
            }
            menu->close();
            view.window()->activateWindow();  // the offscreen platform does not give it back
            (void)QTest::qWaitForWindowActive(view.window());
        }
        return texts;
    }
    static void drag(BoardView& view, QPointF from, QPointF to) {
        mouse(view, QEvent::MouseButtonPress, Qt::LeftButton, from);
        mouse(view, QEvent::MouseMove, Qt::LeftButton, (from + to) / 2);
        mouse(view, QEvent::MouseMove, Qt::LeftButton, to);
        mouse(view, QEvent::MouseButtonRelease, Qt::LeftButton, to);
    }

    std::unique_ptr<WindowFixture> m_fixture;
    ui::BoardPosition m_position;
};

QTEST_MAIN(ProbingTest)
#include "probing_test.moc"
