// The picture of the selected element alone: there when asked for, of that element, gone with the selection.
#include "ui/element/element_picture.h"

#include <QtTest>

#include "model/statistics/element_sizes.h"
#include "tests/locations.h"
#include "tests/patience.h"
#include "tests/ui/window_fixture.h"
#include "ui/element/element_panel.h"
#include "ui/workspace/actions.h"

using model::ElementId;
using ui::ElementPicture;

class ElementPictureTest : public QObject {
    Q_OBJECT

private slots:
    void initTestCase() {
        m_fixture = std::make_unique<WindowFixture>();
        QVERIFY(m_fixture->openAndWait(locations::kSample));
        window().elementPanel().show();
    }
    void init() {
        while (window().selection().clearStep()) {
        }
    }
    void cleanupTestCase() { QCOMPARE(validationErrorsOnClosing(m_fixture), 0U); }

    void itIsThereWithTheSelection() {
        QVERIFY(picture().isHidden());
        window().selection().select({{0, ElementId{0}}});
        QVERIFY(!picture().isHidden());
        QTRY_VERIFY(!picture().image(ElementPicture::Flat).isNull());
        QVERIFY(picture().reason().isEmpty());
        window().selection().clearStep();
        QVERIFY(picture().isHidden());
    }

    /// A line of length l and width w fills its box but for the corners of its round ends.
    void theFlatOneShowsAllOfTheElementInTheColourOfItsLayer() {
        for (const model::ElementKind kind :
             {model::ElementKind::Line, model::ElementKind::Circle, model::ElementKind::Area}) {
            const std::optional<ElementId> element = squatOnCopper(kind);
            QVERIFY(element.has_value());
            const QImage flat = drawn(*element, ElementPicture::Flat);
            const QColor colour = window().layers().effectiveStyles()[layerOf(*element)].colour;
            int coloured = 0;
            int onEdge = 0;
            for (int y = 0; y < flat.height(); ++y) {
                for (int x = 0; x < flat.width(); ++x) {
                    const bool is = isNear(flat.pixelColor(x, y), colour);
                    const bool isEdge = x == 0 || y == 0 || x == flat.width() - 1 || y == flat.height() - 1;
                    coloured += is ? 1 : 0;
                    onEdge += is && isEdge ? 1 : 0;
                }
            }
            QVERIFY2(coloured > flat.width(), qPrintable(QString::number(coloured)));
            QCOMPARE(onEdge, 0);  // nothing is cut off
        }
    }

    void aBodyStandsOutFromTheGround() {
        const auto& elements = window().document()->elements;
        const model::Document& board = *window().document();
        std::size_t body = 0;
        while (board.layer(elements.layer[body]).type != model::LayerType::ComponentBody) {
            ++body;
        }
        for (const auto view : {ElementPicture::Flat, ElementPicture::Solid}) {
            const QImage image = drawn(ElementId{body}, view);
            const int ground = qGray(image.pixel(0, 0));
            const int middle = qGray(image.pixel(image.width() / 2, image.height() / 2));
            QVERIFY2(std::abs(ground - middle) > 80, qPrintable(QString("%1 on %2").arg(middle).arg(ground)));
        }
    }

    void theSolidOneIsSeenAslant() {
        const ElementId element = *squatOnCopper(model::ElementKind::Circle);
        QVERIFY(drawn(element, ElementPicture::Flat) != drawn(element, ElementPicture::Solid));
        QVERIFY(inkOf(drawn(element, ElementPicture::Solid)) > 0.02);
    }

    void anotherColourOfTheLayerShowsAtOnce() {
        const ElementId element = *squatOnCopper(model::ElementKind::Circle);
        const QImage before = drawn(element, ElementPicture::Flat);
        const auto row = static_cast<int>(layerOf(element));
        ui::LayerModel& layers = window().layers();
        QVERIFY(layers.setData(layers.index(row, ui::LayerModel::Colour), QColor(Qt::magenta), Qt::EditRole));
        QTRY_VERIFY(!picture().image(ElementPicture::Flat).isNull());
        const QImage after = picture().image(ElementPicture::Flat);
        QVERIFY(isNear(after.pixelColor(after.width() / 2, after.height() / 2), Qt::magenta));
        QVERIFY(before != after);
        layers.restoreDefaults();
    }

    void itComesBackAfterTheDeviceWasLost() {
        const ElementId element = *squatOnCopper(model::ElementKind::Circle);
        const QImage before = drawn(element, ElementPicture::Flat);
        m_fixture->context().device().markLost();
        window().views().requestFrame();
        QTRY_VERIFY(!m_fixture->context().device().isLost());
        window().selection().clearStep();
        QCOMPARE(drawn(element, ElementPicture::Flat), before);
    }

private:
    TestWindow& window() { return m_fixture->window(); }
    ElementPicture& picture() { return window().find<ElementPicture>(); }
    const model::Document& board() { return *window().document(); }
    std::size_t layerOf(ElementId element) { return board().elements.layer[element.row()].row(); }

    /// The one that fills the picture best: a long thin one is drawn thinner than a pixel, and paler than its layer.
    std::optional<ElementId> squatOnCopper(model::ElementKind kind) {
        std::optional<ElementId> best;
        double most = 0.0;
        for (std::size_t row = 0; row < board().elements.size(); ++row) {
            const ElementId element{row};
            const model::Box box = board().boxOf(element);
            const auto side = static_cast<double>(std::max(box.width(), box.height()));
            const double fill = model::areaOf(board(), element) / (side * side);
            if (board().elements.kind[row] == kind && board().layers[layerOf(element)].isCopper() && fill > most) {
                most = fill;
                best = element;
            }
        }
        return best;
    }
    QImage drawn(ElementId element, ElementPicture::View view) {
        window().selection().select({{0, element}});
        [this, view] { QTRY_VERIFY(!picture().image(view).isNull()); }();
        return picture().image(view);
    }
    static bool isNear(const QColor& a, const QColor& b) {
        return std::abs(a.red() - b.red()) < 8 && std::abs(a.green() - b.green()) < 8 &&
               std::abs(a.blue() - b.blue()) < 8;
    }

    std::unique_ptr<WindowFixture> m_fixture;
};

QTEST_MAIN(ElementPictureTest)
#include "element_picture_test.moc"
