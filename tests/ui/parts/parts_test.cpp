// From an element in a view to its pin, its component, its net and its layer, with real clicks and keys.

#include <QMouseEvent>
#include <QtTest>

#include "tests/locations.h"
#include "tests/ui/window_fixture.h"
#include "ui/element/element_panel.h"
#include "ui/layers/layers_panel.h"

using model::BoardElement;
using model::ElementId;

class PartsTest : public QObject {
    Q_OBJECT

private slots:
    void initTestCase() {
        m_fixture = std::make_unique<WindowFixture>();
        QVERIFY(m_fixture->openAndWait(locations::kSample));
        m_finder.emplace(board());
        m_pad = aPadOfAPart();
        QVERIFY(m_pad.isValid());
    }
    void init() {
        while (window().selection().clearStep()) {
        }
        window().layers().restoreDefaults();
        window().views().flat().controller().look(render::NamedView::Top);
        window().views().solid().controller().look(render::NamedView::Top);
    }
    void cleanupTestCase() { QCOMPARE(validationErrorsOnClosing(m_fixture), 0U); }

    void theComponentOfAPadLightsUpInBothViews() {
        const QImage before[] = {picture(flat()), picture(solid())};
        window().selection().select({{0, m_pad}});
        m_fixture->key(Qt::Key_P);
        QCOMPARE(selectedIds(), m_finder->elementsOf(part()));
        QVERIFY(selectedIds().size() > 2);
        QCOMPARE(window().selection().current(), std::optional(BoardElement{0, m_pad}));
        QVERIFY(window().label("elementHeading").startsWith("Component " + refdes() + " (bottom): "));
        QVERIFY(differingPixels(before[0], picture(flat())) > 20);
        QVERIFY(differingPixels(before[1], picture(solid())) > 20);
        m_fixture->key(Qt::Key_Escape);
        QVERIFY(window().selection().selected().empty() && window().selection().title().isEmpty());
        QCOMPARE(differingPixels(before[0], picture(flat())), 0);
    }

    void thePinOfAPadIsAllOfItsPadsAndItsHole() {
        window().selection().select({{0, m_pad}});
        m_fixture->key(Qt::Key_P, Qt::ShiftModifier);
        QCOMPARE(selectedIds(), m_finder->elementsOf(m_finder->pinsOf(m_pad).front()));
        QVERIFY(window().label("elementHeading").startsWith("Pin " + refdes() + "."));
        QVERIFY2(!window().label("elementHeading").contains("bottom"), "a pin in a hole is on both sides");
    }

    void ctrlShiftAndAClickSelectTheComponent() {
        flat().controller().show(centre(m_pad) - glm::vec3(1.0F), centre(m_pad) + glm::vec3(1.0F));
        click(flat(), *flat().controller().screenOf(centre(m_pad)), Qt::ControlModifier | Qt::ShiftModifier);
        QCOMPARE(selectedIds(), m_finder->elementsOf(part()));
    }

    void aBodyIsClickedIn3DAndBringsItsPads() {
        const model::Body* body = aTopBody();
        QVERIFY(body != nullptr);
        window().layers().showOnly({board().layer(board().elements.layer[body->element.row()]).name});
        glm::vec3 top = centre(body->element);
        top.z = static_cast<float>(base::toMm(board().heightsOf(body->element).top));
        solid().controller().show(top - glm::vec3(2.0F), top + glm::vec3(2.0F));
        const auto onCanvas = solid().controller().screenOf(top);
        QVERIFY2(onCanvas.has_value(), "in front of the eye");
        click(solid(), *onCanvas);
        QCOMPARE(window().selection().current(), std::optional(BoardElement{0, body->element}));
        const std::string& refdesOfBody = board().components[body->component.row()].refdes;
        QVERIFY(window().fact("Component").startsWith(QString::fromStdString(refdesOfBody)));
        m_fixture->key(Qt::Key_P);
        QCOMPARE(selectedIds(), m_finder->elementsOf(body->component));
    }

    void whatBelongsToNothingIsTold() {
        for (std::size_t row = 0; row < board().elements.size(); ++row) {
            if (!m_finder->componentOf(ElementId{row}).isValid()) {
                window().selection().select({{0, ElementId{row}}});
                break;
            }
        }
        const auto before = window().selection().selected();
        QCOMPARE(before.size(), std::size_t{1});
        m_fixture->key(Qt::Key_P);
        m_fixture->key(Qt::Key_P, Qt::ShiftModifier);
        QCOMPARE(window().selection().selected(), before);
    }

    void linksOfTheElementPanelGoOn() {
        window().selection().select({{0, m_pad}});
        clickFact("Layer");
        QCOMPARE(window().layersPanel().currentLayer(), board().elements.layer[m_pad.row()]);
        clickFact("Component");
        QCOMPARE(selectedIds(), m_finder->elementsOf(part()));
        QCOMPARE(rowOf("Pin"), -1);  // now the panel is about the component
        QVERIFY(window().fact("Nets").contains(
            QString::fromStdString(board().nets[board().elements.net[m_pad.row()].row()].name)));
        window().selection().select({{0, m_pad}});
        clickFact("Pin");
        QVERIFY(window().selection().title().startsWith("Pin "));
        window().selection().select({{0, m_pad}});
        table().setCurrentIndex(table().model()->index(rowOf("Component"), 1));
        QTest::keyClick(&table(), Qt::Key_Return);
        QCOMPARE(selectedIds(), m_finder->elementsOf(part()));
        window().selection().select({{0, m_pad}});
        clickFact("Net");
        const model::NetId net = board().elements.net[m_pad.row()];
        QCOMPARE(window().selection().nets(), (std::vector<model::BoardNet>{{0, net}}));
        QCOMPARE(window().label("elementHeading"), "Net " + QString::fromStdString(board().nets[net.row()].name));
        QCOMPARE(window().fact("Elements").toULongLong(), static_cast<qulonglong>(board().elementsOf(net).size()));
        const auto ofNet = [&](const model::Pin& pin) { return pin.net == net; };
        QCOMPARE(window().fact("Pins").toLongLong(), std::ranges::count_if(board().pins, ofNet));
        const QString pin = table().model()->index(rowOf(""), 1).data().toString();
        clickFact("");
        QVERIFY2(window().selection().title().startsWith("Pin " + pin), qPrintable(window().selection().title()));
        QCOMPARE(window().selection().nets(), (std::vector<model::BoardNet>{{0, net}}));
    }

    /// The last test: it opens another board.
    void withoutComponentsTheCommandsSaySo() {
        QVERIFY(m_fixture->openAndWait(QString(locations::kTestData) + "/odb/negative"));
        const QSignalSpy reported(&window().workspace(), &ui::Workspace::reported);
        window().selection().select({{0, ElementId{std::size_t{0}}}});
        for (const Qt::KeyboardModifiers modifiers : {Qt::NoModifier, Qt::ShiftModifier}) {
            m_fixture->key(Qt::Key_P, modifiers);
            QCOMPARE(reported.last()[0].toString(), "The job has no components");
        }
    }

private:
    TestWindow& window() { return m_fixture->window(); }
    ui::TableView& table() { return *window().elementPanel().findChild<ui::TableView*>(); }
    ui::BoardView& flat() { return window().views().flat(); }
    ui::BoardView& solid() { return window().views().solid(); }
    const model::Document& board() { return *window().document(); }
    model::ComponentId part() { return m_finder->componentOf(m_pad); }
    QString refdes() { return QString::fromStdString(board().components[part().row()].refdes); }

    /// On the uppermost copper layer, on a net, of one pin of a component of several.
    ElementId aPadOfAPart() {
        for (std::size_t row = 0; row < board().elements.size(); ++row) {
            const ElementId element{row};
            const model::Layer& layer = board().layer(board().elements.layer[row]);
            if (layer.isCopper() && layer.side == model::LayerSide::Top && board().elements.net[row].isValid() &&
                m_finder->pinsOf(element).size() == 1 &&
                m_finder->elementsOf(m_finder->componentOf(element)).size() > 4) {
                return element;
            }
        }
        return {};
    }
    const model::Body* aTopBody() {
        for (const model::Body& body : board().bodies) {
            const model::Layer& layer = board().layer(board().elements.layer[body.element.row()]);
            if (layer.side == model::LayerSide::Top && m_finder->elementsOf(body.component).size() > 2) {
                return &body;
            }
        }
        return nullptr;
    }
    std::vector<ElementId> selectedIds() {
        std::vector<ElementId> ids;
        for (const BoardElement& at : window().selection().selected()) {
            ids.push_back(at.element);
        }
        return ids;
    }
    glm::vec3 centre(ElementId element) {
        const model::Box box = board().boxOf(element);
        return window().probing().position().toModel(
            {(double(box.min.x) + box.max.x) / 2.0, (double(box.min.y) + box.max.y) / 2.0});
    }
    int rowOf(const char* fact) {
        for (int row = 0; row < table().model()->rowCount(); ++row) {
            if (table().model()->index(row, 0).data().toString() == QLatin1String(fact)) {
                return row;
            }
        }
        return -1;
    }
    void clickFact(const char* fact) {
        const int row = rowOf(fact);
        QVERIFY(row >= 0);
        const QModelIndex value = table().model()->index(row, 1);
        table().scrollTo(value);
        QTest::mouseClick(table().viewport(), Qt::LeftButton, {}, table().visualRect(value).center());
    }
    static QImage picture(ui::BoardView& view) {
        base::Result<QImage> image = view.grabPicture();
        return image ? image->convertToFormat(QImage::Format_RGB32) : QImage();
    }
    static void click(ui::BoardView& view, QPointF at, Qt::KeyboardModifiers modifiers = Qt::NoModifier) {
        for (const auto type : {QEvent::MouseButtonPress, QEvent::MouseButtonRelease}) {
            QMouseEvent event(type, at, view.mapToGlobal(at), Qt::LeftButton,
                              type == QEvent::MouseButtonPress ? Qt::LeftButton : Qt::NoButton, modifiers);
            QCoreApplication::sendEvent(&view.canvas(), &event);
        }
    }

    std::unique_ptr<WindowFixture> m_fixture;
    std::optional<model::PinFinder> m_finder;
    ElementId m_pad;
};

QTEST_MAIN(PartsTest)
#include "parts_test.moc"
