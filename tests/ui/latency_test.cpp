// From what the hand does to what the eye sees. Times are told, not judged: machines differ. They are of the sample
// board, or of the one that COPPERSCOPE_LATENCY_BOARD names; who names one wants figures, and has each thing done more
// often.

#include <QElapsedTimer>
#include <QMouseEvent>
#include <QSignalSpy>
#include <QSlider>
#include <QtTest>
#include <algorithm>
#include <optional>

#include "model/board/single_element.h"
#include "tests/locations.h"
#include "tests/patience.h"
#include "tests/ui/window_fixture.h"

/// When a widget was last painted, to the end.
class PaintClock : public QObject {
public:
    explicit PaintClock(QWidget& widget) { widget.installEventFilter(this); }
    void restart() {
        m_clock.start();
        m_ms.reset();
    }
    [[nodiscard]] std::optional<double> painted() const { return m_ms; }
    [[nodiscard]] double now() const { return static_cast<double>(m_clock.nsecsElapsed()) / 1e6; }

    bool eventFilter(QObject* watched, QEvent* event) override {
        if (event->type() != QEvent::Paint) {
            return false;
        }
        watched->event(event);
        m_ms = now();
        return true;
    }

private:
    QElapsedTimer m_clock;
    std::optional<double> m_ms;
};

class LatencyTest : public QObject {
    Q_OBJECT

private slots:
    void initTestCase() {
        m_fixture = std::make_unique<WindowFixture>();
        const QString named = qEnvironmentVariable("COPPERSCOPE_LATENCY_BOARD");
        m_repeats = named.isEmpty() ? 3 : 8;
        QVERIFY(m_fixture->openAndWait(named.isEmpty() ? QString(locations::kSample) : named));
        settle();
    }
    void cleanupTestCase() { QCOMPARE(validationErrorsOnClosing(m_fixture), 0U); }

    void picking() {
        for (ui::BoardView* view : views().both()) {
            std::vector<double> times;
            std::size_t hits = 0;
            for (int i = 0; i < 100; ++i) {
                const QPointF at(view->width() * (0.05 + 0.1 * (i % 10)), view->height() * (0.05 + 0.1 * (i / 10)));
                QElapsedTimer clock;
                clock.start();
                hits += window().probing().hitsAt(*view, at).size();
                times.push_back(static_cast<double>(clock.nsecsElapsed()) / 1e6);
            }
            QVERIFY(hits > 0);
            tell(view->kind() == ui::BoardView::Kind::Flat ? "pick in 2D" : "pick in 3D", times);
        }
    }

    void hovering() {
        measure("hover", [this](int i) {
            const std::size_t count = window().document()->elements.size();
            window().selection().hover(
                model::BoardElement{0, model::ElementId{count * static_cast<std::size_t>(i) / 10}});
        });
    }

    void selecting() {
        measure("select", [this](int i) {
            const std::size_t count = window().document()->elements.size();
            window().selection().select({{0, model::ElementId{count * static_cast<std::size_t>(i) / 10}}});
        });
    }

    void theLargestPlane() {
        const model::ElementId plane = largestPlane();
        const auto at = [plane](int i) {
            return i % 2 == 0 ? std::optional(model::BoardElement{0, plane}) : std::nullopt;
        };
        const std::size_t nodes = model::nodeCountOf(*window().document(), plane);
        measure(qPrintable(QString("hover a plane of %1 nodes").arg(nodes)),
                [&](int i) { window().selection().hover(at(i)); });
        measure(qPrintable(QString("select a plane of %1 nodes").arg(nodes)), [&](int i) {
            window().selection().select(at(i) ? std::vector{*at(i)} : std::vector<model::BoardElement>{});
        });
    }

    void theLargestNetIsLitWithoutItsGeometryBeingSentAgain() {
        const model::NetId largest = largestNet();
        const std::size_t count = window().document()->elementsOf(largest).size();
        QVERIFY(count > 1);
        const render::BoardScene* scene = views().scene();
        const std::uint64_t onDevice = scene->gpuBytes();
        measure(qPrintable(QString("light a net of %1 elements").arg(count)), [&](int i) {
            window().selection().setNets(i % 2 == 0 ? std::vector{model::BoardNet{0, largest}}
                                                    : std::vector<model::BoardNet>{});
        });
        QCOMPARE(views().scene(), scene);
        QCOMPARE(scene->gpuBytes(), onDevice);
    }

    /// From a move of the mouse to the section in its panel and the line over the 2D view.
    void draggingASection() {
        window().actions()[ui::ActionId::DrawSection].trigger();  // brings the panel to the front
        window().actions()[ui::ActionId::DrawSection].trigger();
        const model::Box box = window().document()->board;
        window().sections().cutAlong({base::toDouble(box.min), base::toDouble(box.max)});  // aslant: the most to cut
        settle();
        QPointF at = *views().flat().controller().screenOf(
            window().probing().position().toModel(window().find<ui::SectionLine>().line().back()));
        PaintClock panel(window().find<ui::SectionPanel>().view());
        std::optional<double> flat;
        const auto connection =
            connect(&views().flat(), &ui::BoardView::drawn, this, [&] { flat = flat.value_or(panel.now()); });
        send(QEvent::MouseButtonPress, at);
        std::vector<double> inPanel;
        std::vector<double> overBoard;
        for (int i = 0; i < 40; ++i) {
            at += QPointF(-2, i % 2 == 0 ? 3 : -2);
            panel.restart();
            flat.reset();
            send(QEvent::MouseMove, at);
            while ((!panel.painted() || !flat) && panel.now() < 20e3) {
                QCoreApplication::processEvents(QEventLoop::WaitForMoreEvents, 20);
            }
            QVERIFY(panel.painted() && flat);
            inPanel.push_back(*panel.painted());
            overBoard.push_back(*flat);
        }
        send(QEvent::MouseButtonRelease, at);
        disconnect(connection);
        const std::size_t pieces = window().find<ui::SectionPanel>().view().section()->pieces.size();
        tell(qPrintable(QString("drag a section of %1 pieces, until its panel is painted").arg(pieces)), inPanel);
        tell("drag a section, until the line is drawn over the 2D view", overBoard);
        window().sections().cutAlong({});
    }

    /// Of the lens: the list that is cut, the gaps over the 2D view, and what else is lit in both.
    void theLensFollowsItsSlider() {
        const model::NetId net = largestNet();
        const model::ElementId pad = window().document()->elementsOf(net).front();
        ui::Lens& lens = window().find<ui::Lens>();
        for (const bool isPad : {true, false}) {
            window().selection().select(isPad ? std::vector{model::BoardElement{0, pad}}
                                              : std::vector<model::BoardElement>{});
            window().selection().setNets(isPad ? std::vector<model::BoardNet>{} : std::vector{model::BoardNet{0, net}});
            settle();
            QElapsedTimer clock;
            clock.start();
            lens.setOn(true);
            while (lens.isSearching() && clock.elapsed() < 60000) {
                QCoreApplication::processEvents(QEventLoop::AllEvents, 1);
            }
            const QString what = QString("lens of %1").arg(isPad ? "an element" : "the largest net");
            tell(qPrintable(what + ", until all within 1 mm is found"),
                 {static_cast<double>(clock.nsecsElapsed()) / 1e6});
            settle();
            QSlider& slider = *window().panel("clearances").findChild<QSlider*>("lensReach");
            slider.setValue(slider.minimum());
            settle();
            measureFlat(what, [&](int i) { slider.setValue(40 + 20 * i); });
            lens.setOn(false);
            settle();
        }
        window().selection().setNets({});
    }

    void theDistanceMapFollowsItsSlider() {
        ui::ClearanceMapOverlay& distances = window().find<ui::ClearanceMapOverlay>();
        const auto hasAll = [&] {
            return distances.field() != nullptr && !distances.isPending() &&
                   distances.picture(ui::BoardView::Kind::Flat).map() != nullptr &&
                   distances.picture(ui::BoardView::Kind::Solid).map() != nullptr;
        };
        settle();
        QElapsedTimer clock;
        clock.start();
        distances.setOn(true);
        QTRY_VERIFY(hasAll());
        tell("distance map of both views", {static_cast<double>(clock.nsecsElapsed()) / 1e6});
        settle();
        measure("distance map, another range",
                [&](int i) { window().panel("clearances").findChild<QSlider*>("mapReach")->setValue(8 + 2 * i); });
        window().selection().setNets({{0, largestNet()}});
        clock.start();
        QTRY_VERIFY(hasAll());
        tell("distance map to the largest net", {static_cast<double>(clock.nsecsElapsed()) / 1e6});
        distances.setOn(false);
    }

private:
    void send(QEvent::Type type, QPointF at) {
        const bool isMove = type == QEvent::MouseMove;
        QMouseEvent event(type, at, views().flat().mapToGlobal(at), isMove ? Qt::NoButton : Qt::LeftButton,
                          type == QEvent::MouseButtonRelease ? Qt::NoButton : Qt::LeftButton, {});
        QCoreApplication::sendEvent(&views().flat().canvas(), &event);
    }

    TestWindow& window() { return m_fixture->window(); }
    ui::BoardViews& views() { return window().views(); }

    model::NetId largestNet() {
        const model::Document& board = *window().document();
        model::NetId largest{std::size_t{0}};
        for (std::size_t row = 0; row < board.nets.size(); ++row) {
            const model::NetId net{row};
            largest = board.elementsOf(net).size() > board.elementsOf(largest).size() ? net : largest;
        }
        return largest;
    }

    /// The element of most nodes.
    model::ElementId largestPlane() {
        const model::Document& board = *window().document();
        std::size_t largest = 0;
        for (std::size_t row = 0; row < board.elements.size(); ++row) {
            largest =
                model::nodeCountOf(board, model::ElementId{row}) > model::nodeCountOf(board, model::ElementId{largest})
                    ? row
                    : largest;
        }
        return model::ElementId{largest};
    }

    /// All frames that were asked for are drawn.
    void settle() {
        QTest::qWait(400);
        for (ui::BoardView* view : views().both()) {
            view->requestOverlay();
            QSignalSpy timed(view, &ui::BoardView::timed);
            QVERIFY(timed.wait(kPatienceMs));
        }
    }

    /// Answers are what the painters show of it in both views; then the board follows.
    template <class Act>
    void measure(const char* what, const Act& act) {
        std::vector<double> asked;
        std::vector<double> answered;
        for (int i = 0; i < m_repeats; ++i) {
            const QSignalSpy flat(&views().flat(), &ui::BoardView::drawn);
            const QSignalSpy solid(&views().solid(), &ui::BoardView::drawn);
            QElapsedTimer clock;
            clock.start();
            act(i);
            asked.push_back(static_cast<double>(clock.nsecsElapsed()) / 1e6);
            while ((flat.isEmpty() || solid.isEmpty()) && clock.elapsed() < kPatienceMs) {
                QCoreApplication::processEvents(QEventLoop::AllEvents, 1);
            }
            QVERIFY(!flat.isEmpty() && !solid.isEmpty());
            answered.push_back(static_cast<double>(clock.nsecsElapsed()) / 1e6);
            settle();
        }
        tell(qPrintable(QString("%1, until frames are asked for").arg(what)), asked);
        tell(qPrintable(QString("%1, until both views have drawn").arg(what)), answered);
    }

    /// Of what may leave the 3D view as it is.
    template <class Act>
    void measureFlat(const QString& what, const Act& act) {
        std::vector<double> asked;
        std::vector<double> drawn;
        for (int i = 0; i < m_repeats; ++i) {
            QSignalSpy flat(&views().flat(), &ui::BoardView::drawn);
            QElapsedTimer clock;
            clock.start();
            act(i);
            asked.push_back(static_cast<double>(clock.nsecsElapsed()) / 1e6);
            while (flat.isEmpty() && clock.elapsed() < 20000) {
                QCoreApplication::processEvents(QEventLoop::WaitForMoreEvents, 20);
            }
            QVERIFY(!flat.isEmpty());
            drawn.push_back(static_cast<double>(clock.nsecsElapsed()) / 1e6);
            settle();
        }
        tell(qPrintable(what + ", until frames are asked for"), asked);
        tell(qPrintable(what + ", until the 2D view has drawn"), drawn);
    }

    static void tell(const char* what, std::vector<double> ms) {
        std::ranges::sort(ms);
        qInfo().noquote() << QString("%1: median %2 ms, most %3 ms")
                                 .arg(what)
                                 .arg(ms[ms.size() / 2], 0, 'f', 2)
                                 .arg(ms.back(), 0, 'f', 2);
    }

    std::unique_ptr<WindowFixture> m_fixture;
    int m_repeats = 0;
};

QTEST_MAIN(LatencyTest)
#include "latency_test.moc"
