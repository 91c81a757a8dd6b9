// How dark bodies of components make the board around them.
#include "render/modelling/body_shadows.h"

#include <QtTest>
#include <cmath>
#include <random>

#include "model/base/parallel.h"
#include "render/modelling/board_model.h"

using render::BodyShadows;
using render::ShadowMap;

namespace {

/// A board of 40 by 20 mm with layers of bodies on top (0) and bottom (1), and a square of 2 by 2 mm to place on them.
render::BoardModel board() {
    render::BoardModel model;
    model.layers.resize(2);
    model.layers[0].growth = shader::kLayerGrowsUp;
    model.layers[1].growth = shader::kLayerGrowsDown;
    model.boxMin = {-20.0F, -10.0F, 0.0F};
    model.boxMax = {20.0F, 10.0F, 1.6F};
    model.vertices = {{-1.0F, -1.0F}, {1.0F, -1.0F}, {1.0F, 1.0F}, {-1.0F, 1.0F}};
    model.next = {1, 2, 3, 0};
    model.shapes.push_back({0, 4, 0, 0, 0, 4});
    return model;
}

shader::AreaInstance squareAt(glm::vec2 at, float height, std::uint32_t layer = 0) {
    shader::AreaInstance square{};
    square.origin = at;
    square.cosSin = {1.0F, 0.0F};
    square.layer = layer;
    square.height = height;
    return square;
}

ShadowMap topOf(std::vector<shader::AreaInstance> bodies) {
    render::BoardModel model = board();
    model.instances = std::move(bodies);
    return render::castShadows(model).top;
}

/// Of the corner nearest to a location; 0 beyond the map.
int darknessAt(const ShadowMap& map, glm::vec2 at) {
    const glm::ivec2 cell = glm::round((at - map.origin) / map.cellMm);
    const glm::ivec2 size(map.width, map.height);
    const bool isInside = cell.x >= 0 && cell.y >= 0 && cell.x < size.x && cell.y < size.y;
    return isInside ? static_cast<int>(map.cells[static_cast<std::size_t>(cell.y * size.x + cell.x)] & 0xffU) : 0;
}

/// At this distance from an outline that darkens as far as `reach`.
int expectedAt(float distance, float reach) {
    const float rest = std::max(1.0F - distance / reach, 0.0F);
    return static_cast<int>(std::lround(255.0F * rest * rest));
}

/// Where the square at the origin no longer makes the board darker, to its right.
float reachOf(float height) {
    const ShadowMap map = topOf({squareAt({0.0F, 0.0F}, height)});
    float reach = 0.0F;
    while (darknessAt(map, {1.0F + reach, 0.0F}) > 0) {
        reach += 0.1F;
    }
    return reach;
}

std::vector<shader::AreaInstance> manyBodies() {
    std::mt19937 random(7);
    std::uniform_real_distribution<float> x(-19.0F, 19.0F);
    std::uniform_real_distribution<float> y(-9.0F, 9.0F);
    std::uniform_real_distribution<float> height(0.1F, 6.0F);
    std::vector<shader::AreaInstance> bodies;
    for (std::uint32_t i = 0; i < 300; ++i) {
        bodies.push_back(squareAt({x(random), y(random)}, height(random), i % 2));
        const float angle = height(random);
        bodies.back().cosSin = {std::cos(angle), std::sin(angle)};
    }
    return bodies;
}

}  // namespace

class BodyShadowsTest : public QObject {
    Q_OBJECT

private slots:
    void theBoardIsDarkUnderABodyAndLighterAwayFromIt() {
        const ShadowMap map = topOf({squareAt({0.0F, 0.0F}, 2.0F)});
        QCOMPARE(map.cellMm, render::kFinestShadowCell);
        QCOMPARE(darknessAt(map, {0.0F, 0.0F}), 255);
        QCOMPARE(darknessAt(map, {-0.9F, 0.9F}), 255);
        constexpr float kReach = 1.8F;
        int last = 256;
        for (const float distance : {0.1F, 0.5F, 1.0F, 1.7F}) {
            const int darkness = darknessAt(map, {0.0F, 1.0F + distance});
            QVERIFY2(std::abs(darkness - expectedAt(distance, kReach)) <= 1, qPrintable(QString::number(darkness)));
            QVERIFY(darkness < last);
            last = darkness;
        }
        QCOMPARE(darknessAt(map, {0.0F, 2.9F}), 0);
        // Round the corner of a body it is the distance from that corner that counts.
        QVERIFY(std::abs(darknessAt(map, {1.3F, 1.4F}) - expectedAt(0.5F, kReach)) <= 1);
    }

    void tallBodiesReachFarther() {
        QVERIFY(std::abs(reachOf(0.05F) - render::kShortestShadow) < 0.11F);
        QVERIFY(std::abs(reachOf(1.0F) - 0.9F) < 0.11F);
        QVERIFY(std::abs(reachOf(50.0F) - render::kLongestShadow) < 0.21F);
    }

    void theDarkestOfSeveralBodiesCounts() {
        const ShadowMap map = topOf({squareAt({-2.0F, 0.0F}, 1.0F), squareAt({2.0F, 0.0F}, 4.0F)});
        QVERIFY(std::abs(darknessAt(map, {0.0F, 0.0F}) - expectedAt(1.0F, 3.0F)) <= 1);
    }

    void cellsHaveTheirFourCorners() {
        const ShadowMap map = topOf({squareAt({0.0F, 0.0F}, 2.0F)});
        const auto cell = [&](std::uint32_t x, std::uint32_t y) { return map.cells[y * map.width + x]; };
        for (std::uint32_t y = 0; y + 1 < map.height; ++y) {
            for (std::uint32_t x = 0; x + 1 < map.width; ++x) {
                QCOMPARE(cell(x, y) >> 8U & 0xffU, cell(x + 1, y) & 0xffU);
                QCOMPARE(cell(x, y) >> 16U & 0xffU, cell(x, y + 1) & 0xffU);
                QCOMPARE(cell(x, y) >> 24U, cell(x + 1, y + 1) & 0xffU);
            }
        }
    }

    void theRimIsNeverDark() {
        // A body across the edge of the board: the map ends with the board.
        const ShadowMap map = topOf({squareAt({-20.0F, 0.0F}, 5.0F)});
        QVERIFY(map.origin.x > -20.2F && map.origin.x < -20.0F);
        QVERIFY(darknessAt(map, {-19.9F, 0.0F}) == 255);
        for (std::uint32_t y = 0; y < map.height; ++y) {
            QCOMPARE(map.cells[y * map.width] & 0x00ff00ffU, 0U);
            QCOMPARE(map.cells[(y + 1) * map.width - 1] & 0xff00ff00U, 0U);
        }
        for (std::uint32_t x = 0; x < map.width; ++x) {
            QCOMPARE(map.cells[x] & 0x0000ffffU, 0U);
            QCOMPARE(map.cells[(map.height - 1) * map.width + x] & 0xffff0000U, 0U);
        }
    }

    void bodiesBesideTheBoardDarkenNothing() {
        for (const glm::vec2 at : {glm::vec2(30.0F, 0.0F), glm::vec2(-30.0F, 0.0F), glm::vec2(0.0F, 30.0F)}) {
            const ShadowMap map = topOf({squareAt(at, 0.5F), squareAt({0.0F, 0.0F}, 0.5F)});
            QCOMPARE(darknessAt(map, {0.0F, 0.0F}), 255);
            QCOMPARE(darknessAt(map, 0.3F * at), 0);
            QCOMPARE(darknessAt(map, {19.8F, 0.0F}), 0);
        }
    }

    /// Edges farther beyond the board than a shadow reaches darken nothing, on any side.
    void bodiesReachFarOutOfTheBoard() {
        for (const glm::vec2 at : {glm::vec2(-26.0F, 0.0F), glm::vec2(26.0F, 0.0F), glm::vec2(0.0F, -16.0F),
                                   glm::vec2(0.0F, 16.0F), glm::vec2(26.0F, 16.0F)}) {
            render::BoardModel model = board();
            for (glm::vec2& vertex : model.vertices) {
                vertex *= 10.0F;
            }
            model.instances = {squareAt(at, 0.5F)};
            const ShadowMap map = render::castShadows(model).top;
            QCOMPARE(darknessAt(map, glm::clamp(at, glm::vec2(-19.5F, -9.5F), glm::vec2(19.5F, 9.5F))), 255);
            QCOMPARE(darknessAt(map, -0.5F * at), 0);
        }
    }

    void eachSideHasItsOwn() {
        render::BoardModel model = board();
        model.instances = {squareAt({5.0F, 0.0F}, 1.0F, 0), squareAt({-5.0F, 0.0F}, 1.0F, 1)};
        const BodyShadows shadows = render::castShadows(model);
        QCOMPARE(darknessAt(shadows.top, {5.0F, 0.0F}), 255);
        QCOMPARE(darknessAt(shadows.top, {-5.0F, 0.0F}), 0);
        QCOMPARE(darknessAt(shadows.bottom, {5.0F, 0.0F}), 0);
        QCOMPARE(darknessAt(shadows.bottom, {-5.0F, 0.0F}), 255);
    }

    void whatDoesNotTouchTheBoardDarkensNothing() {
        shader::AreaInstance high = squareAt({0.0F, 0.0F}, 2.0F);
        high.floor = 1.0F;
        QVERIFY(topOf({high}).isEmpty());
        QVERIFY(topOf({}).isEmpty());
        QVERIFY(topOf({squareAt({100.0F, 0.0F}, 2.0F)}).isEmpty());  // beside the board
        render::BoardModel print = board();
        print.next = {0, 1, 2, 3};
        print.instances = {squareAt({0.0F, 0.0F}, 2.0F)};
        QVERIFY(render::castShadows(print).isEmpty());
        render::BoardModel copper = board();
        copper.layers[0].growth = 0;
        copper.instances = {squareAt({0.0F, 0.0F}, 2.0F)};
        QVERIFY(render::castShadows(copper).isEmpty());
    }

    void largeBoardsHaveCoarserCells() {
        render::BoardModel model = board();
        model.boxMin.x = -200.0F;
        model.boxMax.x = 200.0F;
        model.instances = {squareAt({-190.0F, 0.0F}, 0.1F), squareAt({190.0F, 0.0F}, 0.1F)};
        const ShadowMap map = render::castShadows(model).top;
        QVERIFY(map.width <= render::kMostShadowCells && map.width > render::kMostShadowCells - 10);
        // As soft as its cells allow.
        QVERIFY(darknessAt(map, glm::vec2(191.0F, 0.0F) + 1.2F * map.cellMm) > 0);
    }

    void oneThreadMakesTheSame() {
        render::BoardModel model = board();
        model.instances = manyBodies();
        const BodyShadows many = render::castShadows(model);
        const base::ThreadLimit limit(1);
        const BodyShadows one = render::castShadows(model);
        QVERIFY(!many.isEmpty());
        QCOMPARE(many.top.cells, one.top.cells);
        QCOMPARE(many.bottom.cells, one.bottom.cells);
    }
};

QTEST_APPLESS_MAIN(BodyShadowsTest)
#include "body_shadows_test.moc"
