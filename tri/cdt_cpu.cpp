#include "tri/cdt_cpu.h"

#include "tri/delaunay.h"
#include "tri/insertion.h"
#include "tri/workspace.h"

namespace tri {

Status triangulateCpu(const Polygon& polygon, std::vector<std::uint32_t>& triangles) {
    thread_local Workspace workspace;
    Status status = workspace.start(polygon, Cores::One);
    if (status.outcome == Outcome::Ok) {
        Mesh& mesh = workspace.mesh;
        startInBox(mesh);
        Insertion insertion(mesh, Everywhere{}, 0);
        for (std::uint32_t q = 0; q < mesh.vertexCount; ++q, mesh.triangleCount += 2) {
            insertion.insert(q, mesh.triangleCount);
        }
        status = workspace.finish(Cores::One, triangles);
    }
    workspace.trim();
    return status;
}

}  // namespace tri
