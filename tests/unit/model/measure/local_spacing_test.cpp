// The gap at a cursor: between which pieces, and square to their edges.
#include "model/measure/local_spacing.h"

#include <QtTest>
#include <cmath>

#include "tests/unit/model/measure/measure_fixture.h"

using namespace model;
using namespace measuring;

class LocalSpacingTest : public QObject {
    Q_OBJECT

private slots:
    void betweenParallelTracksItIsSquareToThem() {
        DocumentBuilder builder;
        addLayers(builder);
        builder.beginLayer(LayerId{Top});
        const ElementId low = builder.addLine({{0, 0}, {20 * kMm, 10 * kMm}, 200'000, 0}, {});
        const ElementId high = builder.addLine({{-kMm, 2 * kMm}, {19 * kMm, 12 * kMm}, 200'000, 0}, {});
        const auto index = indexed(builder.finish());
        // 2.236 mm between the middles; asked for in the middle of the board, nearer to the lower one.
        const auto gap = at(index, {9.7e6, 5.6e6});
        QVERIFY(gap.has_value());
        QVERIFY2(std::abs(gap->spacing.distance - (std::sqrt(5.0) * 1e6 - 200'000)) < 1e-2,
                 qPrintable(QString::number(gap->spacing.distance)));
        QCOMPARE(gap->to.element, low);
        QCOMPARE(gap->from.element, high);
        QVERIFY(std::hypot(gap->spacing.to.x - 9.7e6, gap->spacing.to.y - 5.6e6) < 1e6);
    }

    void whatIsOfOneNetOrTouchesIsNoGap() {
        DocumentBuilder builder;
        addLayers(builder);
        const NetId net = builder.addNet("A");
        builder.beginLayer(LayerId{Top});
        builder.addCircle({{0, 0}, kMm, 0}, of(net));
        builder.addCircle({{2 * kMm, 0}, kMm, 0}, of(net));
        const ElementId other = builder.addCircle({{0, 5 * kMm}, kMm, 0}, {});
        builder.addCircle({{kMm / 2, 0}, kMm, 0}, {});  // touches the first
        const auto index = indexed(builder.finish());
        const auto gap = at(index, {-100'000, 0});
        QVERIFY(gap.has_value());
        QCOMPARE(gap->from.element, other);
        QVERIFY2(std::abs(gap->spacing.distance - 4e6) < 1e-2, qPrintable(QString::number(gap->spacing.distance)));
    }

    /// Round pads in a row, and another one farther off: each place on a pad gives the same.
    void onAPadItIsTheLeastWhereverThePointerStands() {
        DocumentBuilder builder;
        addLayers(builder);
        builder.beginLayer(LayerId{Top});
        DocumentBuilder::Origin origin;
        origin.flags = kPad;
        const ElementId pad = builder.addCircle({{0, 0}, 1'700'000, 0}, origin);
        const ElementId next = builder.addCircle({{2'540'000, 0}, 1'700'000, 0}, origin);
        builder.addCircle({{0, 3 * kMm}, 1'700'000, 0}, origin);
        const auto index = indexed(builder.finish());
        for (const PointD pointer : {PointD{0, 0}, {-8e5, 0}, {1e5, 8e5}, {3e5, -4e5}, {0.84e6, 1e4}}) {
            const auto gap = at(index, pointer);
            QVERIFY(gap.has_value());
            QVERIFY2(std::abs(gap->spacing.distance - 840'000) < 1e-3, qPrintable(QString::number(pointer.x)));
            QCOMPARE(gap->from.element, next);
            QCOMPARE(gap->to.element, pad);
        }
    }

    /// Between two pads the spacing is theirs, not that of the place where the pointer is.
    void betweenPadsItIsTheirs() {
        DocumentBuilder builder;
        addLayers(builder);
        builder.beginLayer(LayerId{Top});
        builder.addCircle({{0, 0}, 1'700'000, 0}, {});
        builder.addCircle({{2'540'000, 0}, 1'700'000, 0}, {});
        const auto gap = at(indexed(builder.finish()), {1'200'000, 300'000});
        QVERIFY(gap && std::abs(gap->spacing.distance - 840'000) < 1e-3);
    }

    void onlyOneLayerAtATimeCounts() {
        DocumentBuilder builder;
        addLayers(builder);
        builder.beginLayer(LayerId{Top});
        builder.addCircle({{0, 0}, kMm, 0}, {});
        builder.beginLayer(LayerId{Bottom});
        builder.addCircle({{2 * kMm, 0}, kMm, 0}, {});
        QVERIFY(!at(indexed(builder.finish()), {kMm, 0}));
    }

private:
    static std::optional<LocalSpacing> at(const std::shared_ptr<const BoardIndex>& index, PointD location) {
        std::vector<PickLayer> layers(index->board->layers.size(), PickLayer{true, 0.0, 0.0});
        Picker picker(index);
        return spacingAt(picker, location, layers);
    }
};

QTEST_APPLESS_MAIN(LocalSpacingTest)
#include "local_spacing_test.moc"
