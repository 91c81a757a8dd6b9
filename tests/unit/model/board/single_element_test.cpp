// An element by itself measures as it did on its board: kind, area, box and heights, of every element of a real job.
#include "model/board/single_element.h"

#include <QtTest>
#include <array>
#include <cmath>

#include "model/board/document_builder.h"
#include "model/formats/registry.h"
#include "model/geometry/vectors.h"
#include "model/statistics/element_sizes.h"
#include "tests/locations.h"

using namespace model;

class SingleElementTest : public QObject {
    Q_OBJECT

private slots:
    void everyElementStaysAsItIs() {
        base::Progress progress;
        const auto board = readBoard(locations::kSample, {}, progress);
        QVERIFY(bool(board));
        const Document& d = **board;
        std::array<int, kElementKindCount> seen{};
        for (std::size_t row = 0; row < d.elements.size(); ++row) {
            const ElementId element{row};
            const auto alone = elementAlone(d, element);
            const ElementId copy{0};
            QCOMPARE(alone->elements.size(), std::size_t{1});
            QCOMPARE(alone->elements.kind[0], d.elements.kind[row]);
            QCOMPARE(alone->elements.flags[0], d.elements.flags[row]);
            QCOMPARE(areaOf(*alone, copy), areaOf(d, element));
            QVERIFY(alone->boxOf(copy) == d.boxOf(element));
            QVERIFY(alone->board == d.boxOf(element));
            QCOMPARE(alone->heightsOf(copy).bottom, d.heightsOf(element).bottom);
            QCOMPARE(alone->heightsOf(copy).top, d.heightsOf(element).top);
            QCOMPARE(nodeCountOf(*alone, copy), nodeCountOf(d, element));
            ++seen[static_cast<std::size_t>(d.elements.kind[row])];
        }
        for (const ElementKind kind : {ElementKind::Line, ElementKind::Circle, ElementKind::Area}) {
            QVERIFY(seen[static_cast<std::size_t>(kind)] > 0);
        }
    }

    void detailsOfAreasAreLeftOutForAPicture() {
        DocumentBuilder builder;
        builder.beginLayer(builder.addLayer({}));
        ShapeSketch sketch;
        sketch.addCircle({0, 0}, 50'000'000, false);
        sketch.beginContour(true);
        for (int i = 0; i < 20'000; ++i) {
            const double angle = i * 2e-4 * std::acos(-1.0) / 2;
            sketch.addNode(Point{toNm(20e6 * std::cos(angle)), toNm(20e6 * std::sin(angle))});
        }
        sketch.addPolygon(std::array<Point, 3>{{{30'000'000, 0}, {30'010'000, 0}, {30'000'000, 10'000}}}, true);
        builder.addArea({builder.addShape(sketch), {}}, {});
        const auto whole = builder.finish();
        const auto coarse = elementAlone(*whole, ElementId{0}, 1'000'000);
        QVERIFY(nodeCountOf(*coarse, ElementId{0}) < 200);
        QCOMPARE(coarse->shapes.contoursOf(coarse->areas[0].shape).size(), std::size_t{2});
        const double area = areaOf(*whole, ElementId{0});
        QVERIFY(std::abs(areaOf(*coarse, ElementId{0}) - area) < 0.002 * area);
        QVERIFY(coarse->boxOf(ElementId{0}) == whole->boxOf(ElementId{0}));
    }
};

QTEST_GUILESS_MAIN(SingleElementTest)
#include "single_element_test.moc"
