// What the panel Pins lists of what is selected, and what its rows are good for.

#include <QtTest>
#include <set>

#include "tests/locations.h"
#include "tests/ui/window_fixture.h"
#include "ui/common/net_name.h"
#include "ui/parts/pin_model.h"

using model::BoardElement;
using model::ElementId;
using ui::ActionId;
using ui::PinModel;

class PinsPanelTest : public QObject {
    Q_OBJECT

private slots:
    void init() {
        m_fixture = std::make_unique<WindowFixture>();
        QVERIFY(m_fixture->openAndWait(locations::kSample));
        window().actions()[ActionId::ShowPinsDock].trigger();
        QVERIFY(pins().isVisible());
    }
    void cleanup() { QCOMPARE(validationErrorsOnClosing(m_fixture), 0U); }

    void elementsOfSeveralNetsListThePinsOfAll() {
        const std::vector<BoardElement> elements = elementsOfNoComponent(3);
        QCOMPARE(elements.size(), std::size_t{3});
        window().selection().select(elements);
        std::size_t count = 0;
        for (const BoardElement& at : elements) {
            count += finder().pinsOf(netOf(at)).size();
        }
        QCOMPARE(pins().model()->rowCount(), static_cast<int>(count));
        const QString whose = window().label("pinsOf");
        QVERIFY2(whose.startsWith(QString("3 elements of 3 nets: %L1 pins of ").arg(count)), qPrintable(whose));
        window().selection().select({elements.front()});
        QCOMPARE(pins().model()->rowCount(), static_cast<int>(finder().pinsOf(netOf(elements.front())).size()));
        QVERIFY(window().label("pinsOf").startsWith(ui::netName(*window().document(), netOf(elements.front())) + ": "));
    }

    void tooManyElementsListThePinsOfTheBoardAndSaySo() {
        const std::size_t count = ui::PartPicking::kMostElements + 1;
        QVERIFY(m_fixture->openAndWait(boardWithTracks(count)));
        std::vector<BoardElement> tracks = elementsOfNoComponent(count, false);
        QCOMPARE(tracks.size(), count);
        window().selection().select(tracks);
        QCOMPARE(
            window().label("pinsOf"),
            QString("All 2 pins of the board; too many elements are selected (%L1) to list theirs alone").arg(count));
        QCOMPARE(pins().model()->rowCount(), 2);
        tracks.pop_back();
        window().selection().select(tracks);
        QVERIFY2(window().label("pinsOf").startsWith("A: 1 pin of "), qPrintable(window().label("pinsOf")));
    }

    void theMenuOfARowShowsItsPinItsComponentAndItsNet() {
        const std::vector part{ui::BoardPart{0, component("U1")}};
        window().find<ui::PartPicking>().select(part);
        const int row = rowOnANet();
        QVERIFY(row >= 0);
        const QString name = text(row, PinModel::Pin);
        click(row);
        QVERIFY(window().selection().title().startsWith("Pin " + name));
        const model::NetId net = netOf(*window().selection().current());
        const float before = scale();
        const QList<QAction*> commands = pins().actions();
        QAction& show = **std::ranges::find(commands, QString("show"), &QAction::objectName);
        show.trigger();
        QVERIFY(scale() != before);
        QVERIFY(pins().actions().contains(&command(ActionId::SelectComponent)));
        QVERIFY(pins().actions().contains(&command(ActionId::HighlightNet)));
        command(ActionId::SelectComponent).trigger();
        QCOMPARE(window().find<ui::PartPicking>().wholePart(), std::optional(part.front()));
        click(row);
        command(ActionId::HighlightNet).trigger();
        QCOMPARE(window().selection().nets(), (std::vector<model::BoardNet>{{0, net}}));
    }

    void rowsAreShownWhereViewsFollowTables() {
        window().find<ui::PartPicking>().select(std::vector{ui::BoardPart{0, component("U1")}});
        const float before = scale();
        click(0);
        QCOMPARE(scale(), before);
        command(ActionId::FollowFromTables).trigger();
        QTest::keyClick(&pins(), Qt::Key_Down);
        QVERIFY(window().selection().title().startsWith("Pin " + text(1, PinModel::Pin)));
        QVERIFY(scale() != before);
    }

private:
    TestWindow& window() { return m_fixture->window(); }
    ui::TableView& pins() { return window().table("pins"); }
    QAction& command(ActionId id) { return window().actions()[id]; }
    const model::PinFinder& finder() { return window().find<ui::PartPicking>().finderOf(0); }
    float scale() { return window().views().flat().controller().mmPerPixel(); }
    QString text(int row, int column) { return pins().model()->index(row, column).data().toString(); }
    model::NetId netOf(const BoardElement& at) { return window().document()->elements.net[at.element.row()]; }

    model::ComponentId component(const char* refdes) {
        const auto& all = window().document()->components;
        return model::ComponentId{
            static_cast<std::size_t>(std::ranges::find(all, refdes, &model::Component::refdes) - all.begin())};
    }
    /// Tracks of the net A, which has a pin, and a pin on no net.
    QString boardWithTracks(std::size_t count) {
        constexpr std::size_t kInRow = 400;
        QByteArray tracks;
        for (std::size_t i = 0; i < count; ++i) {
            const double x = 0.5 * static_cast<double>(i % kInRow);
            const double y = 0.5 * static_cast<double>(i / kInRow);
            tracks += QString("(segment (start %1 %2) (end %3 %2) (width 0.1) (layer \"F.Cu\") (net 1))\n")
                          .arg(x)
                          .arg(y)
                          .arg(x + 0.25)
                          .toUtf8();
        }
        const QString path = m_fixture->folder() + "/tracks.kicad_pcb";
        QFile file(path);
        if (file.open(QFile::WriteOnly)) {
            file.write(
                "(kicad_pcb (version 20241229) (generator \"pcbnew\") (layers (0 \"F.Cu\" signal) (2 \"B.Cu\" signal)) "
                "(net 1 \"A\") (footprint \"R\" (layer \"F.Cu\") (at -9 -9) (property \"Reference\" \"R1\") (attr smd) "
                "(pad \"1\" smd rect (at 0 0) (size 1 1) (layers \"F.Cu\") (net 1 \"A\")) "
                "(pad \"2\" smd rect (at 3 0) (size 1 1) (layers \"F.Cu\")))\n" +
                tracks + ")");
        }
        return path;
    }
    /// With `areOfOthers` each of another net. All of these nets have pins.
    std::vector<BoardElement> elementsOfNoComponent(std::size_t most, bool areOfOthers = true) {
        std::vector<BoardElement> found;
        std::set<model::NetId> nets;
        for (std::size_t row = 0; row < window().document()->elements.size() && found.size() < most; ++row) {
            const BoardElement at{0, ElementId{row}};
            const bool isOnNet = netOf(at).isValid() && !finder().pinsOf(netOf(at)).empty();
            const bool isOfNone = !finder().componentOf(at.element).isValid() && finder().pinsOf(at.element).empty();
            if (isOnNet && isOfNone && (nets.insert(netOf(at)).second || !areOfOthers)) {
                found.push_back(at);
            }
        }
        return found;
    }
    int rowOnANet() {
        for (int row = 0; row < pins().model()->rowCount(); ++row) {
            if (!text(row, PinModel::Net).isEmpty()) {
                return row;
            }
        }
        return -1;
    }
    void click(int row) {
        const QModelIndex index = pins().model()->index(row, 0);
        pins().scrollTo(index);
        QTest::mouseClick(pins().viewport(), Qt::LeftButton, {}, pins().visualRect(index).center());
    }

    std::unique_ptr<WindowFixture> m_fixture;
};

QTEST_MAIN(PinsPanelTest)
#include "pins_panel_test.moc"
