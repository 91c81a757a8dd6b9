// The distance map over both views, driven by keys, the slider and the mouse.
#include <QSignalSpy>
#include <QSlider>
#include <QWheelEvent>
#include <QtTest>
#include <filesystem>
#include <fstream>
#include <set>

#include "render/scene/colour_ramp.h"
#include "tests/locations.h"
#include "tests/patience.h"
#include "tests/ui/window_fixture.h"
#include "ui/clearance/clearance_feature.h"
#include "ui/layers/layers_panel.h"

using model::ClearanceMap;
using model::DistanceField;
using model::LayerId;
using ui::ActionId;
using ui::BoardView;

class DistancesTest : public QObject {
    Q_OBJECT

private slots:
    void initTestCase() {
        m_fixture = std::make_unique<WindowFixture>();
        m_fixture->window().resize(1250, 950);
        QVERIFY(m_fixture->openAndWait(locations::kSample));
        window().showPanel("clearances");  // the map would open it, and so make the views smaller
        QTest::qWait(50);
    }
    void init() {
        while (window().selection().clearStep()) {
        }
        window().layers().restoreDefaults();
        window().layersPanel().table().clearSelection();
        window().workspace().setCurrentLayer({});
        slider().setValue(m_slider);
        views().flat().controller().look(render::NamedView::Top);
        views().solid().controller().look(render::NamedView::Iso);
        for (BoardView* view : views().both()) {
            view->controller().fit();
        }
        if (distances().isOn()) {
            window().actions()[ActionId::ClearanceMap].trigger();
        }
        QTRY_VERIFY(distances().field() == nullptr && !distances().isPending());
    }
    void cleanupTestCase() { QCOMPARE(validationErrorsOnClosing(m_fixture), 0U); }

    void theKeyShowsItAndTakesItAway() {
        const QImage without[2] = {grab(views().flat()), grab(views().solid())};
        m_fixture->key(Qt::Key_G, Qt::ShiftModifier);
        waitForMaps();
        QVERIFY(window().actions()[ActionId::ClearanceMap].isChecked());
        QCOMPARE(distances().field()->kind(), DistanceField::Kind::BetweenNets);
        QVERIFY2(text().contains("spacing between nets"), qPrintable(text()));
        QVERIFY(differingPixels(without[0], grab(views().flat())) > 500);
        QVERIFY(differingPixels(without[1], grab(views().solid())) > 500);
        m_fixture->key(Qt::Key_G, Qt::ShiftModifier);
        QTRY_VERIFY(distances().field() == nullptr);
        QCOMPARE(differingPixels(without[0], grab(views().flat())), 0);
        QCOMPARE(text(), QString());
    }

    /// Both at once, without a hand that moves one of them.
    void whatIsOnTheScreenLosesTheMapToo() {
        window().actions()[ActionId::ShowViewCube].trigger();  // it is on the screen and not in pictures
        for (BoardView* view : views().both()) {               // refined, also by a slow device
            const QImage whole = grab(*view);
            QTRY_VERIFY(differingPixels(whole, shown(*view)) < whole.width() * 4);
        }
        const QImage without[2] = {shown(views().flat()), shown(views().solid())};
        m_fixture->key(Qt::Key_G, Qt::ShiftModifier);
        waitForMaps();
        QTRY_VERIFY(differingPixels(without[0], shown(views().flat())) > 500);
        QTRY_VERIFY(differingPixels(without[1], shown(views().solid())) > 500);
        m_fixture->key(Qt::Key_G, Qt::ShiftModifier);
        QTRY_COMPARE(differingPixels(without[0], shown(views().flat())), 0);
        QTRY_COMPARE(differingPixels(without[1], shown(views().solid())), 0);
        window().actions()[ActionId::ShowViewCube].trigger();
    }

    void thePanelOpensWithTheMapOnly() {
        auto* panel = window().findChild<QDockWidget*>("clearances");
        panel->hide();
        m_fixture->key(Qt::Key_G, Qt::ShiftModifier);
        QTRY_VERIFY(panel->isVisible());
        panel->hide();
        m_fixture->key(Qt::Key_G, Qt::ShiftModifier);
        QTRY_VERIFY(distances().field() == nullptr);
        QVERIFY(panel->isHidden());
        window().showPanel("clearances");
    }

    void everyValueIsPaintedInItsColourAtItsPlace() {
        switchOn();
        slider().setValue(slider().maximum());
        // From below, isometric and in parallel too: colours stay where they belong.
        views().flat().controller().look(render::NamedView::Bottom);
        for (BoardView* view : views().both()) {
            view->controller().zoomAtCentre(4.0F);
        }
        QTRY_COMPARE(distances().field() == nullptr ? LayerId{} : distances().field()->layer(), copperLayers().back());
        waitForMaps();
        compareColours(views().flat(), 0.9);
        views().solid().controller().look(render::NamedView::Bottom);
        window().actions()[ActionId::Orthographic].trigger();
        waitForMaps();
        compareColours(views().solid(), 0.8);
        window().actions()[ActionId::Orthographic].trigger();
        waitForMaps();
        compareColours(views().solid(), 0.8);
    }

    /// The map of the bottom is not seen from above, as long as the board is in between.
    void whatLiesAboveHidesTheMapIn3d() {
        views().flat().controller().look(render::NamedView::Bottom);
        views().solid().controller().zoomAtCentre(4.0F);
        const QImage without = grab(views().solid());
        switchOn();
        QTRY_COMPARE(distances().field() == nullptr ? LayerId{} : distances().field()->layer(), copperLayers().back());
        waitForMaps();
        slider().setValue(slider().maximum());
        const auto changed = [&] { return differingPixels(without, grab(views().solid())); };
        const int legend = changed();
        window().layers().toggleSolo(copperLayers().back());
        waitForMaps();
        compareColours(views().solid(), 0.8);
        window().layers().toggleSolo({});
        waitForMaps();
        QCOMPARE(changed(), legend);
        const QImage covered = grab(views().solid());
        std::size_t shown = 0;
        const auto locations = coloured(views().solid());
        for (const auto& [at, value] : locations) {
            const QPoint pixel = (at * views().solid().devicePixelRatioF()).toPoint();
            shown += covered.pixelColor(pixel) == without.pixelColor(pixel) ? 0 : 1;
        }
        QVERIFY(locations.size() > 30);
        QVERIFY2(20 * shown < locations.size(), qPrintable(QString("%1 of %2").arg(shown).arg(locations.size())));
    }

    void theSelectionIsMeasuredTo() {
        switchOn();
        const model::Document& board = *window().document();
        const model::ElementId target = someCopper(distances().field()->layer());
        window().selection().select({{0, target}});
        QTRY_VERIFY(distances().field() != nullptr && distances().field()->kind() == DistanceField::Kind::ToTargets);
        waitForMaps();
        QVERIFY2(text().endsWith("distance to the selection"), qPrintable(text()));
        const model::Box box = board.boxOf(target);
        const base::PointD beside{box.max.x + 400'000.0, (double{1} * box.min.y + box.max.y) / 2};
        QVERIFY(distances().field()->at(beside, 1e6) >= 400'000.0 - 1.0);

        const model::NetId net = board.elements.net[target.row()];
        window().selection().select({});
        window().selection().setNets({{0, net}});
        QTRY_VERIFY(text().endsWith("distance to " + QString::fromStdString(board.nets[net.row()].name)));
        waitForMaps();
        m_fixture->key(Qt::Key_Escape);
        QTRY_VERIFY(distances().field() != nullptr && distances().field()->kind() == DistanceField::Kind::BetweenNets);
        waitForMaps();
    }

    void theLayerIsTheCurrentOneOrTheNearestToBeSeen() {
        switchOn();
        const std::vector<LayerId> copper = copperLayers();
        QCOMPARE(distances().field()->layer(), copper.front());
        m_fixture->key(Qt::Key_B);  // the 3D view's
        views().flat().controller().look(render::NamedView::Bottom);
        QTRY_VERIFY(distances().field() != nullptr && distances().field()->layer() == copper.back());
        waitForMaps();
        window().layersPanel().select(copper[1]);
        QTRY_VERIFY(distances().field() != nullptr && distances().field()->layer() == copper[1]);
        window().layersPanel().select(model::LayerId{std::size_t{0}});  // no copper
        window().layers().toggleSolo(copper.front());
        QTRY_VERIFY(distances().field() != nullptr && distances().field()->layer() == copper.front());
        window().layers().toggleSolo({});
        window().layersPanel().select(model::LayerId{std::size_t{0}});
        window().layers().hideAll();
        QTRY_COMPARE(text(), "show a copper layer");
        QVERIFY(distances().field() == nullptr);
    }

    void whatCannotBeMappedIsTold() {
        switchOn();
        const std::vector<LayerId> copper = copperLayers();
        window().selection().select({{0, someCopper(copper.back())}});
        QTRY_VERIFY2(text().startsWith("the selection has no copper on"), qPrintable(text()));
        QVERIFY(distances().field() == nullptr);
        QTRY_VERIFY(!distances().isPending());
    }

    void theSliderOnlyColoursAnew() {
        switchOn();
        const ClearanceMap* map = distances().picture(BoardView::Kind::Flat).map();
        const float* values = map->nm.data();
        slider().setFocus();
        std::set<int> painted;
        for (int i = 0; i < 5; ++i) {
            const double before = panel().mapReach();
            const QImage last = grab(views().flat());
            QTest::keyClick(&slider(), Qt::Key_PageUp);
            QVERIFY(panel().mapReach() > before);
            QVERIFY(!distances().isPending());
            QVERIFY(differingPixels(last, grab(views().flat())) > 20);
            QCOMPARE(distances().legend().numbers().back(), panel().mapReach());
        }
        QCOMPARE(distances().picture(BoardView::Kind::Flat).map()->nm.data(), values);
    }

    void aMovedViewKeepsItsPictureUntilItRests() {
        views().flat().controller().zoomAtCentre(2.7F);
        switchOn();
        slider().setValue(slider().maximum());
        ui::ClearanceMapPicture& picture = distances().picture(BoardView::Kind::Flat);
        const model::MapFrame before = picture.map()->frame;
        const QPoint at(views().flat().width() / 2, views().flat().height() / 2);
        QWheelEvent wheel(at, views().flat().mapToGlobal(at), {}, {0, 360}, Qt::NoButton, Qt::NoModifier,
                          Qt::NoScrollPhase, false);
        QCoreApplication::sendEvent(&views().flat().canvas(), &wheel);
        QVERIFY(picture.map() != nullptr);
        QVERIFY(picture.map()->frame == before);
        compareColours(views().flat(), 0.6);  // scaled: close to edges it may be a pixel beside
        QVERIFY(!(picture.map()->frame == picture.shownFrame()));
        waitForMaps();
        QVERIFY(picture.map()->frame.cell < before.cell / 1.5);
        compareColours(views().flat(), 0.8);
    }

    void theCursorTellsTheValueInTheStatusLine() {
        switchOn();
        slider().setValue(slider().maximum());
        const auto [at, value] = coloured(views().flat()).front();
        QTest::qWait(20);
        emit views().flat().controller().hovered(at);
        QTRY_VERIFY2(window().label("position").contains("spacing "), qPrintable(window().label("position")));
        QVERIFY(distances().legend().mark.has_value());
        QVERIFY(std::abs(*distances().legend().mark - value) <
                2.0 * distances().picture(BoardView::Kind::Flat).map()->frame.cell);
        window().actions()[ActionId::NextUnit].trigger();
        QVERIFY2(window().label("position").contains(" mil   spacing "), qPrintable(window().label("position")));
        window().actions()[ActionId::NextUnit].trigger();
        window().actions()[ActionId::NextUnit].trigger();
    }

    void theLegendHasRoundNumbersAndTheEnd() {
        ui::ClearanceMapLegend legend;
        for (const double reach : {20e3, 150e3, 500e3, 1.25e6, 10e6}) {
            for (const auto unit : {ui::LengthUnit::Millimetre, ui::LengthUnit::Mil}) {
                legend.reach = reach;
                legend.unit = unit;
                const std::vector<double> numbers = legend.numbers();
                QVERIFY(numbers.size() >= 3 && numbers.size() <= 7);
                QCOMPARE(numbers.front(), 0.0);
                QCOMPARE(numbers.back(), reach);
                QVERIFY(std::ranges::is_sorted(numbers));
            }
        }
    }

    /// Turned and flipped copies too, in both views; and what is not measured is said.
    void everyCopyOnAPanelIsMapped() {
        const std::filesystem::path job = m_fixture->copyOfJob("panel");
        std::ofstream(job / "steps/card/layers/top/features")
            << "UNITS=MM\n$0 r300\nL 1 1 9 1 0 P 0\nL 1 2 9 2 0 P 0\n";
        std::ofstream(job / "steps/card/eda/data") << "UNITS=MM\nLYR top bottom\nNET A\nFID C 0 0\nNET B\nFID C 0 1\n";
        QVERIFY(m_fixture->openAndWait(QString::fromStdString(job.string())));
        switchOn();
        slider().setValue(slider().maximum());
        QVERIFY2(text().endsWith("; clearances across copies of steps are not measured"), qPrintable(text()));
        const model::StepTree tree = model::unfoldCopies(*window().document());
        const LayerId top = distances().field()->layer();
        std::size_t upright = 0;
        for (const model::StepCopy& copy : tree.copies) {
            if (tree.steps[copy.step]->job.step == "CARD" || tree.steps[copy.step]->job.step == "card") {
                const double value = distances().field()->at(copy.placement.apply(base::PointD{3e6, 1.5e6}), 10e6);
                QCOMPARE(value < 10e6, !copy.isFlipped);  // the tracks of a flipped one lie on the other side
                QVERIFY(copy.isFlipped || std::abs(value - 0.7e6) < 1.0);
                upright += copy.isFlipped ? 0 : 1;
                if (!copy.isFlipped) {
                    window().probing().showPosition(copy.placement.apply(base::PointD{3e6, 1.5e6}), top, 1.5F);
                    waitForMaps();
                    compareColours(views().flat(), 0.8);
                }
            }
        }
        QVERIFY(upright >= 3);
        QVERIFY(m_fixture->openAndWait(locations::kSample));
    }

    /// The panel itself has no nets; those of its copies are named by their step.
    void aNetOfCopiesIsNamed() {
        QVERIFY(m_fixture->openAndWait(QString::fromStdString(m_fixture->copyOfJob("panel").string())));
        QVERIFY(window().document()->nets.empty());
        const model::StepTree& tree = window().selection().tree();
        const auto step = std::ranges::find_if(tree.steps, [](const auto& one) { return !one->nets.empty(); });
        QVERIFY(step != tree.steps.end());
        const auto& nets = (*step)->nets;
        const auto net = std::ranges::find(nets, "A", &model::Net::name);
        QVERIFY(net != nets.end());
        window().selection().setNets({{static_cast<std::uint32_t>(step - tree.steps.begin()),
                                       model::NetId{static_cast<std::size_t>(net - nets.begin())}}});
        m_fixture->key(Qt::Key_G, Qt::ShiftModifier);
        QTRY_VERIFY2(text().contains("distance to A"), qPrintable(text()));
        QVERIFY(m_fixture->openAndWait(locations::kSample));
    }

    void aReloadMapsTheBoardAnew() {
        switchOn();
        QVERIFY(m_fixture->openAndWait(locations::kSample));
        QVERIFY(distances().isOn());
        waitForMaps();
        m_fixture->key(Qt::Key_G, Qt::ShiftModifier);  // off, and on again while the board is read
        window().open(locations::kSample);
        m_fixture->key(Qt::Key_G, Qt::ShiftModifier);
        QTRY_VERIFY(!window().loader().isLoading());
        waitForMaps();
    }

private:
    TestWindow& window() { return m_fixture->window(); }
    ui::BoardViews& views() { return window().views(); }
    ui::ClearanceMapOverlay& distances() { return window().find<ui::ClearanceMapOverlay>(); }
    ui::ClearancePanel& panel() { return window().find<ui::ClearancePanel>(); }
    QSlider& slider() { return *panel().findChild<QSlider*>("mapReach"); }
    QString text() { return panel().findChild<QLabel*>("map")->text(); }
    QImage grab(BoardView& view) { return view.grabPicture()->convertToFormat(QImage::Format_RGB32); }

    /// What is on the screen, which waits for no device as `grab` does.
    QImage shown(BoardView& view) {
        auto* canvas = qobject_cast<QWidget*>(&view.canvas());
        return canvas != nullptr ? canvas->grab().toImage().convertToFormat(QImage::Format_RGB32) : grab(view);
    }

    void switchOn() {
        m_fixture->key(Qt::Key_G, Qt::ShiftModifier);
        waitForMaps();
    }

    /// Both views show what they are to show.
    void waitForMaps() {
        const auto isDone = [this](BoardView::Kind kind) {
            const ui::ClearanceMapPicture& picture = distances().picture(kind);
            return picture.map() != nullptr && picture.shownFrame() == picture.map()->frame;
        };
        QTRY_VERIFY(distances().field() != nullptr && !distances().isPending() && isDone(BoardView::Kind::Flat) &&
                    isDone(BoardView::Kind::Solid));
    }

    std::vector<LayerId> copperLayers() {
        std::vector<LayerId> copper;
        for (std::size_t row = 0; row < window().document()->layers.size(); ++row) {
            if (window().document()->layers[row].isCopper()) {
                copper.emplace_back(row);
            }
        }
        return copper;
    }

    model::ElementId someCopper(LayerId layer) {
        const model::Document& board = *window().document();
        const auto [first, count] = board.layer(layer).elements;
        for (std::uint32_t i = first; i < first + count; ++i) {
            if (board.elements.net[i].isValid() && board.elements.kind[i] == model::ElementKind::Circle) {
                return model::ElementId{i};
            }
        }
        return model::ElementId{first};
    }

    /// Cells amid others of nearly the same value that fall on the canvas: where, and their values.
    std::vector<std::pair<QPointF, double>> coloured(BoardView& view) {
        const double reach = panel().mapReach();
        const ClearanceMap& map = *distances().picture(view.kind()).map();
        const float z = view.drawnHeights()[distances().field()->layer().row()].z1;
        const float zBelow = view.drawnHeights()[distances().field()->layer().row()].z0;
        const bool isFromBelow = view.controller().camera().direction().z > 0.0F;
        const QRectF canvas(24, 100, view.width() - 30, view.height() - 110);  // beside rulers and the view cube
        const QRectF legend(view.width() - 190, view.height() - 200, 190, 200);
        std::vector<std::pair<QPointF, double>> locations;
        const std::uint32_t width = map.frame.width;
        for (std::uint32_t row = 2; row + 2 < map.frame.height; row += 3) {
            for (std::uint32_t column = 2; column + 2 < width; column += 3) {
                const auto value = [&](std::uint32_t x, std::uint32_t y) {
                    return double{map.nm[std::size_t{y} * width + x]};
                };
                bool isEven = true;
                for (std::uint32_t y = row - 2; y <= row + 2; ++y) {
                    for (std::uint32_t x = column - 2; x <= column + 2; ++x) {
                        isEven = isEven && value(x, y) > 0 && value(x, y) <= reach &&
                                 std::abs(value(x, y) - value(column, row)) < reach / 16;
                    }
                }
                glm::vec3 at = window().probing().position().toModel(map.frame.centreOf(column, row));
                at.z = isFromBelow ? zBelow : z;
                const auto onScreen = view.controller().screenOf(at);
                if (isEven && onScreen && canvas.contains(*onScreen) && !legend.contains(*onScreen)) {
                    locations.emplace_back(*onScreen, value(column, row));
                }
            }
        }
        return locations;
    }

    /// Of those at least the part `least` must be painted in its colour; names and grids hide some.
    void compareColours(BoardView& view, double least) {
        const QImage picture = grab(view);
        const auto locations = coloured(view);
        QVERIFY2(locations.size() > 30, qPrintable(QString::number(locations.size())));
        std::size_t right = 0;
        for (const auto& [at, value] : locations) {
            const QColor found = picture.pixelColor((at * view.devicePixelRatioF()).toPoint());
            const glm::vec3 c = render::rampColour(static_cast<float>(value / panel().mapReach())) * 255.0F;
            const double off = std::max({std::abs(found.red() - double{c.r}), std::abs(found.green() - double{c.g}),
                                         std::abs(found.blue() - double{c.b})});
            right += off < 48.0 ? 1 : 0;
        }
        QVERIFY2(static_cast<double>(right) >= least * static_cast<double>(locations.size()),
                 qPrintable(QString("%1 of %2").arg(right).arg(locations.size())));
    }

    std::unique_ptr<WindowFixture> m_fixture;
    int m_slider = 14;  ///< 0.5 mm
};

QTEST_MAIN(DistancesTest)
#include "clearance_map_overlay_test.moc"
