#include "render/modelling/edge_grid.h"

#include <QtTest>
#include <cmath>
#include <random>

using render::Edge;
using render::EdgeGrid;

namespace {

std::mt19937 g_random(3);

float any(float low, float high) {
    return std::uniform_real_distribution<float>(low, high)(g_random);
}

/// A star around a place: a loop that does not cross itself.
void addStar(glm::vec2 centre, float size, int corners, std::vector<Edge>& edges) {
    std::vector<glm::vec2> loop;
    for (int i = 0; i < corners; ++i) {
        const float angle = 6.2831853F * static_cast<float>(i) / static_cast<float>(corners);
        loop.push_back(centre + any(0.4F, 1.0F) * size * glm::vec2(std::cos(angle), std::sin(angle)));
    }
    for (std::size_t i = 0; i < loop.size(); ++i) {
        edges.push_back({loop[i], loop[(i + 1) % loop.size()]});
    }
}

/// A large loop with small ones in it.
std::vector<Edge> board() {
    std::vector<Edge> edges;
    addStar({10.0F, -5.0F}, 100.0F, 30, edges);
    for (int i = 0; i < 12; ++i) {
        addStar({any(-15.0F, 35.0F), any(-30.0F, 20.0F)}, any(0.2F, 1.5F), 12, edges);
    }
    return edges;
}

bool isInside(const std::vector<Edge>& edges, glm::vec2 p) {
    bool isIn = false;
    for (const auto& [a, b] : edges) {
        if ((a.y > p.y) != (b.y > p.y)) {
            isIn ^= p.x < a.x + (p.y - a.y) / (b.y - a.y) * (b.x - a.x);
        }
    }
    return isIn;
}

/// From the nearest of many places on the edges to a box.
float sampledDistance(const std::vector<Edge>& edges, glm::vec2 low, glm::vec2 high) {
    constexpr int kSteps = 64;
    float nearest = 1e9F;
    for (const auto& [a, b] : edges) {
        for (int i = 0; i <= kSteps; ++i) {
            const glm::vec2 p = glm::mix(a, b, static_cast<float>(i) / kSteps);
            nearest = std::min(nearest, glm::length(p - glm::clamp(p, low, high)));
        }
    }
    return nearest;
}

}  // namespace

class EdgeGridTest : public QObject {
    Q_OBJECT

private slots:
    void placesAreInsideByTheEvenOddRule() {
        const std::vector<Edge> edges = board();
        const EdgeGrid grid(edges);
        int inside = 0;
        for (int i = 0; i < 5000; ++i) {
            const glm::vec2 p{any(-120.0F, 140.0F), any(-130.0F, 120.0F)};
            QCOMPARE(grid.contains(p), isInside(edges, p));
            inside += grid.contains(p) ? 1 : 0;
        }
        QVERIFY(inside > 500 && inside < 4500);
    }

    void distancesAreThoseToTheNearestEdge() {
        const std::vector<Edge> edges = board();
        const EdgeGrid grid(edges);
        int near = 0;
        for (int i = 0; i < 1500; ++i) {
            const glm::vec2 low{any(-120.0F, 140.0F), any(-130.0F, 120.0F)};
            const glm::vec2 high = low + glm::vec2(any(0.0F, 6.0F), any(0.0F, 6.0F));
            constexpr float kReach = 2.0F;
            constexpr float kSampling = 1.0F;  // mm: the longest edges are some 60 mm in 64 steps
            const float found = grid.distance(low, high, kReach);
            const float sampled = sampledDistance(edges, low, high);
            QVERIFY(found <= std::min(kReach, sampled) + 1e-3F);
            QVERIFY(found >= std::min(kReach, sampled - kSampling) - 1e-3F);
            near += found < kReach ? 1 : 0;
            // A line that is no longer than a place has the same distance as a box that is none.
            QVERIFY(std::abs(grid.distance(Edge{low, low}, kReach) - grid.distance(low, low, kReach)) < 1e-3F);
        }
        QVERIFY(near > 100);
    }

    void withoutEdgesNothingIsInsideOrNear() {
        const EdgeGrid grid({});
        QVERIFY(!grid.contains({0.0F, 0.0F}));
        QCOMPARE(grid.distance({0.0F, 0.0F}, {1.0F, 1.0F}, 2.0F), 2.0F);
    }
};

QTEST_APPLESS_MAIN(EdgeGridTest)
#include "edge_grid_test.moc"
