#include "tri/erase.h"

#include <algorithm>

namespace tri {

namespace {

using Side = Contours::Side;

enum State : std::uint8_t { kErased, kStays, kUndecided };

/// Looks from the corners until one of them knows. Only corners without any contour do not.
State decideOne(const Mesh& mesh, const Contours& contours, const Triangle& t) {
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
void decideByNeighbours(const Mesh& mesh, std::uint8_t* states, const std::vector<std::uint32_t>& undecided) {
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

/// A contour edge that does not have the inside on its left and the outside on its right.
Status findIdleEdge(const Mesh& mesh, const Contours& contours, const Scratch<std::uint8_t>& states) {
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

Eraser::Eraser(const Mesh& mesh, const Contours& contours, Cores cores, Scratch<std::uint8_t>& states)
    : m_mesh(mesh), m_contours(contours), m_cores(cores), m_states(states), m_chunks(piecesFor(cores)) {
    const std::uint64_t pieces = m_chunks.size();
    for (std::uint64_t i = 0; i < pieces; ++i) {
        m_chunks[i].first = static_cast<std::uint32_t>(mesh.triangleCount * i / pieces);
        m_chunks[i].end = static_cast<std::uint32_t>(mesh.triangleCount * (i + 1) / pieces);
    }
}

std::size_t Eraser::decide() {
    m_states.room(m_mesh.triangleCount);
    forEach(m_cores, m_chunks.size(), [&](std::size_t i) { decideChunk(m_chunks[i]); });
    std::size_t present = 0;
    for (const Chunk& chunk : m_chunks) {
        present += chunk.present;
    }
    return present;
}

void Eraser::decideChunk(Chunk& chunk) {
    chunk.present = 0;
    chunk.staying = 0;
    chunk.undecided.clear();
    for (std::uint32_t t = chunk.first; t < chunk.end; ++t) {
        const Triangle& triangle = m_mesh.triangles[t];
        for (std::uint32_t i = 0; i < 3; ++i) {
            chunk.present += m_contours.has(triangle.v[i], triangle.v[kNext[i]]) ? 1 : 0;
        }
        const State state = decideOne(m_mesh, m_contours, triangle);
        m_states[t] = state;
        chunk.staying += state == kStays ? 1 : 0;
        if (state == kUndecided) {
            chunk.undecided.push_back(t);
        }
    }
}

/// Decides the triangles that no corner could tell, and counts them in.
void Eraser::decideTheRest() {
    for (const Chunk& chunk : m_chunks) {
        decideByNeighbours(m_mesh, m_states.data(), chunk.undecided);
    }
    for (Chunk& chunk : m_chunks) {
        chunk.staying += static_cast<std::size_t>(
            std::ranges::count_if(chunk.undecided, [&](std::uint32_t t) { return m_states[t] == kStays; }));
    }
}

Status Eraser::write(std::vector<std::uint32_t>& triangles) {
    decideTheRest();
    const std::size_t before = triangles.size();
    std::size_t end = before;
    for (Chunk& chunk : m_chunks) {
        chunk.firstOut = end;
        end += 3 * chunk.staying;
    }
    triangles.resize(end);
    forEach(m_cores, m_chunks.size(),
            [&](std::size_t i) { writeChunk(m_chunks[i], triangles.data() + m_chunks[i].firstOut); });
    Status status = conclude();
    if (status.outcome != Outcome::Ok) {
        triangles.resize(before);
    } else if (end == before) {
        status.outcome = Outcome::Degenerate;
    }
    return status;
}

/// Writes the chunk's triangles that stay and counts contours along their borders; stops at a border without one.
void Eraser::writeChunk(Chunk& chunk, std::uint32_t* out) const {
    for (std::uint32_t t = chunk.first; t < chunk.end; ++t) {
        if (m_states[t] != kStays) {
            continue;
        }
        const Triangle& triangle = m_mesh.triangles[t];
        for (std::uint32_t i = 0; i < 3; ++i) {
            *out++ = m_mesh.ids[triangle.v[i]];
            if (m_states[triangle.across[i].triangle()] != kStays) {
                const std::uint32_t from = triangle.v[kNext[i]];
                const std::uint32_t to = triangle.v[kPrevious[i]];
                if (!m_contours.has(from, to)) {
                    chunk.status = {Outcome::Crossing, m_contours.anyEdgeAt(m_mesh, from),
                                    m_contours.anyEdgeAt(m_mesh, to)};
                    return;
                }
                ++chunk.borders;
            }
        }
    }
}

/// What the chunks found; a status other than Ok is the first one's.
Status Eraser::conclude() const {
    std::size_t borders = 0;
    for (const Chunk& chunk : m_chunks) {
        if (chunk.status.outcome != Outcome::Ok) {
            return chunk.status;
        }
        borders += chunk.borders;
    }
    return borders == m_contours.edgeCount() ? Status{} : findIdleEdge(m_mesh, m_contours, m_states);
}

}  // namespace tri
