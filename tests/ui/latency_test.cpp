// From what the hand does to what the eye sees. Times are told, not judged: machines differ. They are of the sample
// board, or of the one that COPPERSCOPE_LATENCY_BOARD names.

#include <QElapsedTimer>
#include <QSignalSpy>
#include <QtTest>
#include <algorithm>

#include "tests/places.h"
#include "tests/ui/window_fixture.h"

class LatencyTest : public QObject {
    Q_OBJECT

private slots:
    void initTestCase() {
        m_fixture = std::make_unique<WindowFixture>();
        const QString named = qEnvironmentVariable("COPPERSCOPE_LATENCY_BOARD");
        QVERIFY(m_fixture->openAndWait(named.isEmpty() ? QString(places::kSample) : named));
        settle();
    }
    void cleanupTestCase() {
        const std::uint32_t errors = m_fixture->context().validationErrors();
        m_fixture.reset();
        QCOMPARE(errors, 0U);
    }

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

private:
    ui::MainWindow& window() { return m_fixture->window(); }
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

    /// All frames that were asked for are drawn.
    void settle() { QTest::qWait(350); }

    template <class Act>
    void measure(const char* what, const Act& act) {
        std::vector<double> asked;
        std::vector<double> drawn;
        for (int i = 0; i < 4; ++i) {
            QSignalSpy flat(&views().flat(), &ui::BoardView::drawn);
            QSignalSpy solid(&views().solid(), &ui::BoardView::drawn);
            QElapsedTimer clock;
            clock.start();
            act(i);
            asked.push_back(static_cast<double>(clock.nsecsElapsed()) / 1e6);
            QTRY_VERIFY_WITH_TIMEOUT(flat.count() > 0 && solid.count() > 0, 20000);
            drawn.push_back(static_cast<double>(clock.nsecsElapsed()) / 1e6);
            settle();
        }
        tell(qPrintable(QString("%1, until frames are asked for").arg(what)), asked);
        tell(qPrintable(QString("%1, until both views have drawn").arg(what)), drawn);
    }

    static void tell(const char* what, std::vector<double> ms) {
        std::ranges::sort(ms);
        qInfo().noquote() << QString("%1: median %2 ms, most %3 ms")
                                 .arg(what)
                                 .arg(ms[ms.size() / 2], 0, 'f', 2)
                                 .arg(ms.back(), 0, 'f', 2);
    }

    std::unique_ptr<WindowFixture> m_fixture;
};

QTEST_MAIN(LatencyTest)
#include "latency_test.moc"
