#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "tri/triangulate.h"

/// Measuring the triangulators: sets of polygons that look like boards, and a run of all triangulators over them.
namespace tri::bench {

/// One polygon that owns its points.
struct Shape {
    std::vector<Point> points;
    std::vector<std::uint32_t> loopStart{0};

    void add(const std::vector<Point>& loop) {
        points.insert(points.end(), loop.begin(), loop.end());
        loopStart.push_back(static_cast<std::uint32_t>(points.size()));
    }
    [[nodiscard]] Polygon polygon() const { return {points, loopStart}; }
};

struct Set {
    std::string name;
    std::vector<Shape> shapes;
    [[nodiscard]] std::size_t vertexCount() const;
};

/// A square plane with about `holes` antipads of 32 corners, one in five a thermal relief of four annular slots of 18.
/// One half of them lies on a lattice, so that very many points lie on common circles; the others are off by a bit.
[[nodiscard]] Set plane(const std::string& name, int holes);

/// A pour with about `holes` holes: bundles of 20 long channels of traces, and antipads in between. The channels'
/// edges are far longer than the distance to the next vertex, so many are no Delaunay edges.
[[nodiscard]] Set pour(const std::string& name, int holes);

/// Many small areas: pads with rounded corners, tracks as capsules, rings, and ragged pieces of copper.
[[nodiscard]] Set areas(const std::string& name, int count);

/// The sets of docs/triangulation.md; without those of more than a million vertices unless `withHuge`.
[[nodiscard]] std::vector<Set> standardSets(bool withHuge);

}  // namespace tri::bench
