#include "tests/gpu/synthetic_board.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <random>

#include "render/modelling/lets.h"
#include "tri/triangulate.h"

namespace render::test {
namespace {

constexpr float kPi = std::numbers::pi_v<float>;
constexpr float kMmPerUnit = 1e-3F;  // loops are in micrometres

void appendLets(BoardModel& model, const std::vector<shader::Let>& lets, std::uint32_t layer) {
    const auto firstCluster = static_cast<std::uint32_t>(model.clusters.size());
    for (std::size_t i = 0; i < lets.size(); i += shader::kClusterSize) {
        const auto count = static_cast<std::uint32_t>(std::min<std::size_t>(shader::kClusterSize, lets.size() - i));
        shader::Cluster cluster{
            glm::vec2(1e30F), glm::vec2(-1e30F), static_cast<std::uint32_t>(model.lets.size()), count, layer, 0};
        for (std::size_t k = i; k < i + count; ++k) {
            const Box2 box = boxOf(lets[k]);
            cluster.boxMin = glm::min(cluster.boxMin, box.min);
            cluster.boxMax = glm::max(cluster.boxMax, box.max);
            model.lets.push_back(lets[k]);
        }
        model.clusters.push_back(cluster);
    }
    model.clustersOfLayer.push_back({firstCluster, static_cast<std::uint32_t>(model.clusters.size()) - firstCluster});
}

shader::AreaInstance place(glm::vec2 origin, float clockwise = 0.0F, bool isMirrored = false) {
    return {origin, {std::cos(clockwise), std::sin(clockwise)}, 0, 0, 0, isMirrored ? 1U : 0U, 0.0F, 0, 0.0F, 0};
}

std::vector<base::Point> box(base::Nm x0, base::Nm y0, base::Nm x1, base::Nm y1) {
    return {{x0, y0}, {x1, y0}, {x1, y1}, {x0, y1}};
}

std::vector<base::Point> reversed(std::vector<base::Point> loop) {
    std::reverse(loop.begin(), loop.end());
    return loop;
}

}  // namespace

void SyntheticBoard::addLayer(float z0, float z1, const glm::vec3& colour, float opacity) {
    FrameLayer& layer = m_model.layers.emplace_back();
    layer.z0 = z0;
    layer.z1 = z1;
    m_styles.push_back({colour, opacity, true});
    m_lets.emplace_back();
    m_batches.emplace_back();
}

std::uint32_t SyntheticBoard::addLet(shader::Let let) {
    let.meta |= static_cast<std::uint32_t>(m_lets.size() - 1) << shader::kLetLayerShift;
    let.element = m_elements;
    m_lets.back().push_back(let);
    return m_elements++;
}

std::uint32_t SyntheticBoard::addTrack(glm::vec2 a, glm::vec2 b, float radius, float innerRadius, std::uint32_t flags) {
    return addLet({a.x, a.y, b.x, b.y, radius, innerRadius, shader::kLetStadium | flags, 0});
}

std::uint32_t SyntheticBoard::addDisc(glm::vec2 centre, float radius, float innerRadius, std::uint32_t flags) {
    return addTrack(centre, centre, radius, innerRadius, flags);
}

std::uint32_t SyntheticBoard::addArc(glm::vec2 centre, float arcRadius, float start, float sweep, float penRadius) {
    return addLet({centre.x, centre.y, arcRadius, start, sweep, penRadius, shader::kLetArc, 0});
}

std::uint32_t SyntheticBoard::addHole(glm::vec2 centre, float radius, float cell, float turn) {
    const auto reach = static_cast<std::uint32_t>(cell * static_cast<float>(shader::kCellUnitsPerMm));
    const float reaches = std::bit_cast<float>(reach | reach << 16U);
    return addLet({centre.x, centre.y, reaches, reaches, std::tan(0.5F * turn), radius, shader::kLetHole, 0});
}

std::uint32_t SyntheticBoard::addArea(const std::vector<std::vector<base::Point>>& loops,
                                      const std::vector<shader::AreaInstance>& locations) {
    std::vector<base::Point> points;
    std::vector<std::uint32_t> starts{0};
    AreaShape shape;
    shape.firstVertex = static_cast<std::uint32_t>(m_model.vertices.size());
    shape.firstIndex = static_cast<std::uint32_t>(m_model.indices.size());
    for (const auto& loop : loops) {
        const std::uint32_t first = shape.firstVertex + starts.back();
        for (std::uint32_t i = 0; i < loop.size(); ++i) {
            points.push_back(loop[i]);
            m_model.vertices.push_back(kMmPerUnit * glm::vec2(loop[i].x, loop[i].y));
            m_model.next.push_back(first + (i + 1) % static_cast<std::uint32_t>(loop.size()));
        }
        starts.push_back(static_cast<std::uint32_t>(points.size()));
    }
    shape.vertexCount = shape.wallCount = starts.back();
    shape.firstWall = shape.firstVertex;
    const tri::Outcome outcome = tri::triangulate({points, starts}, tri::Triangulator::Auto, m_model.indices).outcome;
    ASSERT(outcome == tri::Outcome::Ok);
    shape.triangleCount = (static_cast<std::uint32_t>(m_model.indices.size()) - shape.firstIndex) / 3;

    const auto layer = static_cast<std::uint32_t>(m_lets.size() - 1);
    AreaBatch batch{static_cast<std::uint32_t>(m_model.shapes.size()), layer,
                    static_cast<std::uint32_t>(m_model.instances.size()), static_cast<std::uint32_t>(locations.size())};
    for (shader::AreaInstance instance : locations) {
        instance.shape = batch.shape;
        instance.layer = layer;
        instance.element = m_elements;
        m_model.instances.push_back(instance);
    }
    m_model.shapes.push_back(shape);
    m_batches.back().push_back(static_cast<std::uint32_t>(m_model.areaBatches.size()));
    m_model.areaBatches.push_back(batch);
    return m_elements++;
}

BoardModel SyntheticBoard::build() const {
    BoardModel model = m_model;
    model.elementCount = m_elements;
    model.boxMin = glm::vec3(1e30F);
    model.boxMax = glm::vec3(-1e30F);
    for (std::uint32_t layer = 0; layer < m_lets.size(); ++layer) {
        appendLets(model, m_lets[layer], layer);
        const std::uint32_t first = m_batches[layer].empty() ? 0 : m_batches[layer].front();
        model.areaBatchesOfLayer.push_back({first, static_cast<std::uint32_t>(m_batches[layer].size())});
        model.layers[layer].hasAreas = !m_batches[layer].empty();
        model.boxMin.z = std::min(model.boxMin.z, model.layers[layer].z0);
        model.boxMax.z = std::max(model.boxMax.z, model.layers[layer].z1);
    }
    for (const shader::Cluster& cluster : model.clusters) {
        model.boxMin = glm::vec3(glm::min(glm::vec2(model.boxMin), cluster.boxMin), model.boxMin.z);
        model.boxMax = glm::vec3(glm::max(glm::vec2(model.boxMax), cluster.boxMax), model.boxMax.z);
    }
    return model;
}

SyntheticBoard everything() {
    SyntheticBoard board;
    // Bottom copper, laminate, top copper, mask, drill: as a two-layer board stacks them.
    board.addLayer(0.0F, 0.035F, {0.2F, 0.35F, 0.8F});
    board.addTrack({-15, -10}, {15, -8}, 0.6F);
    board.addArc({0, 0}, 9.0F, 0.3F, 1.4F, 0.5F);
    board.addLayer(0.035F, 1.565F, {0.25F, 0.45F, 0.25F}, 0.5F);
    board.addArea({box(-20000, -15000, 20000, 15000), reversed(box(6000, 2000, 12000, 7000))}, {place({0, 0})});
    board.addLayer(1.565F, 1.6F, {0.8F, 0.25F, 0.2F});
    board.addTrack({-15, 8}, {-5, 12}, 0.5F);
    board.addTrack({-15, 4}, {-5, 4}, 0.8F, 0.5F);
    board.addTrack({-15, 0}, {-6, 2}, 0.7F, 0.0F, shader::kLetSquarePen);
    board.addTrack({-15, -4}, {-6, -4}, 0.5F, 0.0F, shader::kLetSquarePen);
    board.addDisc({0, 8}, 1.5F);
    board.addDisc({4, 8}, 1.5F, 0.0F, shader::kLetSquarePen);
    board.addDisc({0, 3}, 1.2F, 0.6F);
    board.addHole({12, 8}, 1.0F, 1.4F, 0.3F);
    board.addHole({16, 8}, 0.2F, 1.0F);
    board.addArc({2, -4}, 4.0F, 0.0F, kPi / 2, 0.4F);
    board.addArc({2, -4}, 3.0F, kPi, -kPi / 2, 0.3F);
    board.addArc({2, -4}, 0.2F, 1.0F, 1.0F, 0.2F);
    board.addArea({box(-1500, -800, 1500, 800), reversed(box(-500, -300, 500, 300))},
                  {place({12, -6}, 0.4F), place({15, -10}, 1.2F, true)});
    board.addLayer(1.6F, 1.62F, {0.1F, 0.5F, 0.2F}, 0.6F);
    board.addArea({box(-18000, -13000, 5000, 13000)}, {place({0, 0})});
    board.addTrack({3, -12}, {12, -12}, 1.0F);
    board.addDisc({5, -12}, 1.5F);
    board.addLayer(0.0F, 1.6F, {0.8F, 0.7F, 0.3F});
    board.addDisc({0, 3}, 0.6F, 0.5F);
    board.addDisc({0, 3}, 0.5F, 0.0F, shader::kLetBore);
    board.addDisc({-18, -12}, 1.0F, 1.0F);
    board.addDisc({-18, -12}, 1.0F, 0.0F, shader::kLetBore);
    return board;
}

SyntheticBoard randomTraces(int count, std::uint32_t seed) {
    std::mt19937 random(seed);
    const auto between = [&](float low, float high) {
        return low + (high - low) * static_cast<float>(random() % 100000) * 1e-5F;
    };
    SyntheticBoard board;
    board.addLayer(0.0F, 0.035F, {0.8F, 0.25F, 0.2F});
    for (int i = 0; i < count; ++i) {
        const glm::vec2 a{between(-50, 50), between(-30, 30)};
        const float radius = between(0.05F, 0.6F);
        switch (random() % 4) {
            case 0: board.addDisc(a, radius); break;
            case 1: board.addDisc(a, radius, radius * 0.5F); break;
            case 2: board.addArc(a, between(0.7F, 4.0F), between(0, 6), between(-1.5F, 1.5F), radius); break;
            default: board.addTrack(a, a + glm::vec2(between(-5, 5), between(-5, 5)), radius); break;
        }
    }
    return board;
}

std::size_t differingPixels(const Image& a, const Image& b, int threshold) {
    ASSERT(a.rgba.size() == b.rgba.size());
    std::size_t count = 0;
    for (std::size_t i = 0; i < a.rgba.size(); i += 4) {
        bool differs = false;
        for (std::size_t c = 0; c < 3; ++c) {
            differs = differs || std::abs(int{a.rgba[i + c]} - int{b.rgba[i + c]}) > threshold;
        }
        count += differs ? 1 : 0;
    }
    return count;
}

std::size_t whitePixels(const Image& image) {
    std::size_t count = 0;
    for (std::size_t i = 0; i < image.rgba.size(); i += 4) {
        count += image.rgba[i] > 127 ? 1 : 0;
    }
    return count;
}

}  // namespace render::test
