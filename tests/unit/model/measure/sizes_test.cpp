// Widths, radii and angles of single elements.
#include "model/measure/sizes.h"

#include <QtTest>
#include <cmath>
#include <numbers>

#include "tests/unit/model/measure/measure_fixture.h"

using namespace model;
using namespace measuring;

class SizesTest : public QObject {
    Q_OBJECT

private slots:
    void everyKindTellsWhatItHas() {
        DocumentBuilder builder;
        addLayers(builder);
        builder.beginLayer(LayerId{Top});
        const ElementId line = builder.addLine({{0, 0}, {3 * kMm, 4 * kMm}, 200'000, 0}, {});
        const ElementId arc =
            builder.addArc({PathNode{{kMm, 0}, {0, 0}, EdgeKind::ArcCounterClockwise}, {0, kMm}, 100'000}, {});
        const ElementId disc = builder.addCircle({{0, 0}, kMm, 0}, {});
        const ElementId ring = builder.addCircle({{0, 0}, kMm, 600'000}, {});
        const ElementId bare = builder.addCircle({{0, 0}, kMm, kMm}, of({}, kHole));
        const ElementId area = builder.addArea({builder.addShape(rectangle({0, 0}, {kMm, kMm})), {}}, {});
        const auto board = builder.finish();

        const Sizes ofLine = sizesOf(*board, line);
        QCOMPARE(*ofLine.width, 200'000.0);
        QCOMPARE(*ofLine.length, 5.0 * kMm);
        QVERIFY(!ofLine.radius && !ofLine.diameter);
        const Sizes ofArc = sizesOf(*board, arc);
        QCOMPARE(*ofArc.radius, 1.0 * kMm);
        QVERIFY(std::abs(*ofArc.length - std::numbers::pi * kMm / 2) < 1e-3);
        QCOMPARE(*sizesOf(*board, disc).diameter, 1.0 * kMm);
        QVERIFY(!sizesOf(*board, disc).innerDiameter);
        QCOMPARE(*sizesOf(*board, ring).innerDiameter, 600'000.0);
        QVERIFY(!sizesOf(*board, bare).innerDiameter);
        QVERIFY(!sizesOf(*board, area).width);
    }

    void anglesHaveNoDirection() {
        DocumentBuilder builder;
        addLayers(builder);
        builder.beginLayer(LayerId{Top});
        const ElementId east = builder.addLine({{0, 0}, {kMm, 0}, 1000, 0}, {});
        const ElementId west = builder.addLine({{kMm, 5 * kMm}, {0, 5 * kMm}, 1000, 0}, {});
        const ElementId up = builder.addLine({{0, 0}, {0, kMm}, 1000, 0}, {});
        const ElementId slanting = builder.addLine({{0, 0}, {-kMm, kMm}, 1000, 0}, {});
        const ElementId dot = builder.addLine({{0, 0}, {0, 0}, 1000, 0}, {});
        const ElementId disc = builder.addCircle({{0, 0}, 1000, 0}, {});
        const std::array<PathNode, 3> nodes = {PathNode{{3 * kMm, 0}, {}, EdgeKind::Line},
                                               PathNode{{3 * kMm, 3 * kMm}, {}, EdgeKind::Line},
                                               PathNode{{9 * kMm, 9 * kMm}, {}, EdgeKind::Line}};
        const ElementId trail = builder.addTrail(nodes, 1000, {});
        const auto index = indexed(builder.finish());
        const auto angle = [&](ElementId a, ElementId b) { return angleBetween(*index, {0, a}, {0, b}); };
        QCOMPARE(*angle(east, west), 0.0);
        QCOMPARE(*angle(east, up), 90.0);
        QCOMPARE(*angle(slanting, east), 45.0);
        QCOMPARE(*angle(trail, east), 90.0);  // the stroke of the trail that is nearest
        QVERIFY(!angle(east, dot) && !angle(east, disc));
    }
};

QTEST_APPLESS_MAIN(SizesTest)
#include "sizes_test.moc"
