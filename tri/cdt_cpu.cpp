#include "tri/cdt_cpu.h"

#include "tri/delaunay.h"
#include "tri/workspace.h"

namespace tri {

Status triangulateCpu(const Polygon& polygon, std::vector<std::uint32_t>& triangles) {
    thread_local Workspace workspace;
    Status status = workspace.start(polygon);
    if (status.outcome == Outcome::Ok) {
        startInBox(workspace.mesh);
        insertVertices(workspace.mesh, 0, workspace.mesh.vertexCount);
        status = workspace.finish(triangles);
    }
    workspace.trim();
    return status;
}

}  // namespace tri
