#include "tests/unit/tri/gpu/oracle.h"

#include <cstring>

#include "shaders/tri/predicates.h"

namespace shader::tri {

namespace {

/// The kernels as members, so that FOREST means one forest here as it does in a shader.
struct Kernels {
    const Forest& forest;
#define FOREST forest
#include "shaders/tri/access.h"
    // What needs access.h, in its order.
#include "shaders/tri/mesh.h"
    //
#include "shaders/tri/insert.h"
    //
#include "shaders/tri/flip.h"
    //
#include "shaders/tri/constrain.h"
    //
#include "shaders/tri/erase.h"
    //
#include "shaders/tri/advance.h"

    [[nodiscard]] uint awakeCount() const {
        return AWAKE_COUNT(STEP);
    }
    [[nodiscard]] uint awakeAt(uint i) const {
        return AWAKE_AT(i);
    }
    [[nodiscard]] uint electedAt(uint i) const {
        return ELECTED_AT(i);
    }
    [[nodiscard]] uint claimedAt(uint i) const {
        return CLAIMED_AT(i);
    }
};

}  // namespace

}  // namespace shader::tri

namespace tri::gpu {

namespace kernel = shader::tri;

Oracle::Oracle(const ForestData& data, CallOrder order) : m_forest(recordOf(data)), m_order(order) {
    for (const Column& column : columnsOf(data)) {
        std::vector<std::byte>& memory = m_memory.emplace_back(column.bytes + 1);
        if (column.initial != nullptr) {
            std::memcpy(memory.data(), column.initial, column.bytes);
        }
        const std::byte* address = memory.data();
        std::memcpy(reinterpret_cast<std::byte*>(&m_forest) + column.offset, &address, sizeof(address));
    }
    kernel::Kernels kernels{m_forest};
    forEach(m_forest.vertexCount, [&](std::uint32_t v) { kernels.initVertex(v, kernels.boxOf(v)); });
    forEach(m_forest.vertexCount + m_forest.rayCount, [&](std::uint32_t e) { m_forest.found.at[e] = 0; });
}

template <class Kernel>
void Oracle::forEach(std::uint32_t count, const Kernel& kernel) const {
    constexpr std::uint64_t kStride = 0x9E3779B1;  // a prime: visits every index below any smaller count once
    for (std::uint64_t i = 0; i < count; ++i) {
        switch (m_order) {
            case CallOrder::Forward: kernel(static_cast<std::uint32_t>(i)); break;
            case CallOrder::Backward: kernel(static_cast<std::uint32_t>(count - 1 - i)); break;
            case CallOrder::Scattered: kernel(static_cast<std::uint32_t>(i * kStride % count)); break;
        }
    }
}

void Oracle::insertRound() {
    kernel::Kernels kernels{m_forest};
    const std::uint32_t vertices = m_forest.vertexCount;
    forEach(vertices, [&](std::uint32_t q) { kernels.vote(q); });
    forEach(vertices, [&](std::uint32_t q) { kernels.claimPlace(q); });
    forEach(control().elected, [&](std::uint32_t i) { kernels.splitPlace(kernels.electedAt(i)); });
    forEach(2 * vertices, [&](std::uint32_t t) { kernels.fixLinks(t, kernel::kStageInsert); });
    forEach(vertices, [&](std::uint32_t p) { kernels.relocateInserted(p); });
}

void Oracle::contourRound() {
    kernel::Kernels kernels{m_forest};
    const std::uint32_t vertices = m_forest.vertexCount;
    forEach(2 * vertices, [&](std::uint32_t t) { kernels.findContours(t); });
    forEach(kernels.contourCount(), [&](std::uint32_t e) { kernels.claimCorridor(e); });
    forEach(kernels.contourCount(), [&](std::uint32_t e) { kernels.rebuildCorridor(e); });
    forEach(2 * vertices, [&](std::uint32_t t) { kernels.fixLinks(t, kernel::kStageRebuild); });
}

void Oracle::flipRound() {
    kernel::Kernels kernels{m_forest};
    forEach(kernels.awakeCount(), [&](std::uint32_t i) { kernels.testEdges(kernels.awakeAt(i)); });
    forEach(control().claimed, [&](std::uint32_t i) { kernels.flipEdge(kernels.claimedAt(i)); });
    forEach(control().claimed, [&](std::uint32_t i) { kernels.fixLinks(kernels.claimedAt(i), kernel::kStageFlip); });
    forEach(m_forest.vertexCount, [&](std::uint32_t p) { kernels.relocateFlipped(p); });
}

bool Oracle::step() {
    kernel::Kernels kernels{m_forest};
    kernels.advance();
    if (control().phase == kernel::kFinished) {
        return false;
    }
    if (control().insertGroups.x != 0) {
        insertRound();
    }
    if (control().edgeGroups.x != 0) {
        contourRound();
    }
    flipRound();
    while (kernels.isTail()) {
        kernels.beginStep();
        flipRound();
    }
    return true;
}

void Oracle::erase() {
    kernel::Kernels kernels{m_forest};
    const std::uint32_t slots = 2 * m_forest.vertexCount;
    forEach(slots, [&](std::uint32_t t) { kernels.decide(t); });
    forEach(slots, [&](std::uint32_t t) { kernels.prove(t); });
    std::uint32_t place = 0;
    for (std::uint32_t t = 0; t < slots; ++t) {
        kernels.writeKept(t, place);
        place += kernels.isKept(t) ? 1 : 0;
    }
    m_forest.control.at[0].kept = place;
}

std::vector<std::uint32_t> Oracle::meshAt(const kernel::Triangle& triangle) {
    if (triangle.corners.x == kernel::kNone) {
        return {};
    }
    return {triangle.corners.x, triangle.corners.y, triangle.corners.z,
            triangle.across.x,  triangle.across.y,  triangle.across.z};
}

std::vector<std::uint32_t> Oracle::trianglesOf(std::size_t tree) const {
    const std::uint32_t start = m_forest.trees.at[tree].start;
    const std::uint32_t end = tree + 1 < m_forest.treeCount ? m_forest.trees.at[tree + 1].start : control().kept;
    return {m_forest.kept.at + 3 * std::size_t{start}, m_forest.kept.at + 3 * std::size_t{end}};
}

}  // namespace tri::gpu
