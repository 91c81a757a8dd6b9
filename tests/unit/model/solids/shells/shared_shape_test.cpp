#include "model/solids/shells/shared_shape.h"

#include <QtTest>

#include "model/geometry/loops/edge_faults.h"
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
