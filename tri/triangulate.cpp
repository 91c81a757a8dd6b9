#include "tri/triangulate.h"

#include <algorithm>
#include <array>

#include "model/base/assert.h"
#include "tri/cdt.h"
#include "tri/cdt_cgal.h"
#include "tri/threads.h"

namespace tri {

namespace {

constexpr std::array<std::string_view, 5> kNames = {"auto", "cpu", "parallel", "cgal", "gpu"};

/// Scatters a number over all 64 bits (the finaliser of a xorshift-multiply generator).
std::uint64_t scatter(std::uint64_t value) {
    value = (value ^ value >> 30) * 0xBF58476D1CE4E5B9U;
    value = (value ^ value >> 27) * 0x94D049BB133111EBU;
    return value ^ value >> 31;
}

}  // namespace

std::string_view nameOf(Triangulator triangulator) {
    return kNames[static_cast<std::size_t>(triangulator)];
}

std::optional<Triangulator> triangulatorNamed(std::string_view name) {
    const auto found = std::ranges::find(kNames, name);
    return found == kNames.end() ? std::nullopt : std::optional(static_cast<Triangulator>(found - kNames.begin()));
}

Status triangulate(const Polygon& polygon, Triangulator triangulator, std::vector<std::uint32_t>& triangles) {
    switch (triangulator) {
        case Triangulator::Cgal: return triangulateCgal(polygon, triangles);
        case Triangulator::Parallel: return triangulateParallel(polygon, triangles);
        case Triangulator::Cpu: return triangulateCpu(polygon, triangles);
        case Triangulator::Gpu: ASSERT(false && "many polygons at once: tri/gpu/triangulator.h"); break;
        case Triangulator::Auto: break;
    }
    return coresFor(polygon.points.size()) == Cores::One ? triangulateCpu(polygon, triangles)
                                                         : triangulateParallel(polygon, triangles);
}

std::uint64_t triangleSetHash(std::span<const std::uint32_t> triangles) {
    std::uint64_t sum = triangles.size();
    for (std::size_t i = 0; i + 2 < triangles.size(); i += 3) {
        const std::uint32_t corners[] = {triangles[i], triangles[i + 1], triangles[i + 2]};
        const std::size_t first = static_cast<std::size_t>(std::ranges::min_element(corners) - corners);
        const std::uint64_t rest = std::uint64_t{corners[(first + 1) % 3]} << 32 | corners[(first + 2) % 3];
        sum += scatter(scatter(rest) + corners[first]);  // a sum does not depend on the order
    }
    return sum;
}

}  // namespace tri
