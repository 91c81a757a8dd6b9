#include "tri/erase.h"

#include <algorithm>

namespace tri {

namespace {

using Side = Contours::Side;

enum State : std::uint8_t { kErased, kStays, kUndecided };

/// Looks from the corners until one of them knows. Only corners without any contour do not.
State decide(const Mesh& mesh, const Contours& contours, const Triangle& t) {
    if (std::max({t.v[0], t.v[1], t.v[2]}) >= mesh.vertexCount) {
        return kErased;
    }
    for (std::uint32_t i = 0; i < 3; ++i) {
        const Side side = contours.sideAt(mesh, t.v[i], t.v[kNext[i]]);
        if (side != Side::Unknown) {
            return side == Side::Inside ? kStays : kErased;
        }
    }
    return kUndecided;
}

/// Gives the state of a triangle to all undecided ones that can be reached from it.
void flood(const Mesh& mesh, std::uint8_t* states, std::vector<std::uint32_t>& stack, std::uint32_t from) {
    stack.assign(1, from);
    while (!stack.empty()) {
        const std::uint32_t t = stack.back();
        stack.pop_back();
        for (const EdgeRef across : mesh.triangles[t].across) {
            if (across != kOutside && states[across.triangle()] == kUndecided) {
                states[across.triangle()] = states[t];
                stack.push_back(across.triangle());
            }
        }
    }
}

/// An edge with an undecided triangle has two free ends, so it is no contour: the other side lies where this one lies.
void decideTheRest(const Mesh& mesh, std::uint8_t* states, const std::vector<std::uint32_t>& undecided) {
    std::vector<std::uint32_t> stack;
    for (const std::uint32_t t : undecided) {
        for (const EdgeRef across : mesh.triangles[t].across) {
            if (states[t] == kUndecided && states[across.triangle()] != kUndecided) {
                states[t] = states[across.triangle()];
                flood(mesh, states, stack, t);
            }
        }
    }
}

/// Sets the state of every triangle; returns how many stay.
std::size_t decideAll(const Mesh& mesh, const Contours& contours, std::uint8_t* states) {
    std::vector<std::uint32_t> undecided;
    for (std::uint32_t t = 0; t < mesh.triangleCount; ++t) {
        states[t] = decide(mesh, contours, mesh.triangles[t]);
        if (states[t] == kUndecided) {
            undecided.push_back(t);
        }
    }
    decideTheRest(mesh, states, undecided);
    return static_cast<std::size_t>(std::count(states, states + mesh.triangleCount, kStays));
}

/// A contour edge that does not have the inside on its left and the outside on its right.
Status findIdleEdge(const Mesh& mesh, const Contours& contours, const std::uint8_t* states) {
    for (std::uint32_t t = 0; t < mesh.triangleCount; ++t) {
        const Triangle& triangle = mesh.triangles[t];
        for (std::uint32_t i = 0; i < 3; ++i) {
            const std::uint32_t from = triangle.v[kNext[i]];
            const std::uint32_t to = triangle.v[kPrevious[i]];
            const bool isBorder = states[t] == kStays && states[triangle.across[i].triangle()] != kStays;
            if (!isBorder && contours.has(from, to)) {
                const std::uint32_t edge = contours.inputEdge(mesh, from, to);
                return {Outcome::Crossing, edge, edge};
            }
        }
    }
    return {Outcome::Crossing, kNoEdge, kNoEdge};
}

}  // namespace

Status eraseOutside(const Mesh& mesh, const Contours& contours, Scratch<std::uint8_t>& scratch,
                    std::vector<std::uint32_t>& triangles) {
    std::uint8_t* states = scratch.room(mesh.triangleCount);
    const std::size_t before = triangles.size();
    triangles.resize(before + 3 * decideAll(mesh, contours, states));
    std::uint32_t* out = triangles.data() + before;
    std::size_t borders = 0;
    for (std::uint32_t t = 0; t < mesh.triangleCount; ++t) {
        if (states[t] != kStays) {
            continue;
        }
        const Triangle& triangle = mesh.triangles[t];
        for (std::uint32_t i = 0; i < 3; ++i) {
            *out++ = mesh.ids[triangle.v[i]];
            if (states[triangle.across[i].triangle()] != kStays) {
                const std::uint32_t from = triangle.v[kNext[i]];
                const std::uint32_t to = triangle.v[kPrevious[i]];
                if (!contours.has(from, to)) {
                    triangles.resize(before);
                    return {Outcome::Crossing, contours.anyEdgeAt(mesh, from), contours.anyEdgeAt(mesh, to)};
                }
                ++borders;
            }
        }
    }
    if (borders != contours.edgeCount()) {
        triangles.resize(before);
        return findIdleEdge(mesh, contours, states);
    }
    return {triangles.size() == before ? Outcome::Degenerate : Outcome::Ok, kNoEdge, kNoEdge};
}

}  // namespace tri
