#include "model/export/meshes/stl_export.h"

#include <array>
#include <bit>
#include <cmath>
#include <limits>

#include "model/base/units.h"
#include "model/text/file_writer.h"

namespace model {

namespace {

constexpr std::size_t kHeader = 80;

void append32(std::string& out, std::uint32_t value) {
    for (int shift = 0; shift < 32; shift += 8) {
        out += static_cast<char>(value >> shift & 0xFFU);
    }
}

using Vector = std::array<double, 3>;

void append(std::string& out, const Vector& v) {
    for (const double value : v) {
        append32(out, std::bit_cast<std::uint32_t>(static_cast<float>(value)));
    }
}

Vector mm(const MeshPoint& p) {
    return {p.x / base::kNmPerMm, p.y / base::kNmPerMm, p.z / base::kNmPerMm};
}

Vector normalOf(const Vector& a, const Vector& b, const Vector& c) {
    const Vector u{b[0] - a[0], b[1] - a[1], b[2] - a[2]};
    const Vector v{c[0] - a[0], c[1] - a[1], c[2] - a[2]};
    const Vector n{u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]};
    const double length = std::hypot(n[0], n[1], n[2]);
    return length > 0.0 ? Vector{n[0] / length, n[1] / length, n[2] / length} : Vector{};
}

void appendTriangles(std::string& out, const SolidMesh& mesh) {
    for (std::size_t i = 0; i < mesh.triangles.size(); i += 3) {
        const Vector a = mm(mesh.points[mesh.triangles[i]]);
        const Vector b = mm(mesh.points[mesh.triangles[i + 1]]);
        const Vector c = mm(mesh.points[mesh.triangles[i + 2]]);
        append(out, normalOf(a, b, c));
        append(out, a);
        append(out, b);
        append(out, c);
        out.append(2, '\0');
    }
}

std::uint64_t trianglesOf(const StepMeshes& meshes) {
    std::uint64_t count = 0;
    for (const GroupMesh& group : meshes.groups) {
        count += group.own.triangleCount();
        for (const PlacedMesh& placed : group.placed) {
            count += meshes.shapes[placed.shape].triangleCount();
        }
    }
    return count;
}

std::string headerOf(const std::string& name, std::uint64_t triangles) {
    std::string header = "binary STL, mm, Copperscope: " + name;
    header.resize(kHeader, ' ');
    append32(header, static_cast<std::uint32_t>(triangles));
    return header;
}

}  // namespace

base::Result<MeshReport> exportStl(const SolidPlan& plan, const MeshOptions& options, const std::filesystem::path& path,
                                   base::Progress& progress) {
    MeshReport report;
    ASSIGN_OR_RETURN(const std::vector<StepMeshes> steps, allMeshes(plan, options.how, progress, report));
    for (const SolidCopy& copy : plan.copies) {
        report.triangles += trianglesOf(steps[copy.step]);
    }
    RETURN_IF_ERROR(checkAnyWritten(report.triangles));
    if (report.triangles > std::numeric_limits<std::uint32_t>::max()) {
        return base::Error{base::ErrorCode::OutputFailed, path.string() + " would hold more triangles than STL can"};
    }
    progress.beginPhase("Writing triangles");
    FileWriter file(path);
    file.write(headerOf(options.name, report.triangles));
    std::string triangles;
    for (const SolidCopy& copy : plan.copies) {
        const StepMeshes& meshes = steps[copy.step];
        for (const GroupMesh& group : meshes.groups) {
            if (progress.isCancelled()) {
                return base::Error{base::ErrorCode::Cancelled, "the export was cancelled"};
            }
            SolidMesh placed;
            placed.append(writtenOut(meshes, group), copy.placement);
            triangles.clear();
            appendTriangles(triangles, placed);
            file.write(triangles);
            RETURN_IF_ERROR(file.status());
        }
    }
    report.bytes = file.size();
    RETURN_IF_ERROR(file.commit());
    return report;
}

}  // namespace model
