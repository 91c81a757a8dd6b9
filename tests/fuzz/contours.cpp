#include "contours.h"

#include <algorithm>
#include <cstdint>
#include <vector>

#include "model/base/assert.h"
#include "tests/unit/tri/gpu/oracle.h"
#include "tri/verify.h"

namespace fuzz {

namespace {

using tri::Outcome;
using Triangles = std::vector<std::uint32_t>;

/// More would only take longer: everything that can go wrong goes wrong with a few points.
constexpr std::size_t kMaxPoints = 600;
constexpr int kMaxSteps = 100'000;

struct Loops {
    std::vector<base::Point> points;
    std::vector<std::uint32_t> loopStart{0};

    void close() { loopStart.push_back(static_cast<std::uint32_t>(points.size())); }
    [[nodiscard]] tri::Polygon polygon() const { return {points, loopStart}; }
};

/// Characters are numbers from -128 to 127 around '@'; the first one says how many bits they are shifted, up to the
/// largest coordinates there are.
Loops parse(std::string_view input) {
    Loops loops;
    if (input.empty()) {
        return loops;
    }
    const int shift = static_cast<unsigned char>(input[0]) % 24;
    const auto number = [&](char c) { return (static_cast<signed char>(c - '@')) * (1 << shift); };
    for (std::size_t i = 1; i + 1 < input.size() && loops.points.size() < kMaxPoints;) {
        if (input[i] == '\n') {
            loops.close();
            ++i;
        } else {
            loops.points.push_back({number(input[i]), number(input[i + 1])});
            i += 2;
        }
    }
    loops.close();
    return loops;
}

void checkOthers(const tri::Polygon& polygon, const tri::Status& expected, std::uint64_t hash) {
    for (const tri::Triangulator triangulator : tri::kTriangulators) {
        Triangles triangles;
        const tri::Status status = tri::triangulate(polygon, triangulator, triangles);
        // cdt_cgal.h: a contour across the cancelled part of an edge is in CGAL's way.
        if (triangulator == tri::Triangulator::Cgal && status.outcome == Outcome::Crossing) {
            continue;
        }
        ASSERT(status.outcome == expected.outcome);
        ASSERT(tri::triangleSetHash(triangles) == hash);
    }
}

void checkKernels(const tri::Polygon& polygon, const tri::Status& expected, std::uint64_t hash) {
    const tri::gpu::ForestData data = tri::gpu::plant({&polygon, 1}, tri::gpu::Eraser::Sector);
    tri::gpu::Oracle oracle(data, tri::gpu::CallOrder::Scattered);
    int steps = 0;
    while (oracle.step()) {
        ASSERT(++steps < kMaxSteps);
    }
    oracle.erase();
    if (oracle.forest().trees.at[0].flags == 0 && oracle.control().kept > 0) {
        ASSERT(expected.outcome == Outcome::Ok);
        ASSERT(tri::triangleSetHash(oracle.trianglesOf(0)) == hash);
    }
}

}  // namespace

void contours(std::string_view input) {
    const Loops loops = parse(input);
    const tri::Polygon polygon = loops.polygon();
    Triangles triangles;
    const tri::Status status = tri::triangulate(polygon, tri::Triangulator::Cpu, triangles);
    ASSERT(status.outcome == Outcome::Ok || triangles.empty());
    ASSERT(status.outcome != Outcome::Ok || tri::verify(polygon, triangles) == tri::Fault::None);
    const std::uint64_t hash = tri::triangleSetHash(triangles);
    checkOthers(polygon, status, hash);
    checkKernels(polygon, status, hash);
}

}  // namespace fuzz
