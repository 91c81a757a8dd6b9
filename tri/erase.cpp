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

/// The work of one task: a run of triangles.
struct Chunk {
    std::uint32_t first = 0;
    std::uint32_t end = 0;
    std::size_t staying = 0;
    std::size_t borders = 0;
    std::vector<std::uint32_t> undecided;
    Status status;
};

/// Sets the states of the chunk's triangles and counts those that stay.
void decideChunk(const Mesh& mesh, const Contours& contours, std::uint8_t* states, Chunk& chunk) {
    for (std::uint32_t t = chunk.first; t < chunk.end; ++t) {
        states[t] = decide(mesh, contours, mesh.triangles[t]);
        chunk.staying += states[t] == kStays ? 1 : 0;
        if (states[t] == kUndecided) {
            chunk.undecided.push_back(t);
        }
    }
}

/// Writes the chunk's triangles that stay and counts contours along their borders; stops at a border without one.
void writeChunk(const Mesh& mesh, const Contours& contours, const std::uint8_t* states, Chunk& chunk,
                std::uint32_t* out) {
    for (std::uint32_t t = chunk.first; t < chunk.end; ++t) {
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
                    chunk.status = {Outcome::Crossing, contours.anyEdgeAt(mesh, from), contours.anyEdgeAt(mesh, to)};
                    return;
                }
                ++chunk.borders;
            }
        }
    }
}

/// Decides the triangles that no corner could tell, and counts them in.
void decideTheRest(const Mesh& mesh, std::uint8_t* states, std::vector<Chunk>& chunks) {
    for (const Chunk& chunk : chunks) {
        decideTheRest(mesh, states, chunk.undecided);
    }
    for (Chunk& chunk : chunks) {
        chunk.staying += static_cast<std::size_t>(
            std::ranges::count_if(chunk.undecided, [&](std::uint32_t t) { return states[t] == kStays; }));
    }
}

std::vector<Chunk> cut(std::uint32_t triangleCount, std::uint32_t pieces) {
    std::vector<Chunk> chunks(pieces);
    for (std::uint32_t i = 0; i < pieces; ++i) {
        chunks[i].first = static_cast<std::uint32_t>(std::uint64_t{triangleCount} * i / pieces);
        chunks[i].end = static_cast<std::uint32_t>(std::uint64_t{triangleCount} * (i + 1) / pieces);
    }
    return chunks;
}

/// Writes all chunks behind each other; a status other than Ok is the first one's.
Status writeAll(const Mesh& mesh, const Contours& contours, const std::uint8_t* states, std::vector<Chunk>& chunks,
                Cores cores, std::uint32_t* out) {
    std::vector<std::size_t> start(chunks.size() + 1, 0);
    for (std::size_t i = 0; i < chunks.size(); ++i) {
        start[i + 1] = start[i] + 3 * chunks[i].staying;
    }
    forEach(cores, chunks.size(),
            [&](std::size_t i) { writeChunk(mesh, contours, states, chunks[i], out + start[i]); });
    std::size_t borders = 0;
    for (const Chunk& chunk : chunks) {
        if (chunk.status.outcome != Outcome::Ok) {
            return chunk.status;
        }
        borders += chunk.borders;
    }
    return borders == contours.edgeCount() ? Status{} : findIdleEdge(mesh, contours, states);
}

}  // namespace

Status eraseOutside(const Mesh& mesh, const Contours& contours, Cores cores, Scratch<std::uint8_t>& scratch,
                    std::vector<std::uint32_t>& triangles) {
    std::uint8_t* states = scratch.room(mesh.triangleCount);
    std::vector<Chunk> chunks = cut(mesh.triangleCount, piecesFor(cores));
    forEach(cores, chunks.size(), [&](std::size_t i) { decideChunk(mesh, contours, states, chunks[i]); });
    decideTheRest(mesh, states, chunks);
    std::size_t staying = 0;
    for (const Chunk& chunk : chunks) {
        staying += chunk.staying;
    }
    const std::size_t before = triangles.size();
    triangles.resize(before + 3 * staying);
    Status status = writeAll(mesh, contours, states, chunks, cores, triangles.data() + before);
    if (status.outcome != Outcome::Ok) {
        triangles.resize(before);
    } else if (staying == 0) {
        status.outcome = Outcome::Degenerate;
    }
    return status;
}

}  // namespace tri
