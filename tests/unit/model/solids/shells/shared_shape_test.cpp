#include "model/solids/shells/shared_shape.h"

#include <QtTest>

#include "model/geometry/loops/edge_faults.h"
#include "model/geometry/vectors.h"
#include "tests/unit/model/geometry/edge_loop_checks.h"
#include "tests/unit/model/hand_made.h"

using namespace hand_made;
using model::ElementId;
using model::LayerType;
using model::Point;
using model::ShapeSketch;

namespace {

constexpr std::array<StackLayer, 1> kStackup{{{"top", LayerType::Signal, 1'600 * kUm, 35 * kUm, 2}}};

}  // namespace

class SharedShapeTest : public QObject {
    Q_OBJECT

private slots:
    void tracksOfOneLengthAndWidthAreOneShape() {
        model::DocumentBuilder builder;
        addLayers(builder, kStackup);
        builder.beginLayer(model::LayerId{std::size_t{0}});
        const ElementId along = builder.addLine({{7, 9}, {5 * kMm + 7, 9}, kMm, 0}, {});
        const ElementId slanted = builder.addLine({{kMm, 0}, {-2 * kMm, 4 * kMm}, kMm, 0}, {});
        const ElementId wider = builder.addLine({{7, 9}, {5 * kMm + 7, 9}, kMm + 1, 0}, {});
        const ElementId longer = builder.addLine({{7, 9}, {5 * kMm + 8, 9}, kMm, 0}, {});
        model::DocumentBuilder::Origin squarePen;
        squarePen.flags = model::kSquarePen;
        const ElementId square = builder.addLine({{7, 9}, {5 * kMm + 7, 9}, kMm, 0}, squarePen);
        const ElementId slot = builder.addLine({{7, 9}, {5 * kMm + 7, 9}, kMm, kMm / 2}, {});
        const auto shapeOf = [&](ElementId element) { return model::sharedShapeOf(builder.soFar(), element); };
        QVERIFY(shapeOf(along)->key == shapeOf(slanted)->key);
        QVERIFY(shapeOf(along)->key != shapeOf(wider)->key);
        QVERIFY(shapeOf(along)->key != shapeOf(longer)->key);
        QVERIFY(!shapeOf(square));
        QVERIFY(!shapeOf(slot));
        for (const ElementId element : {along, slanted}) {
            const auto shared = shapeOf(element);
            const model::ElementOutlines canonical = model::outlinesOf(builder.soFar(), shared->key);
            const model::ElementOutlines own = model::outlinesOf(builder.soFar(), element);
            const model::EdgeLoops there = model::placed(canonical.regions.front(), shared->placement);
            const model::EdgeLoops& expected = own.regions.front();
            QCOMPARE(there.edges.size(), expected.edges.size());
            for (std::size_t i = 0; i < expected.edges.size(); ++i) {
                QVERIFY(model::distance(there.edges[i].a, expected.edges[i].a) < 0.01);
                QCOMPARE(there.edges[i].isArc(), expected.edges[i].isArc());
            }
        }
    }

    void placedShapesAreCleanedAsSingleOnesAre() {
        model::DocumentBuilder builder;
        addLayers(builder, kStackup);
        builder.beginLayer(model::LayerId{std::size_t{0}});
        ShapeSketch pinched;
        pinched.addPolygon(
            std::vector<Point>{{0, 0}, {kMm, 0}, {kMm / 2, kMm / 2}, {kMm, kMm}, {0, kMm}, {kMm / 2, kMm / 2}}, false);
        const model::ShapeId shape = builder.addShape(pinched);
        const ElementId plain = builder.addArea({shape, {{7, 9}, 0.0, false}}, {});
        const ElementId mirrored = builder.addArea({shape, {{kMm, 9}, 90.0, true}}, {});
        for (const ElementId element : {plain, mirrored}) {
            const auto shared = model::sharedShapeOf(builder.soFar(), element);
            QVERIFY(shared);
            const model::ElementOutlines outlines = model::outlinesOf(builder.soFar(), shared->key);
            QCOMPARE(outlines.problem, std::string_view{});
            QCOMPARE(outlines.regions.size(), 2U);
            for (const model::EdgeLoops& region : outlines.regions) {
                QVERIFY(edge_loop_checks::areSound(region));
                QVERIFY(!model::findFault(region));
            }
        }
    }
};

QTEST_APPLESS_MAIN(SharedShapeTest)
#include "shared_shape_test.moc"
