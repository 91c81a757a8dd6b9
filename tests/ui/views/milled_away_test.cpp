#include "ui/views/milled_away.h"

#include <QtTest>
#include <array>

#include "model/board/document_builder.h"
#include "render/modelling/board_model.h"
#include "tests/locations.h"
#include "tests/ui/window_fixture.h"

using model::BoardElement;
using model::ElementId;
using ui::ActionId;
using ui::BoardView;

/// What is milled away: not in 3D, faint in 2D, and shown in both by a command. On the sample, where a layer draws
/// beyond the outline.
class MilledAwayTest : public QObject {
    Q_OBJECT

private slots:
    void initTestCase() {
        m_fixture = std::make_unique<WindowFixture>();
        QVERIFY(m_fixture->openAndWait(locations::kSample));
        const auto& milled = window().workspace().board()->model->milled;
        QVERIFY(!milled.empty());
        m_milled = milled.front();
        const model::LayerId layer = window().document()->elements.layer[m_milled.row()];
        window().layers().setVisible({&layer, 1}, true);
        views().flat().controller().look(render::NamedView::Top);
        views().solid().controller().look(render::NamedView::Top);
        const model::Box box = window().document()->boxOf(m_milled);
        for (BoardView* view : views().both()) {
            view->controller().show(at(box.min), at(box.max));
        }
    }
    void cleanupTestCase() { QCOMPARE(validationErrorsOnClosing(m_fixture), 0U); }

    void isShownByACommandOnly() {
        const QImage flat = picture(views().flat());
        const QImage solid = picture(views().solid());
        QVERIFY(views().solid().isFabricated());
        window().actions()[ActionId::ShowMilledAway].trigger();
        QVERIFY(!views().solid().isFabricated());
        QVERIFY(differingPixels(solid, picture(views().solid())) > 20);
        QVERIFY2(differingPixels(flat, picture(views().flat())) > 20, "2D is faint beyond the outline");
        window().actions()[ActionId::ShowMilledAway].trigger();
        QCOMPARE(differingPixels(solid, picture(views().solid())), 0);
        QCOMPARE(differingPixels(flat, picture(views().flat())), 0);
    }

    void nothingIsPickedThere() {
        const ui::MilledAway milled(*window().workspace().board());
        const model::Document& document = *window().document();
        const model::Box box = document.boxOf(m_milled);
        const model::PointD inside = base::toDouble(document.board.middle());
        const model::PointD beyond{document.board.max.x + 1e6, document.board.max.y + 1e6};
        QVERIFY(!box.isEmpty());
        QVERIFY(milled.has({0, m_milled}, beyond));
        QVERIFY(!milled.has({0, m_milled}, inside));
        QVERIFY2(!milled.has({1, m_milled}, beyond), "elements of other copies are not milled");
        QVERIFY2(!milled.has({0, notMilled()}, beyond), "what overhangs the board is there");
    }

    /// A plane over the cut-out of a board that a panel places.
    void nothingIsPickedInCutoutsOfTheBoardsOfAPanel() {
        const auto square = [](model::ShapeSketch& sketch, model::Nm low, model::Nm high, bool isHole) {
            sketch.addPolygon(std::array<model::Point, 4>{{{low, low}, {high, low}, {high, high}, {low, high}}},
                              isHole);
        };
        model::Layer copper;
        copper.type = model::LayerType::Signal;
        model::DocumentBuilder card;
        model::ShapeSketch outline;
        square(outline, 0, 10'000'000, false);
        square(outline, 4'000'000, 6'000'000, true);
        card.setProfile(card.addShape(outline));
        card.beginLayer(card.addLayer(copper));
        model::ShapeSketch plane;
        square(plane, 1'000'000, 9'000'000, false);
        const ElementId element = card.addArea({card.addShape(plane), {}}, {});
        model::DocumentBuilder panel;
        panel.addLayer(copper);
        model::ShapeSketch frame;
        square(frame, 0, 30'000'000, false);
        panel.setProfile(panel.addShape(frame));
        panel.addInstance({panel.addStep(card.finish()), {{10'000'000, 10'000'000}, 0.0, false}, false});
        ui::LoadedBoard board;
        board.document = panel.finish();
        base::Progress progress;
        auto made = render::buildBoardModel(*board.document, {}, progress);
        QVERIFY(made.ok());
        board.model = std::make_shared<const render::BoardModel>(std::move(*made));
        const ui::MilledAway milled(board);
        QVERIFY(milled.has({1, element}, {15e6, 15e6}));
        QVERIFY(!milled.has({1, element}, {12e6, 12e6}));
        QVERIFY2(!milled.has({0, element}, {15e6, 15e6}), "it is of the copy");
    }

private:
    TestWindow& window() { return m_fixture->window(); }
    ui::BoardViews& views() { return window().views(); }
    glm::vec3 at(base::Point nm) { return window().probing().position().toModel(base::toDouble(nm)); }
    ElementId notMilled() {
        const auto& milled = window().workspace().board()->model->milled;
        ElementId element{0};
        while (std::ranges::binary_search(milled, element)) {
            element = ElementId{element.row() + 1};
        }
        return element;
    }
    static QImage picture(BoardView& view) {
        base::Result<QImage> image = view.grabPicture();
        return image ? image->convertToFormat(QImage::Format_RGB32) : QImage();
    }

    std::unique_ptr<WindowFixture> m_fixture;
    ElementId m_milled;
};

QTEST_MAIN(MilledAwayTest)
#include "milled_away_test.moc"
