#include "model/export/meshes/glb_export.h"

#include <map>
#include <utility>

#include "model/text/file_writer.h"
#include "model/text/number_text.h"

namespace model {

namespace {

constexpr double kNmPerMetre = 1e9;
/// z up to y up.
constexpr const char* kUpright = ",\"rotation\":[-0.707106781,0,0,0.707106781]";

class GlbWriter {
public:
    GlbWriter(const SolidPlan& plan, const GlbOptions& options, const std::vector<StepMeshes>& meshes)
        : m_plan(plan), m_options(options), m_meshes(meshes), m_scene(options.packing), m_made(plan.steps.size()) {
        for (std::size_t i = 0; i < plan.steps.size(); ++i) {
            m_made[i].own.resize(plan.steps[i].groups.size());
        }
    }

    /// The file in pieces; empty when it is too large for its kind.
    std::vector<std::string> write(MeshReport& report, const base::Progress& progress) {
        std::vector<std::uint32_t> children;
        for (std::size_t i = 0; i < m_plan.copies.size() && !progress.isCancelled(); ++i) {
            const SolidCopy& copy = m_plan.copies[i];
            const std::vector<std::uint32_t> layers = addLayers(copy.step);
            if (i == 0) {
                children = layers;
            } else if (!layers.empty()) {
                const std::string name = m_plan.steps[copy.step].document->job.step + ' ' + std::to_string(i);
                children.push_back(m_scene.addNode({name, {}, {}, gltfPlacement(copy.placement), layers}));
            }
        }
        const std::uint32_t root = m_scene.addNode({m_options.name, {}, {}, kUpright, children});
        report.triangles = m_scene.triangles();
        report.copies = m_copies;
        return m_scene.finish(root, "Copperscope");
    }

private:
    /// What of a step is in the scene already: copies take it again.
    struct Made {
        std::vector<std::optional<GltfScene::Mesh>> own;                            ///< by group
        std::map<std::pair<std::uint32_t, std::uint32_t>, GltfScene::Mesh> shapes;  ///< by shape and material
        std::map<LayerId, GltfScene::Mesh> layers;                                  ///< of one part
    };

    std::vector<std::uint32_t> addLayers(std::uint32_t row) {
        const StepSolids& step = m_plan.steps[row];
        std::vector<std::uint32_t> layers;
        for (std::size_t first = 0; first < step.groups.size();) {
            std::size_t end = first;
            while (end < step.groups.size() && step.groups[end].layer == step.groups[first].layer) {
                ++end;
            }
            const std::optional<std::uint32_t> node =
                m_plan.choice.isOnePart ? addWholeLayer(row, first, end) : addLayer(row, first, end);
            if (node) {
                layers.push_back(*node);
            }
            first = end;
        }
        return layers;
    }

    std::optional<std::uint32_t> addLayer(std::uint32_t row, std::size_t first, std::size_t end) {
        const StepSolids& step = m_plan.steps[row];
        std::vector<std::uint32_t> nets;
        for (std::size_t i = first; i < end; ++i) {
            if (const auto node = addGroup(row, i)) {
                nets.push_back(*node);
            }
        }
        const std::string& name = step.document->layer(step.groups[first].layer).name;
        return nets.empty() ? std::nullopt : std::optional(m_scene.addNode({name, {}, {}, {}, nets}));
    }

    std::optional<std::uint32_t> addWholeLayer(std::uint32_t row, std::size_t first, std::size_t end) {
        const StepSolids& step = m_plan.steps[row];
        const LayerId layer = step.groups[first].layer;
        auto found = m_made[row].layers.find(layer);
        if (found == m_made[row].layers.end()) {
            SolidMesh all;
            for (std::size_t i = first; i < end; ++i) {
                all.append(writtenOut(m_meshes[row], m_meshes[row].groups[i]));
            }
            if (all.triangles.empty()) {
                return std::nullopt;
            }
            found = m_made[row].layers.emplace(layer, m_scene.addMesh(all, materialOf(step, layer), true)).first;
        }
        return m_scene.addNode({step.document->layer(layer).name, {}, found->second.row, found->second.transform, {}});
    }

    std::optional<std::uint32_t> addGroup(std::uint32_t row, std::size_t index) {
        const StepSolids& step = m_plan.steps[row];
        const SolidGroup& group = step.groups[index];
        const GroupMesh& mesh = m_meshes[row].groups[index];
        GltfNode node{m_plan.nameOf(step, group), extrasOf(step, group), {}, {}, {}};
        if (!mesh.own.triangles.empty()) {
            std::optional<GltfScene::Mesh>& own = m_made[row].own[index];
            if (!own) {
                own = m_scene.addMesh(mesh.own, materialOf(step, group.layer), true);
            }
            if (own->transform.empty()) {
                node.mesh = own->row;
            } else {
                node.children.push_back(m_scene.addNode({{}, {}, own->row, own->transform, {}}));
            }
        }
        if (m_options.isInstanced) {
            addInstances(row, group, mesh.placed, node.children);
        } else {
            for (const PlacedMesh& placed : mesh.placed) {
                node.children.push_back(addPlaced(row, group, placed));
            }
        }
        return node.mesh || !node.children.empty() ? std::optional(m_scene.addNode(node)) : std::nullopt;
    }

    std::uint32_t meshOf(std::uint32_t row, const SolidGroup& group, std::uint32_t shape) {
        const std::uint32_t material = materialOf(m_plan.steps[row], group.layer);
        auto& shapes = m_made[row].shapes;
        auto found = shapes.find({shape, material});
        if (found == shapes.end()) {
            const SolidMesh& mesh = m_meshes[row].shapes[shape];
            found = shapes.emplace(std::pair{shape, material}, m_scene.addMesh(mesh, material, false)).first;
        }
        return found->second.row;
    }

    std::uint32_t addPlaced(std::uint32_t row, const SolidGroup& group, const PlacedMesh& placed) {
        ++m_copies;
        GltfNode node{{}, {}, meshOf(row, group, placed.shape), gltfPlacement(placed.placement), {}};
        describePad(*m_plan.steps[row].document, placed.element, node);
        return m_scene.addNode(node);
    }

    /// One node for each shape, single ones as addPlaced has them.
    void addInstances(std::uint32_t row, const SolidGroup& group, const std::vector<PlacedMesh>& all,
                      std::vector<std::uint32_t>& children) {
        std::map<std::uint32_t, std::vector<Placement>> byShape;
        for (const PlacedMesh& placed : all) {
            byShape[placed.shape].push_back(placed.placement);
        }
        for (const PlacedMesh& placed : all) {
            std::vector<Placement>& placements = byShape[placed.shape];
            if (placements.size() == 1) {
                children.push_back(addPlaced(row, group, placed));
            } else if (!placements.empty()) {
                m_copies += placements.size();
                const std::uint32_t mesh = meshOf(row, group, placed.shape);
                children.push_back(m_scene.addNode({{}, {}, mesh, m_scene.addInstances(placements), {}}));
                placements.clear();
            }
        }
    }

    /// "U1-3" for the pad of a pin.
    static void describePad(const Document& document, ElementId element, GltfNode& node) {
        const SubnetId subnet = document.elements.subnet[element.row()];
        const PinId id = subnet.isValid() ? document.subnets[subnet.row()].pin : PinId{};
        if (id.isValid() && document.pins[id.row()].component.isValid()) {
            const Pin& pin = document.pins[id.row()];
            const std::string& refdes = document.components[pin.component.row()].refdes;
            node.name = refdes + '-' + document.text(pin.name);
            node.extras = "\"refdes\":" + jsonString(refdes);
        }
    }

    [[nodiscard]] std::string extrasOf(const StepSolids& step, const SolidGroup& group) const {
        const Document& document = *step.document;
        std::string extras = "\"layer\":" + jsonString(document.layer(group.layer).name);
        if (group.net.isValid()) {
            extras += ",\"net\":" + jsonString(document.nets[group.net.row()].name);
        }
        if (group.component.isValid()) {
            extras += ",\"refdes\":" + jsonString(document.components[group.component.row()].refdes);
        }
        const ZRange z = m_plan.heightsOf(step, step.elements[group.elements.first]);
        extras += ",\"z\":[";
        appendSignificant(extras, z.bottom / kNmPerMetre, 9);
        extras += ',';
        appendSignificant(extras, z.top / kNmPerMetre, 9);
        return extras + ']';
    }

    std::uint32_t materialOf(const StepSolids& step, LayerId layer) {
        const LayerId seen = step.document->layerOfCopy(layer, step.isFlipped);
        const auto found = m_materials.find(seen);
        if (found != m_materials.end()) {
            return found->second;
        }
        const Layer& named = step.document->layer(seen);
        const SolidLook look = lookOf(step, layer, m_options.looks);
        const bool isMetal = named.isCopper() || named.type == LayerType::Drill || named.type == LayerType::Rout;
        const std::uint32_t material = m_scene.addMaterial(named.name, look.rgb, look.opacity, isMetal);
        m_materials.emplace(seen, material);
        return material;
    }

    const SolidPlan& m_plan;
    const GlbOptions& m_options;
    const std::vector<StepMeshes>& m_meshes;
    GltfScene m_scene;
    std::vector<Made> m_made;
    std::map<LayerId, std::uint32_t> m_materials;
    std::uint64_t m_copies = 0;
};

}  // namespace

base::Result<MeshReport> exportGlb(const SolidPlan& plan, const GlbOptions& options, const std::filesystem::path& path,
                                   base::Progress& progress) {
    MeshReport report;
    ASSIGN_OR_RETURN(const std::vector<StepMeshes> meshes, allMeshes(plan, options.how, progress, report));
    progress.beginPhase("Writing triangles");
    const std::vector<std::string> pieces = GlbWriter(plan, options, meshes).write(report, progress);
    if (progress.isCancelled()) {
        return base::Error{base::ErrorCode::Cancelled, "the export was cancelled"};
    }
    if (pieces.empty()) {
        return base::Error{base::ErrorCode::OutputFailed, path.string() + " would be larger than GLB can be (4 GiB)"};
    }
    FileWriter file(path);
    for (const std::string& piece : pieces) {
        file.write(piece);
    }
    report.bytes = file.size();
    RETURN_IF_ERROR(file.commit());
    return report;
}

}  // namespace model
