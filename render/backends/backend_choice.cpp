#include "render/backends/backend_choice.h"

#include <algorithm>
#include <iterator>

#include "render/backends/let_backend.h"
#include "render/gpu/device.h"

namespace render {
namespace {

/// From inside a layer the front of a box around a let is not seen. In perspective the eye may be there.
bool isInsideLayer(const LayerPlan& layers, bool isParallel) {
    for (std::size_t i = 0; i < layers.states.size(); ++i) {
        const bool isVisible = (layers.states[i].flags & shader::kLayerVisible) != 0;
        if (isVisible && !isParallel && !layers.faces[i].upper && !layers.faces[i].lower) {
            return true;
        }
    }
    return false;
}

/// May lets be seen by lines of sight?
bool castsSight(const FramePlan& plan) {
    const bool isParallel = plan.data.eye.w == 0.0F;
    return !isInsideLayer(plan.upright, isParallel) && !isInsideLayer(plan.flipped, isParallel);
}

bool canRasterise(const gpu::Caps& caps, const FramePlan& plan) {
    return caps.hasAtomic64 && castsSight(plan) && rasterBytes(plan) <= caps.maxAllocationBytes;
}

/// The back ends from the best to the one for every device and view: the rules for devices that were not measured.
struct Row {
    Backend backend;
    bool (*suits)(const gpu::Caps&, const FramePlan&, bool isSmoothed);  ///< Auto takes the first that does
    bool (*canDraw)(const gpu::Caps&, const FramePlan&);
    const char* needs;
};
constexpr Row kRows[] = {
    // Straight from above or below: four vertices per let instead of 16 to 128, and exact outlines at any zoom. Tilted
    // views of it are for who asks: lines of sight cost software devices more than polygons do (docs/performance.md).
    {Backend::Impostor, [](const gpu::Caps&, const FramePlan& plan, bool) { return isFlatView(plan); },
     [](const gpu::Caps& caps, const FramePlan& plan) {
         return isFlatView(plan) || (caps.canShadeSamples && castsSight(plan));
     },
     "needs a flat view (2D), or shading by sample and an eye outside all layers"},
    // On the card that was measured it draws boards of many small lets twice as fast as pull, and nothing much slower
    // (docs/performance-gpu.md). It cannot smooth.
    {Backend::Raster,
     [](const gpu::Caps& caps, const FramePlan& plan, bool isSmoothed) {
         return !caps.isCpu && !isSmoothed && canRasterise(caps, plan);
     },
     canRasterise, "needs 64-bit atomics, an eye outside all layers and eight bytes per pixel"},
    // The paper's way. Software devices run mesh shaders on one thread, compute and vertex shaders on all
    // (docs/driver-notes.md), and on the card that was measured it takes 1.0 to 2.8 times as long as pull.
    {Backend::Mesh, [](const gpu::Caps&, const FramePlan&, bool) { return false; },
     [](const gpu::Caps& caps, const FramePlan&) { return caps.hasMeshShader; },
     "needs mesh shaders, which this device does not have"},
    {Backend::Pull, [](const gpu::Caps&, const FramePlan&, bool) { return true; },
     [](const gpu::Caps&, const FramePlan&) { return true; }, ""}};

}  // namespace

const char* nameOf(Backend backend) {
    constexpr const char* kNames[] = {"auto", "mesh", "pull", "impostor", "raster", "standard"};
    return kNames[static_cast<std::size_t>(backend)];
}

BackendChoice chooseBackend(Backend wanted, const gpu::Caps& caps, const FramePlan& plan, bool isSmoothed,
                            const MeasuredBackends& measured) {
    if ((plan.data.flags & shader::kFrameOutlines) != 0) {
        return {Backend::Impostor};
    }
    const auto canDraw = [&](const Row* row) { return row != std::end(kRows) && row->canDraw(caps, plan); };
    const Row* best = std::ranges::find_if(kRows, [&](const Row& row) { return row.suits(caps, plan, isSmoothed); });
    const Row* fastest = std::ranges::find(kRows, measured.of(isSmoothed), &Row::backend);
    if (!isFlatView(plan) && canDraw(fastest)) {
        best = fastest;
    }
    const Row* requested = std::ranges::find(kRows, wanted, &Row::backend);
    if (requested == std::end(kRows)) {
        return {best->backend};
    }
    return canDraw(requested) ? BackendChoice{wanted} : BackendChoice{best->backend, requested->needs};
}

std::vector<Backend> tiltedBackends(const gpu::Caps& caps, bool isSmoothed) {
    std::vector<Backend> all;
    std::ranges::copy_if(tiltedBackends(isSmoothed), std::back_inserter(all), [&](Backend backend) {
        return backend == Backend::Pull || (backend == Backend::Mesh && caps.hasMeshShader) ||
               (backend == Backend::Impostor && caps.canShadeSamples) ||
               (backend == Backend::Raster && caps.hasAtomic64);
    });
    return all;
}

}  // namespace render
