#include "render/tiles/area_outlines.h"

#include <QtTest>

#include "model/board/document_builder.h"

using render::AreaOutlines;
using render::BoardModel;

namespace {

constexpr model::Nm kMm = 1'000'000;

/// Between two arcs whose chords lie on each other: discretised, it has no points.
model::ShapeSketch thinLens() {
    constexpr model::Nm kFar = 100 * kMm;  // arcs of 1 mm bulge by 1.25 µm
    model::ShapeSketch sketch;
    sketch.beginContour(false);
    sketch.addNode({{0, 0}, {kMm / 2, kFar}, model::EdgeKind::ArcCounterClockwise});
    sketch.addNode({{kMm, 0}, {kMm / 2, -kFar}, model::EdgeKind::ArcCounterClockwise});
    return sketch;
}

model::ShapeSketch square() {
    model::ShapeSketch sketch;
    sketch.addPolygon(std::vector<model::Point>{{0, 0}, {kMm, 0}, {kMm, kMm}, {0, kMm}}, false);
    return sketch;
}

std::size_t edgesOf(const AreaOutlines& outlines, std::uint32_t shape) {
    std::size_t edges = 0;
    for (const AreaOutlines::Chain& chain : outlines.chainsOf(shape)) {
        edges += outlines.pointsOf(chain).size() - 1;
    }
    return edges;
}

}  // namespace

class AreaOutlinesTest : public QObject {
    Q_OBJECT

private slots:
    void aShapeBehindOneWithoutPointsHasItsOwn() {
        model::DocumentBuilder builder;
        builder.beginLayer(builder.addLayer(model::Layer{}));
        for (const model::ShapeSketch& sketch : {thinLens(), square(), thinLens(), thinLens(), square()}) {
            builder.addArea({builder.addShape(sketch), {}}, {});
        }
        base::Progress progress;
        const auto model = render::buildBoardModel(*builder.finish(), {}, progress);
        QVERIFY(model);
        QCOMPARE(model->shapes.size(), std::size_t{5});
        const AreaOutlines outlines(*model);
        for (std::uint32_t row = 0; row < model->shapes.size(); ++row) {
            const bool isSquare = row == 1 || row == 4;
            QCOMPARE(model->shapes[row].vertexCount, isSquare ? 4U : 0U);
            QCOMPARE(edgesOf(outlines, row), isSquare ? std::size_t{4} : std::size_t{0});
        }
    }
};

QTEST_APPLESS_MAIN(AreaOutlinesTest)
#include "area_outlines_test.moc"
