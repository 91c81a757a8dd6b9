#include "model/export/meshes/obj_export.h"

#include <map>

#include "model/base/units.h"
#include "model/text/file_writer.h"
#include "model/text/number_text.h"

namespace model {

namespace {

constexpr int kDigits = 6;  // of a millimetre: 1 nm

/// Names end at a space.
std::string nameOf(std::string text) {
    for (char& c : text) {
        c = static_cast<unsigned char>(c) <= ' ' ? '_' : c;
    }
    return text.empty() ? "_" : text;
}

class ObjWriter {
public:
    ObjWriter(const SolidPlan& plan, const MeshOptions& options, FileWriter& file, FileWriter& materials)
        : m_plan(plan), m_options(options), m_file(file), m_materials(materials) {}

    void begin(const std::filesystem::path& materials) {
        m_file.write("# Copperscope, mm\nmtllib " + materials.filename().string() + '\n');
    }

    base::Status addStep(const SolidCopy& copy, const StepMeshes& meshes, const std::string& suffix,
                         const base::Progress& progress) {
        const StepSolids& step = m_plan.steps[copy.step];
        LayerId current;
        for (std::size_t i = 0; i < step.groups.size(); ++i) {
            if (progress.isCancelled()) {
                return base::Error{base::ErrorCode::Cancelled, "the export was cancelled"};
            }
            const SolidGroup& group = step.groups[i];
            if (group.layer != current) {
                current = group.layer;
                beginLayer(step, current, suffix);
            }
            SolidMesh placed;
            placed.append(writtenOut(meshes, meshes.groups[i]), copy.placement);
            m_file.write("g " + nameOf(m_plan.nameOf(step, group)) + '\n');
            add(placed);
            RETURN_IF_ERROR(m_file.status());
        }
        return base::Done{};
    }

    std::uint64_t triangles = 0;

private:
    void beginLayer(const StepSolids& step, LayerId layer, const std::string& suffix) {
        const std::string name = nameOf(step.document->layer(layer).name);
        const LayerId seen = step.document->layerOfCopy(layer, step.isFlipped);
        const std::string material = nameOf(step.document->layer(seen).name);
        m_file.write("o " + name + suffix + "\nusemtl " + material + '\n');
        if (m_known.emplace(material, true).second) {
            addMaterial(material, lookOf(step, layer, m_options.looks));
        }
    }

    void addMaterial(const std::string& name, const SolidLook& look) {
        std::string text = "newmtl " + name + "\nKd";
        for (const unsigned shift : {16U, 8U, 0U}) {
            text += ' ';
            appendNumber(text, (look.rgb >> shift & 0xFFU) / 255.0, 4);
        }
        text += "\nd ";
        appendNumber(text, look.opacity, 4);
        m_materials.write(text + "\n\n");
    }

    void add(const SolidMesh& mesh) {
        m_text.clear();
        for (const MeshPoint& p : mesh.points) {
            m_text += 'v';
            for (const Nm value : {p.x, p.y, p.z}) {
                m_text += ' ';
                appendNumber(m_text, value / base::kNmPerMm, kDigits);
            }
            m_text += '\n';
        }
        for (std::size_t i = 0; i < mesh.triangles.size(); i += 3) {
            m_text += 'f';
            for (std::size_t k = 0; k < 3; ++k) {
                m_text += ' ' + std::to_string(m_before + mesh.triangles[i + k] + 1);
            }
            m_text += '\n';
        }
        m_file.write(m_text);
        m_before += mesh.points.size();
        triangles += mesh.triangleCount();
    }

    const SolidPlan& m_plan;
    const MeshOptions& m_options;
    FileWriter& m_file;
    FileWriter& m_materials;
    std::map<std::string, bool> m_known;  ///< materials
    std::uint64_t m_before = 0;           ///< points so far
    std::string m_text;
};

}  // namespace

base::Result<MeshReport> exportObj(const SolidPlan& plan, const MeshOptions& options, const std::filesystem::path& path,
                                   base::Progress& progress) {
    MeshReport report;
    ASSIGN_OR_RETURN(const std::vector<StepMeshes> steps, allMeshes(plan, options.how, progress, report));
    progress.beginPhase("Writing triangles");
    const std::filesystem::path beside = materialsBeside(path);
    FileWriter file(path);
    FileWriter materials(beside);
    ObjWriter writer(plan, options, file, materials);
    writer.begin(beside);
    for (std::size_t i = 0; i < plan.copies.size(); ++i) {
        const std::string suffix = i == 0 ? "" : '_' + std::to_string(i);
        RETURN_IF_ERROR(writer.addStep(plan.copies[i], steps[plan.copies[i].step], suffix, progress));
    }
    RETURN_IF_ERROR(checkAnyWritten(writer.triangles));
    report.bytes = file.size() + materials.size();
    report.triangles = writer.triangles;
    RETURN_IF_ERROR(file.finish());
    RETURN_IF_ERROR(materials.finish());
    RETURN_IF_ERROR(file.commit());
    RETURN_IF_ERROR(materials.commit());
    return report;
}

std::filesystem::path materialsBeside(std::filesystem::path path) {
    return path.replace_extension(".mtl");
}

}  // namespace model
