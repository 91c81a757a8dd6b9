#include "model/export/meshes/glb_export.h"

#include <algorithm>
#include <map>
#include <span>
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
    GlbWriter(const SolidPlan& plan, const GlbOptions& options, FileWriter& file, base::Progress& progress)
        : m_plan(plan),
          m_options(options),
          m_file(file),
          m_progress(progress),
          m_scene(options.packing, file.scratchPlace()),
          m_made(plan.steps.size()) {}

    base::Status write() {
        std::vector<std::uint32_t> children;
        for (std::size_t i = 0; i < m_plan.copies.size(); ++i) {
            const SolidCopy& copy = m_plan.copies[i];
            ASSIGN_OR_RETURN(std::vector<std::uint32_t> layers, addLayers(copy.step));
            if (i == 0) {
                children = std::move(layers);
            } else if (!layers.empty()) {
                const std::string name = m_plan.steps[copy.step].document->job.step + ' ' + std::to_string(i);
                children.push_back(m_scene.addNode({name, {}, {}, gltfPlacement(copy.placement), layers}));
            }
        }
        RETURN_IF_ERROR(checkAnyWritten(m_scene.triangles()));
        m_progress.beginPhase("Writing triangles");
        const std::uint32_t root = m_scene.addNode({m_options.name, {}, {}, kUpright, children});
        return m_scene.finish(root, "Copperscope", m_file, m_progress);
    }

    [[nodiscard]] MeshReport report() const {
        MeshReport report;
        report.triangles = m_scene.triangles();
        report.copies = m_copies;
        for (const Made& made : m_made) {
            report.missing.insert(report.missing.end(), made.missing.begin(), made.missing.end());
        }
        return report;
    }

private:
    /// What became of a group, for further copies of its step.
    struct MadeGroup {
        std::optional<GltfScene::Mesh> own;
        std::vector<PlacedMesh> placed;
    };

    /// What of a step is in the scene already: copies take it again.
    struct Made {
        bool isComplete = false;
        std::vector<MadeGroup> groups;
        std::map<std::pair<std::uint32_t, std::uint32_t>, GltfScene::Mesh> shapes;  ///< by shape and material
        std::map<LayerId, GltfScene::Mesh> layers;                                  ///< of one part
        std::vector<MissingSolid> missing;
    };

    /// The nodes of a copy of a step, while its groups come one after another.
    struct Tree {
        std::uint32_t row = 0;  ///< of the step
        std::vector<std::uint32_t> layers;
        std::vector<std::uint32_t> nets;  ///< of the layer that is open
        SolidMesh whole;                  ///< all of that layer, where it becomes one part
    };

    /// The nodes of the layers of a step; what is in them with the first copy of the step.
    base::Result<std::vector<std::uint32_t>> addLayers(std::uint32_t row) {
        Tree tree{row, {}, {}, {}};
        Made& made = m_made[row];
        if (made.isComplete) {
            addAgain(tree);
            return std::move(tree.layers);
        }
        made.groups.resize(m_plan.steps[row].groups.size());
        const MeshTaker taker{
            [this](SolidMesh& own) { own = isOnePart() ? std::move(own) : inGoodOrder(std::move(own)); },
            [&](std::size_t index, GroupMesh mesh, const std::vector<SolidMesh>& shapes) {
                take(tree, index, std::move(mesh), shapes);
                return m_scene.status();
            }};
        ASSIGN_OR_RETURN(StepMeshes passed, passMeshes(m_plan, row, m_options.how, taker, m_progress));
        made.missing = std::move(passed.missing);
        made.isComplete = true;
        return std::move(tree.layers);
    }

    void addAgain(Tree& tree) {
        for (std::size_t i = 0; i < m_made[tree.row].groups.size() && !m_progress.isCancelled(); ++i) {
            if (!isOnePart()) {
                addGroup(tree, i, m_made[tree.row].groups[i], {});
            }
            endGroup(tree, i);
        }
    }

    void take(Tree& tree, std::size_t index, GroupMesh mesh, std::span<const SolidMesh> shapes) {
        if (isOnePart()) {
            tree.whole.append(mesh.own);
            for (const PlacedMesh& placed : mesh.placed) {
                tree.whole.append(shapes[placed.shape], placed.placement);
            }
        } else {
            const StepSolids& step = m_plan.steps[tree.row];
            MadeGroup made{{}, std::move(mesh.placed)};
            if (!mesh.own.triangles.empty()) {
                made.own = m_scene.addMesh(mesh.own, materialOf(step, step.groups[index].layer), true);
            }
            addGroup(tree, index, made, shapes);
            if (isPlacedOften(tree.row)) {
                m_made[tree.row].groups[index] = std::move(made);
            }
        }
        endGroup(tree, index);
    }

    [[nodiscard]] bool isPlacedOften(std::uint32_t row) const {
        return std::ranges::count(m_plan.copies, row, &SolidCopy::step) > 1;
    }

    /// Behind the last group of a layer comes the node of the layer.
    void endGroup(Tree& tree, std::size_t index) {
        const StepSolids& step = m_plan.steps[tree.row];
        const LayerId layer = step.groups[index].layer;
        if (index + 1 < step.groups.size() && step.groups[index + 1].layer == layer) {
            return;
        }
        if (isOnePart()) {
            addWholeLayer(tree, layer);
        } else if (!tree.nets.empty()) {
            tree.layers.push_back(m_scene.addNode({step.document->layer(layer).name, {}, {}, {}, tree.nets}));
            tree.nets.clear();
        }
    }

    void addWholeLayer(Tree& tree, LayerId layer) {
        const StepSolids& step = m_plan.steps[tree.row];
        auto& layers = m_made[tree.row].layers;
        if (!tree.whole.triangles.empty()) {
            const SolidMesh whole = inGoodOrder(std::exchange(tree.whole, {}));
            layers.emplace(layer, m_scene.addMesh(whole, materialOf(step, layer), true));
        }
        const auto found = layers.find(layer);
        if (found != layers.end()) {
            const GltfScene::Mesh& mesh = found->second;
            tree.layers.push_back(
                m_scene.addNode({step.document->layer(layer).name, {}, mesh.row, mesh.transform, {}}));
        }
    }

    /// `shapes` are those of the step; not needed when it is added again.
    void addGroup(Tree& tree, std::size_t index, const MadeGroup& made, std::span<const SolidMesh> shapes) {
        const StepSolids& step = m_plan.steps[tree.row];
        const SolidGroup& group = step.groups[index];
        GltfNode node{m_plan.nameOf(step, group), extrasOf(step, group), {}, {}, {}};
        if (made.own && made.own->transform.empty()) {
            node.mesh = made.own->row;
        } else if (made.own) {
            node.children.push_back(m_scene.addNode({{}, {}, made.own->row, made.own->transform, {}}));
        }
        if (m_options.isInstanced) {
            addInstances(tree.row, group, made.placed, shapes, node.children);
        } else {
            for (const PlacedMesh& placed : made.placed) {
                node.children.push_back(addPlaced(tree.row, group, placed, shapes));
            }
        }
        if (node.mesh || !node.children.empty()) {
            tree.nets.push_back(m_scene.addNode(node));
        }
    }

    std::uint32_t meshOf(std::uint32_t row, const SolidGroup& group, std::uint32_t shape,
                         std::span<const SolidMesh> shapes) {
        const std::uint32_t material = materialOf(m_plan.steps[row], group.layer);
        auto& made = m_made[row].shapes;
        auto found = made.find({shape, material});
        if (found == made.end()) {
            const GltfScene::Mesh mesh = m_scene.addMesh(inGoodOrder(shapes[shape]), material, false);
            found = made.emplace(std::pair{shape, material}, mesh).first;
        }
        return found->second.row;
    }

    std::uint32_t addPlaced(std::uint32_t row, const SolidGroup& group, const PlacedMesh& placed,
                            std::span<const SolidMesh> shapes) {
        ++m_copies;
        GltfNode node{{}, {}, meshOf(row, group, placed.shape, shapes), gltfPlacement(placed.placement), {}};
        describePad(*m_plan.steps[row].document, placed.element, node);
        return m_scene.addNode(node);
    }

    /// One node for each shape, single ones as addPlaced has them.
    void addInstances(std::uint32_t row, const SolidGroup& group, const std::vector<PlacedMesh>& all,
                      std::span<const SolidMesh> shapes, std::vector<std::uint32_t>& children) {
        std::map<std::uint32_t, std::vector<Placement>> byShape;
        for (const PlacedMesh& placed : all) {
            byShape[placed.shape].push_back(placed.placement);
        }
        for (const PlacedMesh& placed : all) {
            std::vector<Placement>& placements = byShape[placed.shape];
            if (placements.size() == 1) {
                children.push_back(addPlaced(row, group, placed, shapes));
            } else if (!placements.empty()) {
                m_copies += placements.size();
                const std::uint32_t mesh = meshOf(row, group, placed.shape, shapes);
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

    [[nodiscard]] bool isOnePart() const { return m_plan.choice.isOnePart; }

    const SolidPlan& m_plan;
    const GlbOptions& m_options;
    FileWriter& m_file;
    base::Progress& m_progress;
    GltfScene m_scene;
    std::vector<Made> m_made;
    std::map<LayerId, std::uint32_t> m_materials;
    std::uint64_t m_copies = 0;
};

}  // namespace

base::Result<MeshReport> exportGlb(const SolidPlan& plan, const GlbOptions& options, const std::filesystem::path& path,
                                   base::Progress& progress) {
    progress.beginPhase("Triangulating solids");
    FileWriter file(path);
    RETURN_IF_ERROR(file.status());
    GlbWriter writer(plan, options, file, progress);
    RETURN_IF_ERROR(writer.write());
    MeshReport report = writer.report();
    report.bytes = file.size();
    RETURN_IF_ERROR(file.commit());
    return report;
}

}  // namespace model
