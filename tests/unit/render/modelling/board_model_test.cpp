#include "render/modelling/board_model.h"

#include <QtTest>
#include <cstring>
#include <set>

#include "model/base/parallel.h"
#include "model/board/document_builder.h"
#include "model/formats/registry.h"
#include "render/standard/standard_model.h"
#include "tests/locations.h"

using model::DocumentBuilder;
using render::BoardModel;

namespace {

std::shared_ptr<const model::Document> readBoard(const std::string& path) {
    base::Progress progress;
    const auto result = model::readBoard(path, {}, progress);
    return result ? *result : nullptr;
}

BoardModel build(const model::Document& document, const model::Discretisation& how = {}) {
    base::Progress progress;
    auto result = render::buildBoardModel(document, how, progress);
    return std::move(*result);
}

template <class T>
bool sameBytes(const std::vector<T>& a, const std::vector<T>& b) {
    return a.size() == b.size() && (a.empty() || std::memcmp(a.data(), b.data(), a.size() * sizeof(T)) == 0);
}

model::ShapeSketch polygonSketch(const std::vector<model::Point>& points) {
    model::ShapeSketch sketch;
    sketch.addPolygon(points, false);
    return sketch;
}

}  // namespace

constexpr model::Nm kMm = 1'000'000;

class BoardModelTest : public QObject {
    Q_OBJECT

private slots:
    void modelDoesNotDependOnTheNumberOfThreads() {
        const auto document = readBoard(locations::kSample);
        QVERIFY(document);
        BoardModel single;
        {
            const base::ThreadLimit limit(1);
            single = build(*document);
        }
        for (int round = 0; round < 3; ++round) {
            const BoardModel many = build(*document);
            QVERIFY(sameBytes(single.lets, many.lets));
            QVERIFY(sameBytes(single.clusters, many.clusters));
            QVERIFY(sameBytes(single.vertices, many.vertices));
            QVERIFY(sameBytes(single.indices, many.indices));
            QVERIFY(sameBytes(single.next, many.next));
            QVERIFY(sameBytes(single.instances, many.instances));
        }
    }

    void everyAreaIsAnInstanceOfItsLayer() {
        const auto document = readBoard(locations::kSample);
        const BoardModel model = build(*document);
        std::size_t seen = 0;
        std::set<std::uint32_t> elements;
        for (std::size_t layer = 0; layer < document->layers.size(); ++layer) {
            const render::LayerRun run = model.areaBatchesOfLayer[layer];
            for (std::uint32_t i = run.first; i < run.first + run.count; ++i) {
                const render::AreaBatch& batch = model.areaBatches[i];
                QCOMPARE(batch.layer, layer);
                for (std::uint32_t k = 0; k < batch.instanceCount; ++k) {
                    const shader::AreaInstance& instance = model.instances[batch.firstInstance + k];
                    QCOMPARE(instance.shape, batch.shape);
                    QCOMPARE(instance.layer, layer);
                    if (instance.onlyAs != shader::kOnlyAsFabricated) {
                        elements.insert(instance.element);
                    }
                    ++seen;
                }
            }
        }
        QCOMPARE(seen, model.instances.size());
        QCOMPARE(elements.size(), document->areas.size());
    }

    void bodiesHaveHeightsOfTheirOwn() {
        DocumentBuilder builder;
        const model::ShapeId square = builder.addShape(polygonSketch({{0, 0}, {500, 0}, {500, 300}, {0, 300}}));
        model::Layer layer;
        layer.type = model::LayerType::ComponentBody;
        layer.thickness = 3'000'000;
        for (const model::LayerSide side : {model::LayerSide::Top, model::LayerSide::Bottom}) {
            layer.side = side;
            builder.beginLayer(builder.addLayer(layer));
            builder.addBody({builder.addArea({square, {}}, {}), {}, 750'000});
        }
        const auto document = builder.finish();
        const BoardModel model = build(*document);
        QCOMPARE(model.layers[0].growth, std::uint32_t{shader::kLayerGrowsUp});
        QCOMPARE(model.layers[1].growth, std::uint32_t{shader::kLayerGrowsDown});
        QCOMPARE(model.layers.size(), std::size_t{2});
        QCOMPARE(model.instances[0].height, 0.75F);
        base::Progress progress;
        const auto standard = render::buildStandardModel(*document, {}, progress);
        const auto faces = [&](std::size_t part) {
            return std::pair{standard->parts[part].vertices[1].face, standard->parts[part].vertices[0].face};
        };
        QCOMPARE(faces(0), (std::pair{0.0F, 0.25F}));
        QCOMPARE(faces(1), (std::pair{0.75F, 1.0F}));
    }

    void roundHolesOfBodiesAreAsHighAsTheBody() {
        DocumentBuilder builder;
        model::ShapeSketch ring = polygonSketch({{0, 0}, {kMm, 0}, {kMm, kMm}, {0, kMm}});
        ring.addCircle({kMm / 2, kMm / 2}, kMm / 10, true);
        model::Layer layer;
        layer.thickness = 3 * kMm;
        builder.beginLayer(builder.addLayer(layer));
        builder.addArea({builder.addShape(ring), {}}, {});
        QCOMPARE(build(*builder.finish()).lets.size(), std::size_t{1});
        builder.beginLayer(builder.addLayer(layer));
        builder.addBody({builder.addArea({builder.addShape(ring), {}}, {}), {}, kMm});
        QVERIFY(build(*builder.finish()).lets.empty());
    }

    void aSymbolUsedOftenIsTriangulatedOnce() {
        DocumentBuilder builder;
        const model::ShapeId pad =
            builder.addShape(polygonSketch({{-500, -300}, {500, -300}, {500, 300}, {-500, 300}}));
        builder.beginLayer(builder.addLayer({}));
        for (int i = 0; i < 100; ++i) {
            builder.addArea({pad, {{i * 2000, 0}, 30.0 * i, i % 2 == 0}}, {});
        }
        const BoardModel model = build(*builder.finish());
        QCOMPARE(model.shapes.size(), 1U);
        QCOMPARE(model.indices.size(), 6U);
        QCOMPARE(model.instances.size(), 100U);
        QCOMPARE(model.areaBatches.size(), 1U);
    }

    void keyholeBridgesGetNoWall() {
        DocumentBuilder builder;
        builder.beginLayer(builder.addLayer({}));
        const model::ShapeId keyhole = builder.addShape(polygonSketch({{0, 0},
                                                                       {1000, 0},
                                                                       {1000, 1000},
                                                                       {0, 1000},
                                                                       {0, 500},
                                                                       {400, 500},
                                                                       {400, 600},
                                                                       {600, 600},
                                                                       {600, 400},
                                                                       {400, 400},
                                                                       {400, 500},
                                                                       {0, 500}}));
        builder.addArea({keyhole, {}}, {});
        const BoardModel model = build(*builder.finish());
        QCOMPARE(model.repairedAreas, 0U);
        std::size_t walls = 0;
        for (std::uint32_t i = 0; i < model.next.size(); ++i) {
            walls += model.next[i] != i ? 1 : 0;
        }
        QCOMPARE(walls, 10U);  // five on the outline (one side is cut in two), five around the hole likewise
    }

    void crossingOutlinesAreRepairedAndReported() {
        DocumentBuilder builder;
        model::Layer layer;
        layer.name = "TOP";
        layer.file = "steps/pcb/layers/top/features";
        builder.beginLayer(builder.addLayer(layer));
        DocumentBuilder::Origin origin;
        origin.line = 42;
        // A bow tie whose lobes both count: the area is covered, not cancelled.
        const model::ShapeId bowTie = builder.addShape(polygonSketch({{0, 0}, {1000, 1000}, {1000, 0}, {0, 3000}}));
        builder.addArea({bowTie, {}}, origin);
        const BoardModel model = build(*builder.finish());
        QCOMPARE(model.repairedAreas, 1U);
        QVERIFY(!model.indices.empty());
        QCOMPARE(model.diagnostics.entries().size(), 1U);
        QCOMPARE(model.diagnostics.entries()[0].line, 42U);
        QCOMPARE(model.diagnostics.entries()[0].file, std::string("steps/pcb/layers/top/features"));
    }

    void drawingsBeyondTheOutlineAreOneMessage() {
        DocumentBuilder builder;
        builder.setProfile(builder.addShape(polygonSketch({{0, 0}, {9 * kMm, 0}, {9 * kMm, 9 * kMm}, {0, 9 * kMm}})));
        for (const char* const name : {"TOP", "FAB", "NOTES"}) {
            model::Layer layer;
            layer.name = name;
            layer.type = name[0] == 'T' ? model::LayerType::Signal : model::LayerType::Document;
            builder.beginLayer(builder.addLayer(layer));
            builder.addCircle({{kMm, kMm}, kMm, 0}, {});
            builder.addCircle({{9 * kMm, kMm}, kMm, 0}, {});
        }
        const BoardModel model = build(*builder.finish());
        std::vector<std::string> messages;
        for (const model::Diagnostic& entry : model.diagnostics.entries()) {
            messages.push_back(entry.text);
        }
        QCOMPARE(messages, (std::vector<std::string>{
                               "Layer TOP: 1 element reaches beyond the board outline; 3D shows it as it is milled",
                               "Drawings reach beyond the board outline, where 3D ends them: FAB, NOTES"}));
    }

    void printOverAnOpenHoleIsHeldBothWays() {
        DocumentBuilder builder;
        builder.setProfile(builder.addShape(polygonSketch({{0, 0}, {9 * kMm, 0}, {9 * kMm, 9 * kMm}, {0, 9 * kMm}})));
        for (const auto& [name, type] :
             {std::pair("SILK", model::LayerType::SilkScreen), std::pair("TOP", model::LayerType::Signal),
              std::pair("DRILL", model::LayerType::Drill)}) {
            model::Layer layer;
            layer.name = name;
            layer.type = type;
            builder.beginLayer(builder.addLayer(layer));
            if (layer.name == "SILK") {
                builder.addLine({{kMm, kMm}, {8 * kMm, kMm}, kMm / 5, 0}, {});
            } else if (layer.name == "DRILL") {
                DocumentBuilder::Origin hole;
                hole.flags = model::kHole;
                builder.addCircle({{4 * kMm, kMm}, kMm, kMm}, hole);
            }
        }
        const BoardModel model = build(*builder.finish());
        QCOMPARE(model.diagnostics.entries().size(), 1U);
        QCOMPARE(model.diagnostics.entries()[0].text,
                 std::string("Layer SILK: 1 element lies over open holes; 3D shows what print is left beside them"));
        QVERIFY(model.milled.empty());  // none of it is beyond the outline
        QCOMPARE(model.instances.size(), 1U);
        QCOMPARE(model.instances[0].onlyAs, shader::kOnlyAsFabricated);
        QCOMPARE(model.clusters[0].onlyAs, shader::kOnlyAsDesigned);
    }

    void cancelledModellingSaysSo() {
        const auto document = readBoard(locations::kSample);
        base::Progress progress;
        progress.cancel();
        const auto result = render::buildBoardModel(*document, {}, progress);
        QVERIFY(!result);
        QCOMPARE(result.error().code, base::ErrorCode::Cancelled);
    }
};

QTEST_APPLESS_MAIN(BoardModelTest)
#include "board_model_test.moc"
