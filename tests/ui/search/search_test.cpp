// One box finds nets, parts, pins, layers and places; keys alone suffice.

#include <QFile>
#include <QFontMetricsF>
#include <QGuiApplication>
#include <QLineEdit>
#include <QListWidget>
#include <QPolygonF>
#include <QStatusBar>
#include <QTransform>
#include <QtTest>

#include "tests/locations.h"
#include "tests/patience.h"
#include "tests/ui/window_fixture.h"
#include "ui/layers/layers_panel.h"
#include "ui/search/location_mark.h"
#include "ui/search/search_box.h"
#include "ui/views/plan_painter.h"

using ui::ActionId;

class SearchTest : public QObject {
    Q_OBJECT

private slots:
    void init() {
        m_fixture = std::make_unique<WindowFixture>();
        QVERIFY(m_fixture->openAndWait(locations::kSample));
    }
    void cleanup() { QCOMPARE(validationErrorsOnClosing(m_fixture), 0U); }

    void aNetIsHighlightedAndShown() {
        const float before = window().views().flat().controller().mmPerPixel();
        type("1pps_out");
        take();
        QCOMPARE(window().selection().nets(),
                 (std::vector{model::BoardNet{0, window().document()->findNet("1PPS_OUT")}}));
        QVERIFY(window().views().flat().controller().mmPerPixel() != before);
    }

    void whereNothingIsFoundItSaysSo() {
        type("no such thing at all");
        QCOMPARE(box().list().count(), 1);
        QVERIFY(box().list().item(0)->text().contains("no such thing at all"));
        QTest::keyClick(&box().line(), Qt::Key_Return);
        QVERIFY2(box().isVisible(), "there is nothing to go to");
        QTest::keyClick(&box().line(), Qt::Key_Escape);
        QVERIFY(!box().isVisible());
    }

    void anAsteriskIsForAnyLettersAndAQuestionMarkForOne() {
        for (const auto& [pattern, names] :
             {std::pair("1pps_*", QStringList{"1PPS_IN", "1PPS_OUT"}), std::pair("*_OUT", QStringList{"1PPS_OUT"}),
              std::pair("?p*s_in", QStringList{"1PPS_IN"}), std::pair("netc3_?", QStringList{"NetC3_1"})}) {
            type(pattern);
            QStringList found;
            for (int row = 0; row < box().list().count(); ++row) {
                if (const QString text = box().list().item(row)->text(); text.contains(" Net, ")) {
                    found += text.section(' ', 0, 0);
                }
            }
            QCOMPARE(found, names);
            QTest::keyClick(&box().line(), Qt::Key_Escape);
        }
        type("u1.*");
        QVERIFY(box().list().count() > 1);
        QVERIFY2(box().list().item(0)->text().startsWith("U1."), qPrintable(box().list().item(0)->text()));
        QTest::keyClick(&box().line(), Qt::Key_Escape);
    }

    void oneIsNoPlural() {
        int ones = 0;
        for (const char* all : {"j*", "n*"}) {
            type(all);
            for (int row = 0; row < box().list().count(); ++row) {
                const QString text = box().list().item(row)->text();
                QVERIFY2(!text.contains(" 1 pins") && !text.contains(" 1 elements"), qPrintable(text));
                ones += text.contains(" 1 pin,") || text.contains(" 1 element") ? 1 : 0;
            }
            QTest::keyClick(&box().line(), Qt::Key_Escape);
        }
        QVERIFY(ones > 0);
    }

    void whatIsFoundOnHiddenLayersIsSaidToBe() {
        QVERIFY(m_fixture->openAndWait(boardWithPartsBelowEachOther()));
        window().layers().showOnly({"B.Cu"});
        type("r1");
        take();
        QCOMPARE(window().statusBar()->currentMessage(), "R1 is on layers that are hidden: F.Cu");
        type("b");
        take();
        QVERIFY2(!window().statusBar()->currentMessage().contains("hidden"),
                 "its copper is on the layer that is shown");
        type("a");
        take();
        QVERIFY(window().statusBar()->currentMessage().startsWith("A is on layers that are hidden: F.Cu"));
    }

    void whatIsFoundOfAHiddenNetIsSaidToBe() {
        QVERIFY(m_fixture->openAndWait(boardWithPartsBelowEachOther()));
        const auto net = [&](const char* name) { return model::BoardNet{0, board().findNet(name)}; };
        window().netStyles().isolate(std::vector{net("A")}, window().selection().tree());
        QVERIFY(window().netStyles().isHidden(net("B")));
        for (const auto& [found, title] : {std::pair("b", "B"), std::pair("r2.1", "R2.1")}) {
            type(found);
            take();
            QCOMPARE(window().statusBar()->currentMessage(),
                     QStringLiteral("%1 is hidden: Show all nets (Ctrl+Alt+N)").arg(title));
        }
        type("a");
        take();
        QVERIFY2(window().statusBar()->currentMessage().isEmpty(), "it is seen");
    }

    /// A flipped copy has at the bottom what the others have on top.
    void whatAFlippedCopyShowsIsNotHidden() {
        QVERIFY(m_fixture->openAndWait(QString(locations::kTestData) + "/odb/panel"));
        window().layers().showOnly({"BOTTOM"});
        type("a");
        QListWidget& list = box().list();
        const QList<QListWidgetItem*> ofCard = list.findItems("card", Qt::MatchContains);
        QVERIFY2(!ofCard.isEmpty(), qPrintable(list.item(0)->text()));
        list.setCurrentItem(ofCard.front());
        take();
        QCOMPARE(window().selection().nets().size(), std::size_t{1});
        QVERIFY2(!window().statusBar()->currentMessage().contains("hidden"),
                 qPrintable(window().statusBar()->currentMessage()));
        window().layers().showOnly({"DRILL"});
        type("a");
        list.setCurrentItem(list.findItems("card", Qt::MatchContains).front());
        take();
        QCOMPARE(window().statusBar()->currentMessage(), "A is on layers that are hidden: TOP, BOTTOM");
    }

    void aComponentsPadsAreSelected() {
        type("u1");
        take();
        const auto& elements = window().selection().selected();
        const model::PinFinder finder(*window().document());
        std::size_t pads = 0;
        for (const model::BoardElement& at : elements) {
            // Some pads are shared with other parts.
            const auto isOfU1 = [&](model::PinId pin) {
                return window().document()->components[window().document()->pins[pin.row()].component.row()].refdes ==
                       "U1";
            };
            const auto pins = finder.pinsOf(at.element);
            QVERIFY(std::ranges::any_of(pins, isOfU1) || window().document()->bodyOf(at.element) != nullptr);
            pads += pins.size();
        }
        QVERIFY(pads >= 9);
        QCOMPARE(window().selection().title(), "Component U1");
    }

    void padsWithoutNetsBelongToTheirComponentToo() {
        type("j6");
        take();
        const auto& pads = window().selection().selected();
        QVERIFY(!pads.empty());
        for (const model::BoardElement& pad : pads) {
            QVERIFY(!window().document()->elements.net[pad.element.row()].isValid());
        }
        const base::PointD middle =
            window().probing().position().toJob(window().views().flat().controller().camera().target());
        QVERIFY(std::abs(middle.x - 4.4e6) < 1e6 && std::abs(middle.y - 38.6e6) < 1e6);
    }

    void aLayerBecomesTheCurrentOne() {
        window().layers().hideAll();
        type("l02");
        take();
        const model::LayerId layer = window().document()->findLayer("L02-INNER_LAYER");
        QCOMPARE(window().layersPanel().currentLayer(), layer);
        QVERIFY(window().layers().effectiveStyles()[layer.row()].isVisible);
    }

    void aPlaceComesToTheMiddle() {
        type("10, 20 mm");
        take();
        const ui::BoardView& flat = window().views().flat();
        const QSizeF size = flat.controller().viewport();
        constexpr double kRuler = 18.0;
        const QPointF middle((size.width() + kRuler) / 2.0, (size.height() + kRuler) / 2.0);
        QVERIFY(QLineF(*flat.screenOf({10e6, 20e6}), middle).length() < 1.0);
        const ui::BoardView& solid = window().views().solid();
        glm::vec3 onTop = solid.position().toModel({10e6, 20e6});
        onTop.z = solid.seenFace(*window().document());
        QVERIFY2(onTop.z > 0.5F, "not on the lower face");
        const QSizeF all = solid.controller().viewport();
        const QPointF there = *solid.controller().screenOf(onTop);
        QVERIFY(QLineF(there, QPointF(all.width() / 2.0, all.height() / 2.0)).length() < 25.0);  // in perspective
    }

    void aPlaceIsMarkedInBothViews() {
        for (const ActionId view : {ActionId::ShowFlat, ActionId::ShowSolid}) {
            window().actions()[view].trigger();
            type("10, 20 mm");
            take();
            const base::Result<QImage> marked = window().views().active().grabPicture();
            m_fixture->key(Qt::Key_Escape);
            const base::Result<QImage> bare = window().views().active().grabPicture();
            QVERIFY(marked && bare);
            const int ofTheMark = differingPixels(*marked, *bare);
            QVERIFY2(ofTheMark > 50 && ofTheMark < 1'000, qPrintable(QString::number(ofTheMark)));
        }
    }

    void theMarkGoesWhenSomethingElseIsDone() {
        const ui::LocationMark& mark = window().find<ui::LocationMark>();
        type("1pps_out");
        take();
        const auto nets = window().selection().nets();
        const auto markPlace = [&] {
            type("10, 20 mm");
            take();
            QVERIFY(mark.location().has_value());
        };
        markPlace();
        m_fixture->key(Qt::Key_Escape);
        QVERIFY(!mark.location());
        QCOMPARE(window().selection().nets(), nets);  // the next Esc ends the highlight
        window().workspace().setCurrentLayer(window().document()->findLayer("L02-INNER_LAYER"));
        m_fixture->key(Qt::Key_H);
        const auto visible = [&] { return window().layers().effectiveStyles()[0].isVisible; };
        const bool wasVisible = visible();
        markPlace();
        m_fixture->key(Qt::Key_Escape);
        QVERIFY(!mark.location());
        QVERIFY2(visible() == wasVisible, "nor is the layer that is shown alone");
        m_fixture->key(Qt::Key_H);
        markPlace();
        type("gnd");
        take();
        QVERIFY(!mark.location());
        markPlace();
        emit window().views().solid().controller().clicked({200.0, 200.0}, Qt::NoModifier);
        QVERIFY(!mark.location());
        markPlace();
        QVERIFY(m_fixture->openAndWait(QString(locations::kTestData) + "/odb/panel"));
        QVERIFY(!mark.location());
    }

    /// And not to the line that had it before: the next key is a command.
    void theKeyboardGoesToTheViewThatShowsIt() {
        window().actions()[ActionId::ShowNetsDock].trigger();
        auto* filter = window().netsPanel().findChild<QLineEdit*>();
        window().activateWindow();
        QVERIFY(QTest::qWaitForWindowActive(&window()));
        filter->setFocus();
        QTRY_VERIFY(filter->hasFocus());
        QTest::keyClick(filter, Qt::Key_F, Qt::ControlModifier);
        QTest::keyClicks(&box().line(), "u1");
        take();
        QTRY_COMPARE(QGuiApplication::focusObject(), &window().views().active().canvas());
        filter->setFocus();
        QTest::keyClick(filter, Qt::Key_F, Qt::ControlModifier);
        QTest::keyClick(&box().line(), Qt::Key_Escape);
        QTRY_VERIFY2(filter->hasFocus(), "who gives up goes on typing");
    }

    void escEndsTheToolThenTheMarkThenTheLayerAlone() {
        window().workspace().setCurrentLayer(window().document()->findLayer("L02-INNER_LAYER"));
        m_fixture->key(Qt::Key_H);
        m_fixture->key(Qt::Key_M);
        type("10, 20 mm");
        take();
        const ui::LocationMark& mark = window().find<ui::LocationMark>();
        const auto isMeasuring = [&] { return window().actions()[ActionId::MeasurePoints].isChecked(); };
        const auto isAlone = [&] { return window().layers().soloLayer().isValid(); };
        QVERIFY(isMeasuring() && mark.location().has_value() && isAlone());
        m_fixture->key(Qt::Key_Escape);
        QVERIFY(!isMeasuring() && mark.location().has_value() && isAlone());
        m_fixture->key(Qt::Key_Escape);
        QVERIFY(!mark.location().has_value() && isAlone());
        m_fixture->key(Qt::Key_Escape);
        QVERIFY(!isAlone());
    }

    void arrowsChooseAndEscapeCloses() {
        type("1pps");
        QCOMPARE(box().list().currentRow(), 0);
        QTest::keyClick(&box().line(), Qt::Key_Down);
        QCOMPARE(box().list().currentRow(), 1);
        take();
        QCOMPARE(window().selection().nets(),
                 (std::vector{model::BoardNet{0, window().document()->findNet("1PPS_OUT")}}));
        type("gnd");
        QTest::keyClick(&box().line(), Qt::Key_Escape);
        QVERIFY(!box().isVisible());
        QCOMPARE(window().selection().nets(),
                 (std::vector{model::BoardNet{0, window().document()->findNet("1PPS_OUT")}}));
    }

    /// R2 lies on the bottom right below R1.
    void aPartOfTheBottomIsSeenAsSuch() {
        QVERIFY(m_fixture->openAndWait(boardWithPartsBelowEachOther()));
        type("r2.1");
        take();
        QCOMPARE(window().selection().title(), "Pin R2.1 (bottom)");
        QCOMPARE(window().fact("Layer"), "B.Cu");
        QCOMPARE(window().statusBar()->currentMessage(), "R2 is on the bottom of the board");
        window().views().flat().controller().zoomAtCentre(0.6F);
        QCOMPARE(names().filter("R2.1").size(), 1);
        QVERIFY2(names().filter("R1.1").isEmpty(), qPrintable(names().join(' ')));
        QVERIFY2(!names().filter("R1.2").isEmpty(), "beside what is selected names are those of the top");
        window().selection().select({});
        QVERIFY2(window().statusBar()->currentMessage().isEmpty(), "gone with the selection");
        type("r1.1");
        take();
        QCOMPARE(window().selection().title(), "Pin R1.1");
        QVERIFY(window().statusBar()->currentMessage().isEmpty());
        QCOMPARE(names().filter("R1.1").size(), 1);
        type("r2");
        take();
        QVERIFY2(window().label("elementHeading").startsWith("Component R2 (bottom): 2 pins"),
                 qPrintable(window().label("elementHeading")));
    }

    /// As fixings of connectors are: both by its name and from one of its pads.
    void aPinIsAllItsPads() {
        const QString path = m_fixture->folder() + "/two_pads.kicad_pcb";
        QFile file(path);
        QVERIFY(file.open(QFile::WriteOnly));
        file.write(
            "(kicad_pcb (version 20241229) (layers (0 \"F.Cu\" signal) (2 \"B.Cu\" signal)) (net 1 \"GND\")"
            "(footprint \"J\" (layer \"F.Cu\") (at 10 10) (property \"Reference\" \"J7\") (attr smd)"
            "(pad \"MP\" smd rect (at -4 0) (size 1 1) (layers \"F.Cu\") (net 1 \"GND\"))"
            "(pad \"1\" smd rect (at 0 0) (size 1 1) (layers \"F.Cu\"))"
            "(pad \"MP\" smd rect (at 4 0) (size 1 1) (layers \"F.Cu\") (net 1 \"GND\"))))");
        file.close();
        QVERIFY(m_fixture->openAndWait(path));
        type("j7.mp");
        QCOMPARE(box().list().count(), 1);
        take();
        const std::vector<model::BoardElement> pads = window().selection().selected();
        QCOMPARE(pads.size(), std::size_t{2});
        QCOMPARE(window().selection().title(), "Pin J7.MP");
        for (const model::BoardElement& pad : pads) {
            window().selection().select({pad});
            m_fixture->key(Qt::Key_P, Qt::ShiftModifier);
            QCOMPARE(window().selection().selected(), pads);
            QCOMPARE(window().selection().title(), "Pin J7.MP");
        }
    }

    void namesAreThoseOfTheCurrentLayer() {
        QVERIFY(m_fixture->openAndWait(boardWithPartsBelowEachOther()));
        type("10, -10 mm");
        take();
        QVERIFY2(!names().filter("R1.1").isEmpty() && names().filter("R2.1").isEmpty(), qPrintable(names().join(' ')));
        window().workspace().setCurrentLayer(window().document()->findLayer("B.Cu"));
        QVERIFY2(names().filter("R1.1").isEmpty() && !names().filter("R2.1").isEmpty(), qPrintable(names().join(' ')));
        window().layers().showOnly({"F.Cu"});
        QVERIFY2(!names().filter("R1.1").isEmpty(), "a layer that is hidden names nothing");
    }

    void namesOnAHighlightedNetAreItsOwn() {
        QVERIFY(m_fixture->openAndWait(boardWithPartsBelowEachOther()));
        type("b");
        take();
        QCOMPARE(window().selection().nets().size(), std::size_t{1});
        QVERIFY2(names().filter("R2.").size() == 2 && names().filter("R1.").isEmpty(), qPrintable(names().join(' ')));
        window().selection().setNets({});
        QVERIFY2(names().filter("R2.").isEmpty() && names().filter("R1.").size() == 2, qPrintable(names().join(' ')));
    }

    void aNetOfAPlacedStepIsHighlighted() {
        QVERIFY(m_fixture->openAndWait(QString(locations::kTestData) + "/odb/panel"));
        type("b");
        take();
        QCOMPARE(window().selection().nets().size(), std::size_t{1});
        const model::BoardNet net = window().selection().nets().front();
        QVERIFY(net.step > 0);
        QCOMPARE(window().selection().tree().steps[net.step]->nets[net.net.row()].name, std::string("B"));
    }

    /// A pad, a track that begins on it, a via in it: one name each would lie on the others.
    void namesOfOnePlaceAreWrittenOnce() {
        QVERIFY(m_fixture->openAndWait(boardWithCopperOnCopper()));
        window().views().setArrangement(ui::Arrangement::Flat);
        ui::CameraController& camera = window().views().flat().controller();
        camera.look(render::NamedView::Top);
        QTRY_VERIFY(names().contains("R1.1\nA"));
        QCOMPARE(names().count("A"), 1);  // of the via on a track's middle
        for (const float zoom : {1.0F, 1.5F, 2.0F, 3.0F}) {
            camera.zoomAtCentre(zoom);
            const auto labels = window().find<ui::PlanPainter>().labels();
            QVERIFY(!labels.empty());
            for (std::size_t a = 0; a < labels.size(); ++a) {
                for (std::size_t b = a + 1; b < labels.size(); ++b) {
                    QVERIFY2(lettersOf(labels[a]).intersected(lettersOf(labels[b])).isEmpty(),
                             qPrintable(labels[a].text + " on " + labels[b].text));
                }
            }
        }
    }

    void aComponentThatIsFoundIsInTheMiddleOfBothViews() {
        const model::Body& body = lowestBody();
        const model::ZRange z = board().heightsOf(body.element);
        QVERIFY2(2 * body.height < board().layer(board().elements.layer[body.element.row()]).thickness,
                 "others on its side are much taller");
        window().views().solid().controller().look(render::NamedView::Iso);
        type(QString::fromStdString(board().components[body.component.row()].refdes));
        take();
        QCOMPARE(window().selection().current(), (model::BoardElement{0, body.element}));
        const model::Box box = board().boxOf(body.element);
        const base::PointD middle{(double(box.min.x) + box.max.x) / 2.0, (double(box.min.y) + box.max.y) / 2.0};
        const glm::vec3 centre = window().probing().position().toModel(middle, (double(z.bottom) + z.top) / 2.0);
        for (const ui::BoardView* view : window().views().both()) {
            const QSizeF size = view->controller().viewport();
            const QPointF at = view->controller().screenOf(centre).value_or(QPointF(-1, -1));
            QVERIFY(QLineF(at, QPointF(size.width() / 2, size.height() / 2)).length() < size.height() / 20.0);
        }
    }

    /// Most parts of the sample are on its bottom.
    void whatBodiesCoverHasNoNameUnlessItIsSelected() {
        window().views().setArrangement(ui::Arrangement::Flat);
        ui::CameraController& camera = window().views().flat().controller();
        camera.look(render::NamedView::Bottom);
        const ui::BoardPosition place = window().probing().position();
        for (const model::Body& body : board().bodies) {
            const model::Box box = board().boxOf(body.element);
            camera.show(place.toModel(base::toDouble(box.min)), place.toModel(base::toDouble(box.max)));
            const int before = isOnBottom(body.element) ? namesWithin(box) : 0;
            if (before == 0) {
                continue;
            }
            m_fixture->key(Qt::Key_C, Qt::ShiftModifier);
            QTRY_COMPARE(namesWithin(box), 0);
            selectCopperWithin(box);
            QTRY_COMPARE(namesWithin(box), before);
            window().selection().select({});
            m_fixture->key(Qt::Key_C, Qt::ShiftModifier);
            QTRY_COMPARE(namesWithin(box), before);
            return;
        }
        QFAIL("no body covers a name");
    }

private:
    TestWindow& window() { return m_fixture->window(); }
    const model::Document& board() { return *window().document(); }
    ui::SearchBox& box() { return window().searchBox(); }

    /// On copper in the 2D view.
    QStringList names() {
        QStringList texts;
        for (const ui::PlanPainter::Label& label : window().find<ui::PlanPainter>().labels()) {
            texts += label.text;
        }
        return texts;
    }

    /// Of the components with two pins.
    const model::Body& lowestBody() {
        const auto height = [this](const model::Body& body) {
            const bool hasTwoPins = board().components[body.component.row()].pinCount == 2;
            return hasTwoPins ? body.height : std::numeric_limits<model::Nm>::max();
        };
        return *std::ranges::min_element(board().bodies, {}, height);
    }
    bool isOnBottom(model::ElementId element) {
        return board().layer(board().elements.layer[element.row()]).side == model::LayerSide::Bottom;
    }
    /// Of those on copper, how many are written within a box, a little away from its edge.
    int namesWithin(const model::Box& box) {
        const ui::BoardView& view = window().views().flat();
        const QPointF a = view.screenOf(base::toDouble(box.min)).value_or(QPointF());
        const QPointF b = view.screenOf(base::toDouble(box.max)).value_or(QPointF());
        const QRectF whole = QRectF(a, b).normalized();
        const QRectF inner =
            whole.adjusted(whole.width() / 20, whole.height() / 20, -whole.width() / 20, -whole.height() / 20);
        return static_cast<int>(
            std::ranges::count_if(window().find<ui::PlanPainter>().labels(),
                                  [&](const ui::PlanPainter::Label& label) { return inner.contains(label.middle); }));
    }
    /// On the bottom.
    void selectCopperWithin(const model::Box& box) {
        std::vector<model::BoardElement> within;
        for (std::size_t row = 0; row < board().elements.size(); ++row) {
            const model::ElementId element{row};
            const bool isCopper = board().layer(board().elements.layer[row]).isCopper();
            if (isCopper && isOnBottom(element) && board().boxOf(element).meets(box)) {
                within.push_back({0, element});
            }
        }
        window().selection().select(within);
    }

    /// What the letters of a label cover at least, as the font says.
    static QPolygonF lettersOf(const ui::PlanPainter::Label& label) {
        QFont font = QGuiApplication::font();
        font.setBold(true);
        font.setPixelSize(static_cast<int>(label.height));
        double width = 0.0;
        for (const QString& line : label.text.split('\n')) {
            width = std::max(width, QFontMetricsF(font).horizontalAdvance(line));
        }
        const double high = 0.7 * label.height;
        QTransform turn;
        turn.translate(label.middle.x(), label.middle.y());
        turn.rotate(label.angleDeg);
        return turn.map(QPolygonF(QRectF(-0.48 * width, -high / 2, 0.96 * width, high)));
    }

    QString boardWithCopperOnCopper() {
        const QString path = m_fixture->folder() + "/copper.kicad_pcb";
        QFile file(path);
        if (file.open(QFile::WriteOnly)) {
            file.write(
                "(kicad_pcb (version 20241229) (generator \"pcbnew\") (layers (0 \"F.Cu\" signal) (2 \"B.Cu\" signal) "
                "(1 \"F.Mask\" user) (25 \"Edge.Cuts\" user)) (net 0 \"\") (net 1 \"A\") "
                "(footprint \"R\" (layer \"F.Cu\") (at 6 10) (property \"Reference\" \"R1\") (attr smd) "
                "(pad \"1\" smd rect (at 0 0) (size 3 3) (layers \"F.Cu\" \"F.Mask\") (net 1 \"A\"))) "
                "(segment (start 5 10) (end 7 10) (width 2) (layer \"F.Cu\") (net 1)) "
                "(segment (start 6 10.2) (end 6 9.4) (width 2) (layer \"F.Cu\") (net 1)) "
                "(segment (start 10 10) (end 18 10) (width 2) (layer \"F.Cu\") (net 1)) "
                "(segment (start 14 10) (end 14 10.8) (width 2) (layer \"F.Cu\") (net 1)) "
                "(via (at 14 10) (size 2) (drill 0.5) (layers \"F.Cu\" \"B.Cu\") (net 1)) "
                "(gr_rect (start 0 0) (end 20 20) (stroke (width 0.1) (type default)) (fill no) (layer "
                "\"Edge.Cuts\")))");
        }
        return path;
    }

    QString boardWithPartsBelowEachOther() {
        const auto part = [](const QString& name, const QString& side, const QString& net) {
            const QString pad = QStringLiteral(
                "(pad \"%1\" smd rect (at %2 0) (size 1 1) (layers \"%3.Cu\" \"%3.Mask\" "
                "\"%3.Paste\") (net %4))");
            return QStringLiteral(
                       "(footprint \"R\" (layer \"%1.Cu\") (at 10 10) (property \"Reference\" \"%2\") "
                       "(attr smd) %3 %4)")
                .arg(side, name, pad.arg("1", "-1", side, net), pad.arg("2", "1", side, net));
        };
        const QString path = m_fixture->folder() + "/two_sides.kicad_pcb";
        QFile file(path);
        if (file.open(QFile::WriteOnly)) {
            file.write(
                QStringLiteral("(kicad_pcb (version 20241229) (generator \"pcbnew\") (layers (0 \"F.Cu\" signal) "
                               "(2 \"B.Cu\" signal) (13 \"F.Paste\" user) (15 \"B.Paste\" user) (1 \"F.Mask\" "
                               "user) (3 \"B.Mask\" user) (25 \"Edge.Cuts\" user)) (net 0 \"\") (net 1 \"A\") "
                               "(net 2 \"B\") %1 %2 (gr_rect (start 0 0) (end 20 20) (stroke (width 0.1) (type "
                               "default)) (fill no) (layer \"Edge.Cuts\")))")
                    .arg(part("R1", "F", "1 \"A\""), part("R2", "B", "2 \"B\""))
                    .toUtf8());
        }
        return path;
    }

    void type(const QString& text) {
        m_fixture->key(Qt::Key_F, Qt::ControlModifier);
        QVERIFY(box().isVisible());
        QTest::keyClicks(&box().line(), text);
    }
    void take() {
        QTest::keyClick(&box().line(), Qt::Key_Return);
        QVERIFY(!box().isVisible());
    }

    std::unique_ptr<WindowFixture> m_fixture;
};

QTEST_MAIN(SearchTest)
#include "search_test.moc"
