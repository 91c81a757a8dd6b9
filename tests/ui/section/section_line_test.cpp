#include "ui/section/section_line.h"

#include <QStatusBar>

#include "tests/patience.h"
#include "tests/ui/section/section_fixture.h"
#include "tests/ui/window_fixture.h"
#include "ui/shell/message_bar.h"

using base::PointD;
using ui::ActionId;
using ui::BoardView;

/// The line of a section is drawn and moved in the 2D view, with real mouse and key events on the sample board.
class SectionLineTest : public QObject, protected SectionFixture {
    Q_OBJECT

private slots:
    void initTestCase() { open(); }
    void init() { reset(); }
    void cleanupTestCase() { QCOMPARE(validationErrorsOnClosing(m_fixture), 0U); }

    void aDraggedLineIsCutLiveAndExactly() {
        m_fixture->key(Qt::Key_S, Qt::ShiftModifier);
        QVERIFY(window().actions()[ActionId::DrawSection].isChecked());
        QVERIFY(window().find<ui::SectionPanel>().isVisible());
        const auto [from, to] = acrossBoard();
        mouse(QEvent::MouseButtonPress, from);
        std::size_t last = 0;
        for (int step = 1; step <= 4; ++step) {
            mouse(QEvent::MouseMove, from + (to - from) * step / 4.0);
            QTRY_VERIFY(view().section() &&
                        isAt(view().section()->line.back(), window().find<ui::SectionLine>().line().back()));
            QCOMPARE(view().section()->pieces.size(), expected().pieces.size());
            QVERIFY(view().section()->pieces.size() > last);
            last = view().section()->pieces.size();
        }
        mouse(QEvent::MouseButtonRelease, to);
        QVERIFY(!window().actions()[ActionId::DrawSection].isChecked());
        QVERIFY(same(view().section()->pieces, expected().pieces));
        QVERIFY(same(view().section()->bores, expected().bores));
        QVERIFY(window().selection().selected().empty());  // the drag drew no box
    }

    void theHintGoesWithTheTool() {
        QStatusBar& bar = *window().statusBar();
        m_fixture->key(Qt::Key_S, Qt::ShiftModifier);
        QVERIFY(bar.currentMessage().startsWith("Drag a line"));
        m_fixture->key(Qt::Key_Escape);
        QVERIFY(bar.currentMessage().isEmpty());
        m_fixture->key(Qt::Key_S, Qt::ShiftModifier);
        window().workspace().report(QString("something else"));
        m_fixture->key(Qt::Key_Escape);
        QCOMPARE(bar.currentMessage(), QString("something else"));
        m_fixture->key(Qt::Key_M);
        QVERIFY(!bar.currentMessage().isEmpty());
        m_fixture->key(Qt::Key_Escape);
        QVERIFY(bar.currentMessage().isEmpty());
    }

    void drawingAndMeasuringEndEachOther() {
        const QAction& drawing = window().actions()[ActionId::DrawSection];
        const QAction& measuring = window().actions()[ActionId::MeasureObjects];
        m_fixture->key(Qt::Key_S, Qt::ShiftModifier);
        m_fixture->key(Qt::Key_M, Qt::ShiftModifier);
        QVERIFY(measuring.isChecked() && !drawing.isChecked());
        QVERIFY(!window().find<ui::SectionLine>().isDrawing());
        const QString prompt = window().statusBar()->currentMessage();
        QVERIFY2(!prompt.isEmpty() && !prompt.startsWith("Drag a line"), qPrintable(prompt));
        m_fixture->key(Qt::Key_S, Qt::ShiftModifier);
        QVERIFY(drawing.isChecked() && !measuring.isChecked());
        QVERIFY(window().find<ui::SectionLine>().isDrawing() && window().probing().isSelecting());
        QVERIFY(window().statusBar()->currentMessage().startsWith("Drag a line"));
        m_fixture->key(Qt::Key_Escape);
        QVERIFY(!drawing.isChecked() && !measuring.isChecked());
    }

    void cornersAreClickedTakenBackAndEnded() {
        m_fixture->key(Qt::Key_S, Qt::ShiftModifier);
        const auto [from, to] = acrossBoard();
        const QPointF way = to - from;
        const std::vector<QPointF> clicks{from, from + way * 0.4, from + way * 0.4 + QPointF(0, 40), from + way * 0.8};
        for (const QPointF& at : clicks) {
            clickOn(at);
        }
        hover(to);
        QCOMPARE(window().find<ui::SectionLine>().line().size(), clicks.size() + 1);  // the last leg follows the cursor
        QTRY_VERIFY(view().section() && view().section()->line.size() == clicks.size() + 1);
        QVERIFY(same(view().section()->pieces, expected().pieces));
        pressKey(Qt::Key_Backspace);
        QCOMPARE(window().find<ui::SectionLine>().line().size(), clicks.size());
        clickOn(to);
        QVERIFY(window().actions()[ActionId::DrawSection].isChecked());
        pressKey(Qt::Key_Return);
        QVERIFY(!window().actions()[ActionId::DrawSection].isChecked());
        QVERIFY(!window().find<ui::SectionLine>().isDrawing());
        const std::vector<PointD>& line = window().find<ui::SectionLine>().line();
        QCOMPARE(line.size(), std::size_t{4});
        const std::vector<QPointF> corners{clicks[0], clicks[1], clicks[2], to};
        for (std::size_t i = 0; i < corners.size(); ++i) {
            const auto at = flat().controller().screenOf(window().probing().position().toModel(line[i]));
            QVERIFY(at && QLineF(*at, corners[i]).length() < 0.01);
        }
        QVERIFY(same(view().section()->pieces, expected().pieces));
        QVERIFY(window().selection().selected().empty());
    }

    /// Enter zooms in KLayout.
    void keysOfALineAreNoCommandsMeanwhile() {
        window().actions()[ActionId::KeysKLayout].trigger();
        window().actions()[ActionId::DrawSection].trigger();
        const auto [from, to] = acrossBoard();
        clickOn(from);
        clickOn(to);
        const float before = flat().controller().mmPerPixel();
        typeKey(Qt::Key_Return);
        QVERIFY(!window().find<ui::SectionLine>().isDrawing());
        QCOMPARE(window().find<ui::SectionLine>().line().size(), std::size_t{2});
        QCOMPARE(flat().controller().mmPerPixel(), before);
        typeKey(Qt::Key_Return);
        QVERIFY(flat().controller().mmPerPixel() < before);
    }

    void aDoubleClickEndsALineOfClicksAndShiftKeepsItsLegsStraight() {
        m_fixture->key(Qt::Key_S, Qt::ShiftModifier);
        const auto [from, to] = acrossBoard();
        clickOn(from);
        mouse(QEvent::MouseButtonPress, to + QPointF(0, 9), Qt::ShiftModifier);
        mouse(QEvent::MouseButtonRelease, to + QPointF(0, 9), Qt::ShiftModifier);
        mouse(QEvent::MouseButtonDblClick, to + QPointF(0, 9), Qt::ShiftModifier);
        mouse(QEvent::MouseButtonRelease, to + QPointF(0, 9), Qt::ShiftModifier);
        QVERIFY(!window().find<ui::SectionLine>().isDrawing());
        QCOMPARE(window().find<ui::SectionLine>().line().size(), std::size_t{2});
        QCOMPARE(window().find<ui::SectionLine>().line()[0].y, window().find<ui::SectionLine>().line()[1].y);
        QVERIFY(view().section().has_value());
    }

    void drawingIsGivenUpAndTheLineIsWhatItWas() {
        drawLine();
        const std::vector<PointD> before = window().find<ui::SectionLine>().line();
        m_fixture->key(Qt::Key_S, Qt::ShiftModifier);
        const auto [from, to] = acrossBoard();
        clickOn(from + QPointF(0, 25));
        pressKey(Qt::Key_Return);  // one corner is no line
        QVERIFY(window().find<ui::SectionLine>().isDrawing());
        QTRY_VERIFY(!view().section() && window().find<ui::SectionPanel>().notes().isEmpty());
        clickOn(to + QPointF(0, 25));
        m_fixture->key(Qt::Key_Escape);
        QVERIFY(!window().find<ui::SectionLine>().isDrawing());
        QVERIFY(!window().actions()[ActionId::DrawSection].isChecked());
        QCOMPARE(window().find<ui::SectionLine>().line().size(), before.size());
        QVERIFY(isAt(window().find<ui::SectionLine>().line().back(), before.back()));
        QVERIFY(same(view().section()->pieces, expected().pieces));
    }

    void anEndIsMovedAndShiftKeepsTheLineStraight() {
        const auto [from, to] = acrossBoard();
        drawLine();
        const PointD start = window().find<ui::SectionLine>().line().front();
        mouse(QEvent::MouseButtonPress, to);
        mouse(QEvent::MouseMove, to + QPointF(3, 17), Qt::ShiftModifier);
        QCOMPARE(window().find<ui::SectionLine>().line().back().y, start.y);
        mouse(QEvent::MouseMove, to + QPointF(-20, 17));
        mouse(QEvent::MouseButtonRelease, to + QPointF(-20, 17));
        QVERIFY(window().find<ui::SectionLine>().line().back().y < start.y);
        QVERIFY(same(view().section()->pieces, expected().pieces));
        const PointD end = window().find<ui::SectionLine>().line().back();
        mouse(QEvent::MouseButtonPress, from);
        mouse(QEvent::MouseMove, from + QPointF(10, 10));
        mouse(QEvent::MouseButtonRelease, from + QPointF(10, 10));
        QVERIFY(isAt(window().find<ui::SectionLine>().line().back(), end));
        QVERIFY(same(view().section()->pieces, expected().pieces));
    }

    void escPutsACornerThatIsMovedBack() {
        const auto [from, to] = acrossBoard();
        drawLine();
        const std::vector<PointD> before = window().find<ui::SectionLine>().line();
        const std::vector<model::SectionDimension> dimensions{{{1e6, 0.0}, {2e6, 0.0}}};
        view().setDimensions(dimensions);
        window().selection().select({{0, model::ElementId{std::size_t{0}}}});
        mouse(QEvent::MouseButtonPress, to);
        mouse(QEvent::MouseMove, to + QPointF(-10, 9));
        mouse(QEvent::MouseMove, to + QPointF(-20, 17));
        QVERIFY(!isAt(window().find<ui::SectionLine>().line().back(), before.back()));
        QVERIFY(view().dimensions().all().empty());
        typeKey(Qt::Key_Escape);
        QVERIFY(std::ranges::equal(window().find<ui::SectionLine>().line(), before, isAt));
        QVERIFY(same(view().section()->pieces, expected().pieces));
        QCOMPARE(view().dimensions().all(), dimensions);
        QCOMPARE(window().selection().selected().size(), std::size_t{1});
        mouse(QEvent::MouseMove, to + QPointF(-40, 17));
        mouse(QEvent::MouseButtonRelease, to + QPointF(-40, 17));
        QVERIFY(std::ranges::equal(window().find<ui::SectionLine>().line(), before, isAt));
        QCOMPARE(window().selection().selected().size(), std::size_t{1});
    }

    /// As by the key that cuts along a net.
    void aCornerIsLetGoWhenTheLineBecomesAnother() {
        const auto [from, to] = acrossBoard();
        const std::vector<PointD> shorter{flat().locationAt(from), flat().locationAt(to)};
        sections().cutAlong({shorter[0], flat().locationAt((from + to) / 2.0), shorter[1]});
        mouse(QEvent::MouseButtonPress, to);
        mouse(QEvent::MouseMove, to + QPointF(-20, 17));
        QVERIFY(!isAt(window().find<ui::SectionLine>().line().back(), shorter[1]));
        sections().cutAlong(shorter);
        mouse(QEvent::MouseMove, to + QPointF(-40, 17));
        mouse(QEvent::MouseButtonRelease, to + QPointF(-40, 17));
        QVERIFY(std::ranges::equal(window().find<ui::SectionLine>().line(), shorter, isAt));
    }

    void theLineIsPaintedOver2d() {
        const QImage before = flat().grabPicture()->copy();
        drawLine();
        QVERIFY(differingPixels(before, *flat().grabPicture()) > 300);
        window().find<ui::SectionPanel>().findChild<QAction*>()->trigger();  // Clear
        QCOMPARE(differingPixels(before, *flat().grabPicture()), 0);
        QVERIFY(!view().section());
    }

    void theLineLiesBelowTheRulers() {
        const auto [from, to] = acrossBoard();
        const QImage before = flat().grabPicture()->copy();
        sections().cutAlong({flat().locationAt({-20, -20}), flat().locationAt(to)});
        const QImage after = flat().grabPicture()->copy();
        const QMargins rulers = flat().controller().margins().toMargins();
        QVERIFY(rulers.left() > 0 && rulers.top() > 0);
        const QRect left(0, 0, rulers.left(), before.height());
        const QRect upper(0, 0, before.width(), rulers.top());
        QCOMPARE(differingPixels(before.copy(left), after.copy(left)), 0);
        QCOMPARE(differingPixels(before.copy(upper), after.copy(upper)), 0);
        QVERIFY(differingPixels(before, after) > 300);
    }

    /// As a line along a net has them when all of it is in sight: circles side by side would cover the net.
    void cornersCloseTogetherHaveOneHandle() {
        const auto [from, to] = acrossBoard();
        const auto along = [&, from = from](double pixels) { return flat().locationAt(from + QPointF(pixels, 0)); };
        const auto lineWith = [&, to = to](std::vector<double> corners) {
            std::vector<PointD> line{along(0)};
            for (const double pixels : corners) {
                line.push_back(along(pixels));
            }
            line.push_back(flat().locationAt(to));
            return line;
        };
        sections().cutAlong(lineWith({}));
        const QImage straight = flat().grabPicture()->copy();
        const std::vector<PointD> crowded = lineWith({12.0, 14.0, 16.0});
        sections().cutAlong(crowded);
        QCOMPARE(differingPixels(straight, *flat().grabPicture()), 0);
        sections().cutAlong(lineWith({60.0}));
        QVERIFY(differingPixels(straight, *flat().grabPicture()) > 20);

        sections().cutAlong(crowded);
        const auto drag = [&](QPointF at) {
            mouse(QEvent::MouseButtonPress, at);
            mouse(QEvent::MouseMove, at + QPointF(0, 30));
            mouse(QEvent::MouseButtonRelease, at + QPointF(0, 30));
        };
        drag(from + QPointF(14, 0));  // what is not to be seen cannot be taken
        QVERIFY(std::ranges::equal(window().find<ui::SectionLine>().line(), crowded, isAt));
        flat().controller().zoomAt(from, 20.0F);
        drag(*flat().screenOf(crowded[2]));
        const std::vector<PointD>& moved = window().find<ui::SectionLine>().line();
        QVERIFY(isAt(moved[1], crowded[1]) && !isAt(moved[2], crowded[2]) && isAt(moved[3], crowded[3]));
    }

    void aLineBesideTheBoardIsTold() {
        const model::Box& board = m_index->board->board;
        const double x = board.max.x + 5e6;
        sections().cutAlong({{x, 0}, {x, 1e6}});
        QVERIFY(view().section()->pieces.empty());
        QVERIFY(window().find<ui::SectionPanel>().notes().contains("meets nothing"));
        sections().cutAlong({{2e9, 0}, {2e9, 1e6}});
        QVERIFY(!view().section());
        QVERIFY(window().find<ui::SectionPanel>().notes().contains("coordinates"));
    }

    /// Nothing that is seen would take it away.
    void closingThePanelHidesTheLine() {
        drawLine();
        const auto line = window().find<ui::SectionLine>().line();
        QWidget& dock = *window().find<ui::SectionPanel>().parentWidget();
        const auto isMovedByItsEnd = [&] {
            const QPointF end = acrossBoard().second;
            mouse(QEvent::MouseButtonPress, end);
            mouse(QEvent::MouseMove, end - QPointF(30, 0));
            mouse(QEvent::MouseButtonRelease, end - QPointF(30, 0));
            return !std::ranges::equal(window().find<ui::SectionLine>().line(), line, isAt);
        };
        dock.close();
        QVERIFY(!isMovedByItsEnd());
        dock.show();
        QVERIFY(isMovedByItsEnd());
        sections().draw(true);
        dock.close();
        const auto [from, to] = acrossBoard();
        mouse(QEvent::MouseButtonPress, from);
        mouse(QEvent::MouseMove, to);
        mouse(QEvent::MouseButtonRelease, to);
        QVERIFY2(!window().find<ui::SectionLine>().isDrawing(), "a line that is asked for is drawn");
        dock.show();
    }

private:
    void clickOn(QPointF at) {
        mouse(QEvent::MouseButtonPress, at);
        mouse(QEvent::MouseButtonRelease, at);
    }
    void hover(QPointF at) {
        QMouseEvent event(QEvent::MouseMove, at, flat().mapToGlobal(at), Qt::NoButton, Qt::NoButton, {});
        QCoreApplication::sendEvent(&flat().canvas(), &event);
    }
    /// As a command, if nothing over the view takes it.
    void typeKey(Qt::Key key) {
        if (auto* native = qobject_cast<QWindow*>(&flat().canvas())) {
            QTest::keyClick(native, key);
        } else {
            QTest::keyClick(qobject_cast<QWidget*>(&flat().canvas()), key);
        }
    }
    void pressKey(Qt::Key key) {
        QKeyEvent event(QEvent::KeyPress, key, {});
        QCoreApplication::sendEvent(&flat().canvas(), &event);
    }
};

QTEST_MAIN(SectionLineTest)
#include "section_line_test.moc"
