#include "render/scene/shape_bounds.h"

#include <QtTest>
#include <numbers>

using namespace render;

/// Boxes around shapes, and how far they stray from them.
class ShapeBoundsTest : public QObject {
    Q_OBJECT

    using Loop = std::vector<glm::vec2>;

    /// Loops counter-clockwise, holes clockwise; triangles by corners of all loops one behind the other.
    static shader::ShapeBound boundOf(const std::vector<Loop>& loops, const std::vector<std::uint32_t>& triangles) {
        BoardModel model;
        for (const Loop& loop : loops) {
            const auto first = static_cast<std::uint32_t>(model.vertices.size());
            for (std::uint32_t i = 0; i < loop.size(); ++i) {
                model.vertices.push_back(loop[i]);
                model.next.push_back(first + (i + 1) % static_cast<std::uint32_t>(loop.size()));
            }
        }
        const auto count = static_cast<std::uint32_t>(model.vertices.size());
        model.indices = triangles;
        model.shapes = {{0, count, 0, static_cast<std::uint32_t>(triangles.size()) / 3, 0, count}};
        return boundsOf(model).front();
    }

    /// All triangles of a convex outline.
    static std::vector<std::uint32_t> fanOf(const Loop& loop) {
        std::vector<std::uint32_t> triangles;
        for (std::uint32_t i = 2; i < loop.size(); ++i) {
            triangles.insert(triangles.end(), {0, i - 1, i});
        }
        return triangles;
    }

    static bool isNear(float a, float b) { return std::abs(a - b) < 1e-4F; }

private slots:
    void aRectangleIsItsBox() {
        const Loop loop = {{1, 2}, {5, 2}, {5, 4}, {1, 4}};
        const shader::ShapeBound bound = boundOf({loop}, fanOf(loop));
        QCOMPARE(bound.centre, glm::vec2(3, 3));
        QCOMPARE(bound.extent, glm::vec2(2, 1));
        QCOMPARE(bound.stray, 0.0F);
    }

    void roundShapesStrayByWhatTheirCornersLack() {
        Loop disc;
        for (int i = 0; i < 64; ++i) {
            const double angle = std::numbers::pi * i / 32.0;
            disc.emplace_back(10.0 + std::cos(angle), std::sin(angle));
        }
        const shader::ShapeBound bound = boundOf({disc}, fanOf(disc));
        QVERIFY(isNear(bound.stray, std::numbers::sqrt2_v<float> - 1.0F));
        const Loop chamfered = {{0, 0}, {4, 0}, {4, 1.5F}, {3.5F, 2}, {0, 2}};
        QVERIFY(isNear(boundOf({chamfered}, fanOf(chamfered)).stray, 0.5F / std::numbers::sqrt2_v<float>));
    }

    void whatIsNotConvexOrNotFilledStraysByAllOfIt() {
        const Loop square = {{0, 0}, {3, 0}, {3, 3}, {0, 3}};
        const Loop hole = {{1, 1}, {1, 2}, {2, 2}, {2, 1}};
        const float all = 3.0F * std::numbers::sqrt2_v<float>;
        const Loop notched = {{0, 0}, {3, 0}, {3, 1}, {1, 1}, {1, 3}, {0, 3}};
        QVERIFY(isNear(boundOf({notched}, {0, 1, 3, 1, 2, 3, 0, 3, 4, 0, 4, 5}).stray, all));
        QVERIFY(isNear(
            boundOf({square, hole}, {0, 1, 4, 1, 7, 4, 1, 2, 7, 2, 6, 7, 2, 3, 6, 3, 5, 6, 3, 0, 5, 0, 4, 5}).stray,
            all));
        // Lets draw the rest of it, as cells around holes.
        QVERIFY(isNear(boundOf({square}, {0, 1, 2}).stray, all));
        // Clockwise: a hole alone.
        QVERIFY(isNear(boundOf({{square[3], square[2], square[1], square[0]}}, {0, 1, 2, 0, 2, 3}).stray, all));
    }
};

QTEST_APPLESS_MAIN(ShapeBoundsTest)
#include "shape_bounds_test.moc"
