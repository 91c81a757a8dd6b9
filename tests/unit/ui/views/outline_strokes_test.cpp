#include "ui/views/outline_strokes.h"

#include <QtTest>
#include <array>
#include <cmath>
#include <glm/gtc/matrix_transform.hpp>
#include <numbers>

#include "model/geometry/vectors.h"

using base::Point;
using model::PolygonSet;
using ui::OutlineRuns;
using ui::OutlineSight;
using ui::OutlineStrokes;

namespace {

constexpr int kMm = 1'000'000;
constexpr double kCanvas = 1000.0;

/// A canvas that shows `mm` millimetres around a location.
OutlineSight sightOf(float mm, glm::vec2 middle = {0.0F, 0.0F}) {
    OutlineSight sight;
    sight.clipFromBoard = glm::scale(glm::mat4(1.0F), glm::vec3(2.0F / mm, -2.0F / mm, 1.0F)) *
                          glm::translate(glm::mat4(1.0F), glm::vec3(-middle, 0.0F));
    sight.viewport = {kCanvas, kCanvas};
    return sight;
}

std::vector<Point> circle(double x, double y, double radius, int points) {
    std::vector<Point> loop;
    for (int i = 0; i < points; ++i) {
        const double angle = 2 * std::numbers::pi * i / points;
        loop.push_back({model::toNm(x + radius * std::cos(angle)), model::toNm(y + radius * std::sin(angle))});
    }
    return loop;
}

PolygonSet square(int side) {
    PolygonSet set;
    set.beginPolygon();
    const int h = side / 2;
    set.addLoop(std::array<Point, 4>{{{-h, -h}, {h, -h}, {h, h}, {-h, h}}});
    return set;
}

/// A plane of 100 mm with an opening of 0.8 mm every millimetre.
OutlineRuns perforatedPlane() {
    PolygonSet set = square(100 * kMm);
    for (int x = -48; x <= 48; ++x) {
        for (int y = -48; y <= 48; ++y) {
            set.addLoop(circle(double(x) * kMm, double(y) * kMm, 0.4 * kMm, 32));
        }
    }
    return OutlineRuns(std::move(set));
}

OutlineStrokes strokesOf(const OutlineRuns& outline, const OutlineSight& sight) {
    OutlineStrokes strokes(sight);
    strokes.add(outline, 0.0F, 0);
    strokes.thin();
    return strokes;
}

}  // namespace

class OutlineStrokesTest : public QObject {
    Q_OBJECT

private slots:
    void aPlainOutlineIsDrawnWhole() {
        PolygonSet set = square(60 * kMm);
        set.addLoop(circle(0, 0, 10.0 * kMm, 64));
        const OutlineStrokes strokes = strokesOf(OutlineRuns(std::move(set)), sightOf(100));
        QCOMPARE(strokes.lines().size(), std::size_t{2});
        const QPolygonF& outer = strokes.lines()[0].points;
        QCOMPARE(outer.size(), 5);
        QCOMPARE(outer.boundingRect().toRect(), QRect(200, 200, 600, 600));
        QVERIFY((outer.front() - outer.back()).manhattanLength() < 1.0);
        QCOMPARE(strokes.lines()[1].points.size(), 65);
    }

    void aPerforatedPlaneIsItsContourAndWhatIsNearThePointer() {
        const OutlineRuns plane = perforatedPlane();
        QVERIFY(plane.isPerforated());
        // 20 mm on the canvas: openings of 40 pixels, 400 of them in sight; the contour runs around it.
        OutlineSight sight = sightOf(20);
        QCOMPARE(strokesOf(plane, sight).lines().size(), std::size_t{1});
        sight.pointer = QPointF(500, 500);
        const OutlineStrokes near = strokesOf(plane, sight);
        QVERIFY(near.lines().size() >= 5);  // the one at the pointer and its neighbours
        QVERIFY(near.lines().size() <= 25);
        for (std::size_t i = 1; i < near.lines().size(); ++i) {
            const QPointF off = near.lines()[i].points.boundingRect().center() - *sight.pointer;
            QVERIFY(std::max(std::abs(off.x()), std::abs(off.y())) < OutlineStrokes::kNear + 25);
        }
        // All of it on the canvas: the contour and no opening, wherever the pointer is.
        sight = sightOf(110);
        sight.pointer = QPointF(500, 500);
        QCOMPARE(strokesOf(plane, sight).lines().size(), std::size_t{1});
    }

    void largeOpeningsAreSeenWhereverThePointerIs() {
        // 3 mm on the canvas: an opening is 267 pixels wide, and few fit.
        const OutlineStrokes strokes = strokesOf(perforatedPlane(), sightOf(3));
        QVERIFY(strokes.lines().size() >= 9);
    }

    void theWorkGoesByWhatIsSeen() {
        PolygonSet set = square(100 * kMm);
        set.addLoop(circle(0, 0, 40.0 * kMm, 400'000));
        const OutlineRuns outline(std::move(set));
        const std::size_t runs = outline.pointCount() / 32 + 2;
        const OutlineStrokes whole = strokesOf(outline, sightOf(100));
        QVERIFY(whole.visited() < 4 * runs);  // runs smaller than a pixel count as one point
        const OutlineStrokes part = strokesOf(outline, sightOf(0.1F, {40.0F, 0.0F}));
        QVERIFY(part.visited() < runs + 5000);
        QVERIFY(!part.lines().empty());
    }

    void whateverIsAddedNoMoreThanSoMuchIsPainted() {
        // A comb of a million corners that fills the canvas.
        PolygonSet set;
        set.beginPolygon();
        std::vector<Point> comb{{50 * kMm, -50 * kMm}};
        for (int i = 0; i < 250'000; ++i) {
            const int x = 50 * kMm - i * 400;
            for (const int y : {49 * kMm, -49 * kMm}) {
                comb.push_back({x, y});
                comb.push_back({x - 200, y});
            }
        }
        comb.push_back({-50 * kMm, -50 * kMm});
        set.addLoop(comb);
        const OutlineRuns outline(std::move(set));
        OutlineStrokes strokes(sightOf(100));
        for (int i = 0; i < 3; ++i) {
            strokes.add(outline, 0.0F, i);
        }
        strokes.thin();
        QVERIFY(strokes.segmentCount() <= OutlineStrokes::kMostSegments);
    }

    void manyOutlinesStayWithinTheBoundAndTheFirstOnesAreKept() {
        OutlineStrokes strokes(sightOf(100));
        for (int i = 0; i < 20'000; ++i) {
            PolygonSet set;
            set.beginPolygon();
            set.addLoop(circle((i % 140 - 70) * 0.7 * kMm, (i / 140.0 - 70) * 0.7 * kMm, 0.3 * kMm, 16));
            strokes.add(OutlineRuns(std::move(set)), 0.0F, i);
        }
        strokes.thin();
        QVERIFY(strokes.segmentCount() <= OutlineStrokes::kMostSegments);
        QVERIFY(strokes.lines().size() > 1000);
        QCOMPARE(strokes.lines().front().ink, 0);
    }

    void whatIsCutAwayHasNoOutline() {
        OutlineSight sight = sightOf(100);
        sight.cut = render::SectionPlane{{0.0, 0.0}, {0.0, 1.0}};  // what is to the left of a line upwards is gone
        const OutlineStrokes strokes = strokesOf(OutlineRuns(square(60 * kMm)), sight);
        QVERIFY(!strokes.lines().empty());
        QRectF box;
        for (const OutlineStrokes::Line& line : strokes.lines()) {
            box |= line.points.boundingRect();
        }
        QCOMPARE(box.toRect(), QRect(500, 200, 300, 600));
        // The face of the cut is no part of the outline.
        const auto hasCutEdge = [](const OutlineStrokes::Line& line) {
            return std::adjacent_find(line.points.begin(), line.points.end(), [](QPointF a, QPointF b) {
                       return std::abs(a.x() - 500) < 1 && std::abs(b.x() - 500) < 1;
                   }) != line.points.end();
        };
        QVERIFY(std::none_of(strokes.lines().begin(), strokes.lines().end(), hasCutEdge));
    }
};

QTEST_APPLESS_MAIN(OutlineStrokesTest)
#include "outline_strokes_test.moc"
