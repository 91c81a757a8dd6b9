#pragma once

#include <atomic>
#include <optional>

#include "render/gpu/frame_ring.h"
#include "render/modelling/let_tables.h"
#include "render/scene/board_scene.h"
#include "render/scene/scene_layers.h"

namespace render {

/// A step on the GPU: one buffer per column, made once.
struct GeometryBuffers {
    gpu::Buffer lets;
    gpu::Buffer clusters;
    gpu::Buffer vertices;
    gpu::Buffer next;
    gpu::Buffer indices;
    gpu::Buffer instances;
    gpu::Buffer drawOfInstance;
    gpu::Buffer bounds;
    gpu::Buffer elementStates;  ///< a byte per element, ElementState
    gpu::Buffer areaDraws;
    gpu::Buffer areaRuns;    ///< SceneStep::areaRuns
    gpu::Buffer patchDraws;  ///< commands that draw nothing: what each frame starts from
    gpu::Buffer countOfAll;  ///< as many commands as there may be (docs/driver-notes.md)
    gpu::Buffer topShadows;  ///< ShadowMap::cells
    gpu::Buffer bottomShadows;
    std::uint64_t bytes = 0;  ///< of all of them
};

/// A part of a buffer.
struct BufferPart {
    VkBuffer buffer = VK_NULL_HANDLE;
    std::uint64_t offset = 0;
    std::uint64_t size = 0;
    VkDeviceAddress address = 0;
};

/// What drawing one copy of a step rewrites in every frame: which of its parts are seen, and the commands that draw
/// them.
struct DrawLists {
    BufferPart visibleClusters;
    BufferPart letSlots;
    BufferPart visibleLets;
    BufferPart letDraws;
    BufferPart areaCounts;
    BufferPart visibleInstances;
    BufferPart commandCounts;
    BufferPart capDraws;
    BufferPart wallDraws;
    BufferPart visiblePatches;
    BufferPart patchDraws;
};

/// The board in the standard pipeline: buffers by part.
struct StandardBuffers {
    std::vector<gpu::Buffer> vertices;
    std::vector<gpu::Buffer> indices;
    std::vector<std::uint32_t> indexCounts;
    std::vector<LayerRun> partsOfLayer;
    gpu::Buffer records;      ///< shader::StandardPartRecord
    std::uint64_t bytes = 0;  ///< of all of them
};

/// Elements one behind the other, `from` to before `end`; whole words of shaders.
struct ElementRun {
    std::size_t from = 0;
    std::size_t end = 0;
};

/// A step as the back ends draw it.
struct SceneStep {
    struct Layer {
        LayerRun clusters;
        LayerRun areas;  ///< rows of `areaRuns`
    };
    std::vector<Layer> layers;
    Box2 reach;  ///< of everything it draws
    std::uint32_t letCount = 0;
    std::uint32_t clusterCount = 0;
    std::uint32_t instanceCount = 0;
    std::uint32_t areaDrawCount = 0;
    std::vector<shader::AreaRun> areaRuns;  ///< areas by indirect command list
    std::vector<ElementState> states;
    ElementRun unsent;            ///< of `states`; `geometry.elementStates` gets them with the next frame
    std::size_t standingOut = 0;  ///< so many of them are highlighted or have a colour
    GeometryBuffers geometry;
    ShadowGrid topShadows;  ///< their cells are in `geometry`
    ShadowGrid bottomShadows;
    std::optional<StandardBuffers> standard;  ///< then there is nothing but this and the states of elements

    /// `layerCount` of the board; a step has the same rows or fewer. Nothing is on the device before `load`.
    SceneStep(const BoardModel& model, std::size_t layerCount);
    void load(gpu::Device& device, const BoardModel& model);
    SceneStep(gpu::Device& device, const StandardModel& model, std::size_t layerCount);
    [[nodiscard]] bool isEmpty() const { return clusterCount == 0 && instanceCount == 0 && !standard; }
    /// Bytes of the draw lists of one copy; the standard pipeline has none.
    [[nodiscard]] std::uint64_t listBytes() const;
    [[nodiscard]] DrawLists listsAt(const gpu::Buffer& buffer, std::uint64_t offset) const;
    /// Fills in where the shaders of a frame find this step.
    void setAddresses(shader::FrameData& data, const DrawLists& lists) const;
    /// Fills in the shadows on one side of this step; `data` has its centre.
    void setShadows(shader::FrameData& data, bool isTop) const;
};

struct BoardScene::Impl {
    gpu::Device* device = nullptr;
    SceneLayers layers;
    LetTables letTables;
    gpu::Buffer letIndices;
    std::vector<SceneStep> steps;  ///< the board itself first
    std::vector<ModelCopy> copies;
    /// Draw lists of as many copies as fit. One buffer serves all views: they draw one after the other on one queue.
    gpu::Buffer lists;

    std::shared_ptr<const BoardModel> unloaded;  ///< what is to be brought to the device, until it is there
    std::atomic<bool> isLoaded = false;          ///< all is there; while it is not, another thread may bring it

    /// Nothing is on the device before `load`.
    Impl(gpu::Device& owner, const BoardModel& model);
    Impl(gpu::Device& owner, const StandardModel& model);
    /// All or nothing, with plain elements: `unsent` has all that has changed since. Throws gpu::OutOfMemory.
    void load(const BoardModel& model, std::uint64_t mostListBytes);
    /// States of elements that have changed, before what `frame` draws.
    void sendStates(gpu::Frame& frame);
    /// A frame that had them was not submitted: all go with the next one.
    void resendStates();
};

}  // namespace render
