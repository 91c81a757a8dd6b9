#include "render/standard/standard_model.h"

#include <QtTest>
#include <map>

#include "model/base/parallel.h"
#include "model/board/document_builder.h"
#include "model/formats/registry.h"
#include "tests/locations.h"

using namespace render;

/// Every element becomes a closed solid of triangles.
class StandardModelTest : public QObject {
    Q_OBJECT

    static StandardModel build(const model::Document& document, const model::Discretisation& how = {}) {
        base::Progress progress;
        auto model = buildStandardModel(document, how, progress);
        return model ? std::move(*model) : StandardModel{};
    }

    static std::shared_ptr<const model::Document> sample() {
        base::Progress progress;
        auto document = model::readBoard(locations::kSample, {}, progress);
        return document ? *document : nullptr;
    }

    /// A board with one layer that holds what `add` adds.
    template <class Add>
    static std::shared_ptr<const model::Document> boardWith(const Add& add) {
        model::DocumentBuilder builder;
        model::Layer layer;
        layer.name = "top";
        layer.type = model::LayerType::Signal;
        layer.thickness = 35'000;
        builder.beginLayer(builder.addLayer(layer));
        add(builder);
        return builder.finish();
    }

    /// Six times the volume, and whether every edge is run along as often forwards as backwards.
    static double volume(const StandardPart& part, bool& isClosed) {
        std::map<std::pair<std::uint32_t, std::uint32_t>, int> edges;
        double sum = 0.0;
        for (std::size_t i = 0; i < part.indices.size(); i += 3) {
            glm::dvec3 corner[3];
            for (std::size_t k = 0; k < 3; ++k) {
                const shader::StandardVertex& vertex = part.vertices[part.indices[i + k]];
                corner[k] = {vertex.x, vertex.y, vertex.face};
                ++edges[{part.indices[i + k], part.indices[i + (k + 1) % 3]}];
                --edges[{part.indices[i + (k + 1) % 3], part.indices[i + k]}];
            }
            sum += glm::dot(corner[0], glm::cross(corner[1], corner[2]));
        }
        isClosed = std::ranges::all_of(edges, [](const auto& edge) { return edge.second == 0; });
        return sum;
    }

private slots:
    void everyKindIsAClosedSolidOfTheRightVolume() {
        const auto document = boardWith([](model::DocumentBuilder& builder) {
            builder.addLine({{0, 0}, {10'000'000, 0}, 2'000'000, 0}, {});
            builder.addCircle({{0, 20'000'000}, 4'000'000, 2'000'000}, {});
            model::DocumentBuilder::Origin hole;
            hole.flags = model::kHole;
            builder.addCircle({{20'000'000, 20'000'000}, 4'000'000, 2'000'000}, hole);
            model::ShapeSketch square;
            square.addPolygon(std::vector<model::Point>{{0, 0}, {3'000'000, 0}, {3'000'000, 3'000'000}, {0, 3'000'000}},
                              false);
            builder.addArea({builder.addShape(square), {{40'000'000, 0}, 30.0, true}}, {});
        });
        const StandardModel model = build(*document, {500.0, false});
        QCOMPARE(model.parts.size(), std::size_t{1});
        bool isClosed = false;
        const double six = volume(model.parts[0], isClosed);
        QVERIFY(isClosed);
        const double pi = std::numbers::pi;
        // Stroke, ring, wall of the hole and its dark inside, square; all of unit height.
        const double expected = (20.0 + pi) + 3.0 * pi + (3.0 * pi + pi) + 9.0;
        QVERIFY2(std::abs(six / 6.0 - expected) < 0.02, qPrintable(QString::number(six / 6.0 - expected)));
        const auto bores = std::ranges::count_if(model.parts[0].vertices, [](const shader::StandardVertex& vertex) {
            return (vertex.owner & shader::kStandardBore) != 0;
        });
        QVERIFY(bores > 0);
    }

    /// With the paper's segments a capsule has 42 corners, two discs 50 each: 4n - 4 triangles per prism.
    void trianglesFollowThePaper() {
        const auto document = boardWith([](model::DocumentBuilder& builder) {
            builder.addLine({{0, 0}, {10'000'000, 0}, 2'000'000, 0}, {});
            builder.addCircle({{0, 20'000'000}, 4'000'000, 0}, {});
        });
        QCOMPARE(build(*document, {5000.0, true}).triangles(), std::uint64_t{4 * 42 - 4 + 4 * 50 - 4});
    }

    void oneAndManyThreadsAgree() {
        const auto document = sample();
        const StandardModel many = build(*document);
        const base::ThreadLimit limit(1);
        const StandardModel one = build(*document);
        QCOMPARE(many.parts.size(), one.parts.size());
        for (std::size_t i = 0; i < one.parts.size(); ++i) {
            QVERIFY(many.parts[i].indices == one.parts[i].indices);
            QVERIFY(std::memcmp(many.parts[i].vertices.data(), one.parts[i].vertices.data(),
                                one.parts[i].vertices.size() * sizeof(shader::StandardVertex)) == 0);
        }
    }

    void cancellingStops() {
        const auto document = sample();
        base::Progress progress;
        progress.cancel();
        const auto model = buildStandardModel(*document, {}, progress);
        QVERIFY(!model);
        QCOMPARE(model.error().code, base::ErrorCode::Cancelled);
    }
};

QTEST_APPLESS_MAIN(StandardModelTest)
#include "standard_model_test.moc"
