#include "tri/workspace.h"

#include "model/base/assert.h"
#include "tri/constraints.h"
#include "tri/delaunay.h"
#include "tri/erase.h"

namespace tri {

namespace {

constexpr std::size_t kMaxKeptBytes = 64U << 20;
/// A triangle's number has 30 bits in an EdgeRef.
constexpr std::size_t kMaxPoints = (1U << 29) - 8;

}  // namespace

Status Workspace::start(const Polygon& polygon, Cores cores) {
    const std::size_t count = polygon.points.size();
    ASSERT(polygon.loopStart.empty() || polygon.loopStart.back() == count);
    ASSERT(count <= kMaxPoints);
    if (polygon.loopStart.size() < 2 || count < 3) {
        return {Outcome::Degenerate, kNoEdge, kNoEdge};
    }
    mesh.triangles.room(2 * (count + kBoxCorners));
    mesh.points.room(count + kBoxCorners);
    mesh.ids.room(count + kBoxCorners);
    const VertexOrder order = orderVertices(polygon.points, cores, mesh, vertexOf.room(count + kBoxCorners));
    contours.build(polygon, mesh, vertexOf.data(), order.merged);
    roundStart = order.roundStart;
    return {contours.edgeCount() == 0 ? Outcome::Degenerate : Outcome::Ok, kNoEdge, kNoEdge};
}

Status Workspace::finish(Cores cores, std::vector<std::uint32_t>& triangles) {
    const Status inserted = insertContours(mesh, contours, cores, states, vertexOf);
    if (inserted.outcome != Outcome::Ok) {
        return inserted;
    }
    return eraseOutside(mesh, contours, cores, states, triangles);
}

std::size_t Workspace::bytes() const {
    return mesh.triangles.bytes() + mesh.points.bytes() + mesh.ids.bytes() + contours.bytes() + vertexOf.bytes() +
           states.bytes();
}

void Workspace::trim() {
    if (bytes() > kMaxKeptBytes) {
        *this = {};
    }
}

}  // namespace tri
