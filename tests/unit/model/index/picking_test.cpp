// What lies at a place of the board, against fixtures worked out by hand and against gaps measured element by element.
#include "model/index/picking.h"

#include <QtTest>
#include <random>
#include <set>

#include "model/board/document_builder.h"
#include "model/figures/distance.h"
#include "tests/unit/model/hand_made.h"

using namespace model;

namespace {

constexpr Nm kMm = 1'000'000;

std::shared_ptr<const BoardIndex> indexed(std::shared_ptr<const Document> board) {
    base::Progress progress;
    return *indexBoard(std::move(board), progress);
}

/// Two copper layers with a drill through both and a laminate around all; heights in nm.
struct Board {
    enum Layer : std::size_t { Top, Bottom, Drill, Substrate };
    DocumentBuilder builder;
    std::vector<PickLayer> layers = {
        {true, 1.0e6, 1.1e6}, {true, 0.0, 0.1e6}, {true, 0.0, 1.1e6}, {true, 0.1e6, 1.0e6}};
    ElementId line, plane, pad, back, hole, body;

    Board() {
        const LayerId top = builder.addLayer({});
        const LayerId bottom = builder.addLayer({});
        const LayerId drill = builder.addLayer({});
        const LayerId substrate = builder.addLayer({});
        builder.beginLayer(top);
        line = builder.addLine({{0, 0}, {10 * kMm, 0}, kMm, 0}, {});
        plane = builder.addArea({rectangle({-20 * kMm, -20 * kMm}, {20 * kMm, 20 * kMm}), {}}, {});
        pad = builder.addCircle({{10 * kMm, 0}, 2 * kMm, 0}, {});
        builder.beginLayer(bottom);
        back = builder.addLine({{10 * kMm, 0}, {10 * kMm, 5 * kMm}, kMm, 0}, {});
        builder.beginLayer(drill);
        DocumentBuilder::Origin origin;
        origin.flags = kHole;
        hole = builder.addCircle({{10 * kMm, 0}, kMm, kMm}, origin);
        builder.beginLayer(substrate);
        body = builder.addArea({rectangle({-20 * kMm, -20 * kMm}, {20 * kMm, 20 * kMm}), {}}, {});
    }
    ShapeId rectangle(Point min, Point max) {
        ShapeSketch sketch;
        sketch.addPolygon(std::array<Point, 4>{{min, {max.x, min.y}, max, {min.x, max.y}}}, false);
        return builder.addShape(sketch);
    }
};

std::vector<ElementId> elementsOf(const std::vector<Hit>& hits) {
    std::vector<ElementId> ids;
    for (const Hit& hit : hits) {
        ids.push_back(hit.at.element);
    }
    return ids;
}

}  // namespace

class PickingTest : public QObject {
    Q_OBJECT

private slots:
    void whatIsCutAwayIsNotHit() {
        Board board;
        Picker picker(indexed(board.builder.finish()));
        SightLine down{{5.0 * kMm, 0.0}, 20e6, {0.0, 0.0}, 1e6};
        QVERIFY(!picker.along(down, 0.0, board.layers).empty());
        down.cutSide = {{4.0 * kMm, 0.0}, {1.0, 0.0}};
        QVERIFY(picker.along(down, 0.0, board.layers).empty());
        down.cutSide->outward = {-1.0, 0.0};
        QVERIFY(!picker.along(down, 0.0, board.layers).empty());
        // From beyond the cut, the line of sight meets what lies behind it.
        SightLine slanting{{-10.0 * kMm, 0.0}, 10e6, {1e6, 0.0}, 1e6};
        slanting.cutSide = {{0.3 * kMm, 0.0}, {-1.0, 0.0}};
        const std::vector<Hit> hits = picker.along(slanting, 0.0, board.layers);
        QVERIFY(std::ranges::none_of(hits, [&](const Hit& hit) { return hit.depth < 10.3 - 1e-6; }));
    }

    void listGoesFromWhatIsSeenFirstToWhatLiesBeneath() {
        Board b;
        Picker picker(indexed(b.builder.finish()));
        const PointD via{10.0 * kMm, 0.0};
        QCOMPARE(elementsOf(picker.at(via, 0.0, b.layers, false)),
                 (std::vector{b.hole, b.pad, b.line, b.plane, b.body, b.back}));
        QCOMPARE(elementsOf(picker.at(via, 0.0, b.layers, true)),
                 (std::vector{b.hole, b.back, b.body, b.pad, b.line, b.plane}));
    }

    void padsComeBeforeTracksThatEndWithinThem() {
        DocumentBuilder builder;
        builder.beginLayer(builder.addLayer({}));
        DocumentBuilder::Origin ofPad;
        ofPad.flags = kPad;
        const ElementId pad = builder.addCircle({{0, 0}, 2 * kMm, 0}, ofPad);
        const ElementId stub = builder.addLine({{0, 0}, {kMm / 2, 0}, kMm / 10, 0}, {});
        const ElementId plane = builder.addCircle({{0, 0}, 9 * kMm, 0}, {});
        const ElementId smallPad = builder.addCircle({{0, 0}, kMm / 5, 0}, ofPad);
        Picker picker(indexed(builder.finish()));
        const std::vector<PickLayer> layers = {{true, 0.0, 1e5}};
        const std::vector order{smallPad, pad, stub, plane};
        QCOMPARE(elementsOf(picker.at({0.0, 0.0}, 0.0, layers, false)), order);
        QCOMPARE(elementsOf(picker.along({{0.0, 0.0}, 1e6, {0.0, 0.0}, 1.0}, 0.0, layers)), order);
        // What covers the location comes before a pad that is only near.
        const auto beside = picker.at({1.01 * kMm, 0.0}, 0.1 * kMm, layers, false);
        QCOMPARE(elementsOf(beside), (std::vector{plane, pad}));
    }

    void hiddenLayersAreNotPicked() {
        Board b;
        Picker picker(indexed(b.builder.finish()));
        b.layers[Board::Top].isVisible = false;
        QCOMPARE(elementsOf(picker.at({10.0 * kMm, 0.0}, 0.0, b.layers, false)), (std::vector{b.hole, b.body, b.back}));
    }

    void edgeCountsToTheNanometreAndReachAddsWhatIsNear() {
        Board b;
        b.layers[Board::Substrate].isVisible = false;
        Picker picker(indexed(b.builder.finish()));
        const double side = kMm / 2.0;
        QCOMPARE(elementsOf(picker.at({3.0 * kMm, side}, 0.0, b.layers, false)), (std::vector{b.line, b.plane}));
        QCOMPARE(elementsOf(picker.at({3.0 * kMm, side + 1}, 0.0, b.layers, false)), (std::vector{b.plane}));
        const auto near = picker.at({3.0 * kMm, side + 1}, 10.0, b.layers, false);
        QCOMPARE(elementsOf(near), (std::vector{b.plane, b.line}));
        QVERIFY(std::abs(near[1].missedBy - 1.0) < 1e-3);
    }

    void lookingStraightDownIsThePlanView() {
        Board b;
        Picker picker(indexed(b.builder.finish()));
        for (const double x : {-5.0, 3.0, 9.2, 10.0, 10.4, 10.7, 15.0}) {
            for (const bool isFromBelow : {false, true}) {
                const SightLine line{{x * kMm, 0.0}, isFromBelow ? -5e6 : 5e6, {0.0, 0.0}, isFromBelow ? -1.0 : 1.0};
                QCOMPARE(elementsOf(picker.along(line, 0.0, b.layers)),
                         elementsOf(picker.at({x * kMm, 0.0}, 0.0, b.layers, isFromBelow)));
            }
        }
    }

    void obliqueLinesEnterThroughWalls() {
        Board b;
        b.layers[Board::Substrate].isVisible = false;
        b.layers[Board::Drill].isVisible = false;
        Picker picker(indexed(b.builder.finish()));
        // Falls by 1 for each step along x: over the plane's edge at x = 20 mm the line is at z = 1.05 mm.
        const SightLine line{{25.0 * kMm, 10.0 * kMm}, 1.05e6 + 5e6, {-1.0, 0.0}, 1.0};
        const auto hits = picker.along(line, 0.0, b.layers);
        QCOMPARE(elementsOf(hits), (std::vector{b.plane}));
        QVERIFY2(std::abs(hits[0].depth - 5.0e6) < 2.0, qPrintable(QString::number(hits[0].depth)));
        // Edge on, within the thickness of the copper.
        const SightLine level{{25.0 * kMm, 10.0 * kMm}, 1.05e6, {-1.0, 0.0}, 0.0};
        QCOMPARE(elementsOf(picker.along(level, 0.0, b.layers)), (std::vector{b.plane}));
        const SightLine above{{25.0 * kMm, 10.0 * kMm}, 1.15e6, {-1.0, 0.0}, 0.0};
        QVERIFY(picker.along(above, 0.0, b.layers).empty());
    }

    void bodiesAreAsHighAsTheyAre() {
        DocumentBuilder builder;
        model::ShapeSketch square;
        const Point corners[] = {{0, 0}, {kMm, 0}, {kMm, kMm}, {0, kMm}};
        square.addPolygon(corners, false);
        const model::ShapeId shape = builder.addShape(square);
        std::vector<ElementId> bodies;
        for (const model::LayerSide side : {model::LayerSide::Top, model::LayerSide::Bottom}) {
            builder.beginLayer(hand_made::addLayer(builder, LayerType::ComponentBody, side, 0, 5 * kMm));
            bodies.push_back(builder.addArea({shape, {}}, {}));
            builder.addBody({bodies.back(), {}, 2 * kMm});
        }
        Picker picker(indexed(builder.finish()));
        // The layers are drawn from 10 to 15 and from -15 to -10 mm: bodies from 10 to 12 and from -12 to -10 mm.
        const std::vector<PickLayer> layers = {{true, 10e6, 15e6}, {true, -15e6, -10e6}};
        const auto at = [&](double zMm) {
            const SightLine level{{5.0 * kMm, kMm / 2.0}, zMm * 1e6, {-1.0, 0.0}, 0.0};
            return elementsOf(picker.along(level, 0.0, layers));
        };
        QCOMPARE(at(11.5), (std::vector{bodies[0]}));
        QVERIFY(at(12.5).empty());
        QCOMPARE(at(-11.5), (std::vector{bodies[1]}));
        QVERIFY(at(-12.5).empty());
        const SightLine down{{kMm / 2.0, kMm / 2.0}, 20e6, {0.0, 0.0}, 1.0};
        const auto hits = picker.along(down, 0.0, layers);
        QCOMPARE(elementsOf(hits), bodies);
        QCOMPARE(hits[0].depth, 8e6);
        QCOMPARE(hits[1].depth, 30e6);
        // Three times as thick: bodies are as high as they are.
        const std::vector<PickLayer> stretched = {{true, 10e6, 25e6}, {true, -25e6, -10e6}};
        const auto deep = picker.along(down, 0.0, stretched);
        QCOMPARE(elementsOf(deep), bodies);
        QCOMPARE(deep[0].depth, 8e6);
        QCOMPARE(deep[1].depth, 30e6);
    }

    /// Bodies of 2 and of 5 mm on the top and one of 1 mm below a board of 10 mm, whose layers are 5 and 3 mm thick; a
    /// print that has no counterpart.
    void whatIsFlippedIsPickedOnTheOtherSide() {
        DocumentBuilder builder;
        using hand_made::addLayer;
        const LayerId copper[] = {addLayer(builder, LayerType::Signal, LayerSide::Top, 9 * kMm, kMm),
                                  addLayer(builder, LayerType::Signal, LayerSide::Bottom, 0, kMm)};
        const LayerId bodies[] = {addLayer(builder, LayerType::ComponentBody, LayerSide::Top, 10 * kMm, 5 * kMm),
                                  addLayer(builder, LayerType::ComponentBody, LayerSide::Bottom, -3 * kMm, 3 * kMm)};
        const LayerId print = addLayer(builder, LayerType::SilkScreen, LayerSide::Top, 10 * kMm, kMm / 2);
        for (const auto& pair : {copper, bodies}) {
            builder.layer(pair[0]).opposite = pair[1];
            builder.layer(pair[1]).opposite = pair[0];
        }
        std::vector<ElementId> elements;
        const auto addBody = [&](Nm x, Nm height) {
            elements.push_back(builder.addCircle({{x, 0}, kMm, 0}, {}));
            builder.addBody({elements.back(), {}, height});
        };
        builder.beginLayer(bodies[0]);
        addBody(0, 2 * kMm);
        addBody(6 * kMm, 5 * kMm);
        builder.beginLayer(bodies[1]);
        addBody(2 * kMm, kMm);
        builder.beginLayer(print);
        elements.push_back(builder.addCircle({{4 * kMm, 0}, kMm, 0}, {}));
        const auto step = builder.finish();
        auto board = std::make_shared<Document>(*step);
        for (model::Layer& layer : board->layers) {
            layer.elements = {};
        }
        board->elements = {};
        board->circles = {};
        board->bodies = {};
        board->steps = {step};
        board->instances = {{0, {{0, 0}, 0.0, true}, true}};
        board->extent = {{-10 * kMm, -10 * kMm}, {10 * kMm, 10 * kMm}};
        std::vector<PickLayer> layers;
        for (const model::Layer& layer : board->layers) {
            layers.push_back({true, double(layer.z), double(layer.z) + layer.thickness, false, 10e6});
        }
        Picker picker(indexed(board));
        const auto at = [&](double xMm, double zMm) {
            const SightLine level{{xMm * kMm, -5.0 * kMm}, zMm * kMm, {0.0, 1.0}, 0.0};
            return elementsOf(picker.along(level, 0.0, layers));
        };
        const std::vector<ElementId> nothing;
        QCOMPARE(at(0, -1.9), std::vector{elements[0]});
        QCOMPARE(at(0, -2.1), nothing);
        QCOMPARE(at(0, 10.5), nothing);
        QCOMPARE(at(-2, 10.9), std::vector{elements[2]});
        QCOMPARE(at(-2, 11.1), nothing);
        QCOMPARE(at(-6, -4.9), std::vector{elements[1]});  // higher than what stands on the bottom
        QCOMPARE(at(-6, -5.1), nothing);
        QCOMPARE(at(-4, -0.4), std::vector{elements[3]});
        QCOMPARE(at(-4, 10.4), nothing);
        const model::ElementHeights heights = model::elementHeights(*step, elements[3], true);
        QCOMPARE(heights.on({true, 20e6, 30e6, false, 10e6}), std::pair(-20e6, -10e6));  // exploded
        // Twice as thick, a board from 0 to 20 mm has the print from 20 to 21 mm: flipped, from -1 to 0 mm.
        for (std::size_t row = 0; row < layers.size(); ++row) {
            layers[row] = {true, 2 * layers[row].bottom, 2 * layers[row].top, false, 20e6};
        }
        QCOMPARE(heights.on(layers[print.row()]), std::pair(-1e6, 0.0));
        QCOMPARE(at(-4, -0.9), std::vector{elements[3]});
        QCOMPARE(at(-4, -10.5), nothing);
        QVERIFY(std::ranges::any_of(picker.at({-4.0 * kMm, 0.0}, 0.0, layers, true),
                                    [&](const Hit& hit) { return hit.depth == 5e6; }));  // from the lowest body
    }

    void boxTakesWhatIsInsideAndWithTouchingWhatReachesIn() {
        Board b;
        b.layers[Board::Substrate].isVisible = false;
        Picker picker(indexed(b.builder.finish()));
        const auto ids = [](const std::vector<BoardElement>& found) {
            std::vector<ElementId> list;
            for (const BoardElement& element : found) {
                list.push_back(element.element);
            }
            return list;
        };
        const Box box{{8 * kMm, -2 * kMm}, {12 * kMm, 2 * kMm}};
        QCOMPARE(ids(picker.inside(box, false, b.layers)), (std::vector{b.pad, b.hole}));
        // The plane has no edge here, but covers it.
        QCOMPARE(ids(picker.inside(box, true, b.layers)), (std::vector{b.line, b.plane, b.pad, b.back, b.hole}));
        const Box away{{30 * kMm, 30 * kMm}, {40 * kMm, 40 * kMm}};
        QVERIFY(picker.inside(away, true, b.layers).empty());
    }

    void copiesArePickedWhereTheyLie() {
        DocumentBuilder childBuilder;
        const LayerId childLayer = childBuilder.addLayer({});
        childBuilder.beginLayer(childLayer);
        const ElementId pad = childBuilder.addCircle({{kMm, 0}, kMm / 2, 0}, {});
        const auto child = childBuilder.finish();
        auto board = std::make_shared<Document>();
        board->layers.resize(1);
        board->steps = {child};
        board->instances = {{0, {{0, 0}, 0.0, false}, false},
                            {0, {{10 * kMm, 0}, 90.0, false}, false},
                            {0, {{20 * kMm, 0}, 0.0, true}, false}};
        board->extent = {{-30 * kMm, -30 * kMm}, {30 * kMm, 30 * kMm}};
        const auto index = indexed(board);
        Picker picker(index);
        const std::vector<PickLayer> layers = {{true, 0.0, 1e5}};
        const std::pair<PointD, std::uint32_t> locations[] = {
            {{1.0 * kMm, 0.0}, 1}, {{10.0 * kMm, -1.0 * kMm}, 2}, {{19.0 * kMm, 0.0}, 3}};
        for (const auto& [location, copy] : locations) {
            const auto hits = picker.at(location, 0.0, layers, false);
            QCOMPARE(hits.size(), std::size_t{1});
            QCOMPARE(hits[0].at, (BoardElement{copy, pad}));
            const SightLine down{location, 1e6, {0.0, 0.0}, 1.0};
            QCOMPARE(picker.along(down, 0.0, layers).size(), std::size_t{1});
        }
        const Box aroundSecond{{9 * kMm, -2 * kMm}, {11 * kMm, 0}};
        const std::vector<CopyInBox> copies = copiesIn(*index, aroundSecond);
        QCOMPARE(copies.size(), std::size_t{1});  // the others are not looked into
        QCOMPARE(copies[0].copy, std::uint32_t{2});
        QVERIFY(copies[0].box.holds({kMm, 0}) && !copies[0].box.holds({-kMm, 0}));
        const auto found = picker.inside(aroundSecond, false, layers);
        QCOMPARE(found, (std::vector<BoardElement>{{2, pad}}));
    }

    void hiddenNetsAreLookedThrough() {
        DocumentBuilder builder;
        DocumentBuilder::Origin origin;
        origin.net = builder.addNet("A");
        builder.beginLayer(builder.addLayer({}));
        const ElementId pad = builder.addCircle({{0, 0}, kMm, 0}, origin);
        const ElementId below = builder.addCircle({{0, 0}, 2 * kMm, 0}, {});
        const auto step = builder.finish();
        auto board = std::make_shared<Document>();
        board->layers.emplace_back();
        board->steps = {step};
        board->instances = {{0, {}, false}};
        board->extent = {{-kMm, -kMm}, {kMm, kMm}};
        Picker picker(indexed(board));
        const std::vector<PickLayer> layers = {{true, 0.0, 1e5}};
        const SightLine down{{0.0, 0.0}, 1e6, {0.0, 0.0}, 1.0};
        const Box box{{-2 * kMm, -2 * kMm}, {2 * kMm, 2 * kMm}};
        const auto expect = [&](const std::vector<BoardElement>& elements) {
            const auto found = picker.at({0.0, 0.0}, 0.0, layers, false);
            QCOMPARE(found.size(), elements.size());
            QCOMPARE(found.front().at, elements.front());
            QCOMPARE(picker.along(down, 0.0, layers).front().at, elements.front());
            QCOMPARE(picker.inside(box, true, layers), elements);
        };
        expect({{1, pad}, {1, below}});
        picker.hideNets({{true}});  // of the board itself, which has none
        expect({{1, pad}, {1, below}});
        picker.hideNets({{}, {true}});
        expect({{1, below}});
        picker.hideNets({});
        expect({{1, pad}, {1, below}});
    }

    void agreesWithGapsMeasuredOneByOne() {
        std::mt19937 random(7);
        std::uniform_int_distribution<Nm> place(-10 * kMm, 10 * kMm);
        DocumentBuilder builder;
        builder.beginLayer(builder.addLayer({}));
        for (int i = 0; i < 300; ++i) {
            const Point a{place(random), place(random)};
            const Point b{place(random), place(random)};
            builder.addLine({a, b, kMm / 10, 0}, {});
        }
        const auto document = builder.finish();
        Picker picker(indexed(document));
        const std::vector<PickLayer> layers = {{true, 0.0, 1e5}};
        for (int i = 0; i < 200; ++i) {
            const Point at{place(random), place(random)};
            FigureTable point;
            point.addDisc(at, 0.0);
            std::set<ElementId> expected;
            for (std::size_t row = 0; row < document->elements.size(); ++row) {
                FigureTable figures;
                figures.add(*document, ElementId{row});
                if (spacingBetween(figures, 0, point, 0, kTouchNm)) {
                    expected.insert(ElementId{row});
                }
            }
            const auto hits = elementsOf(picker.at(base::toDouble(at), 0.0, layers, false));
            QCOMPARE(std::set(hits.begin(), hits.end()), expected);
        }
    }
};

QTEST_APPLESS_MAIN(PickingTest)
#include "picking_test.moc"
