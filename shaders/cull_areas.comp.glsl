#version 460
#extension GL_GOOGLE_include_directive : require
#include "lib/frame.glsl"
#include "lib/area.glsl"
#include "lib/cull_thread.glsl"
#include "lib/element.glsl"
#include "lib/in_view.glsl"
#include "lib/level.glsl"

// One thread per area instance: lists those in view for their draw, or as patches of their layer. line_up_areas makes the commands.
layout(local_size_x = kCullGroupSize) in;

// Parts of bodies (leads, print) that are smaller than this are not drawn; there are many of them.
const float kSpeckPx = 0.5;

bool isSpeck(AreaInstance instance, vec3 middle, vec3 extent) {
    return instance.height > 0.0 && max(extent.x, extent.z) * pixelsPerMmAt(middle, extent) < kSpeckPx;
}

// Is its box as good as its outline, or is it as small as lets that are drawn as quads? Its walls must be out of sight too.
bool isPatch(ShapeBound bound, vec3 middle, vec3 extent) {
    const float pixelsPerMm = pixelsPerMmAt(middle, extent);
    const float heightPx = 2.0 * extent.z * pixelsPerMm;
    const bool isExact = bound.stray * pixelsPerMm < FRAME.tolerancePx && heightPx < FRAME.thinPx;
    const bool isSmall = extent.x * pixelsPerMm < FRAME.quadRadiusPx && heightPx < 1.0;
    return !has(FRAME.flags, kFramePaperLevels | kFrameImpostors | kFrameOutlines) && (isExact || isSmall);
}

const uint kAsPatch = 2u;
const uint kInFull = 1u;
const uint kNotSeen = 0u;

uint wayOf(AreaInstance instance, LayerState layer) {
    if (!isOnLayer(layer, instance.onlyAs) || isHidden(instance.element)) {
        return kNotSeen;
    }
    if (!has(FRAME.flags, kFrameCull)) {
        return kInFull;
    }
    const float lower = faceOf(instance, layer, false);
    layer.z1 = faceOf(instance, layer, true);
    layer.z0 = lower;
    const ShapeBound bound = FRAME.bounds.at[instance.shape];
    const vec3 middle = middleOf(placed(instance, bound.centre), layer);
    const vec3 extent = extentOf(vec2(length(bound.extent)), layer);  // however it is rotated
    if (!isBoxInView(middle, extent) || isSpeck(instance, middle, extent)) {
        return kNotSeen;
    }
    return isPatch(bound, middle, extent) ? kAsPatch : kInFull;
}

void main() {
    const uint index = cullThread();
    if (index >= FRAME.instanceCount) {
        return;
    }
    const AreaInstance instance = FRAME.instances.at[index];
    const uint way = wayOf(instance, FRAME.layers.at[instance.layer]);
    if (way == kNotSeen) {
        return;
    }
    if (way == kAsPatch) {
        const uint nth = atomicAdd(FRAME.patchDraws.at[instance.layer].vertexCount, kPatchVertices) / kPatchVertices;
        FRAME.visiblePatches.at[FRAME.patchDraws.at[instance.layer].firstInstance + nth] = index;
        return;
    }
    const uint draw = FRAME.drawOfInstance.at[index];
    const uint slot = atomicAdd(FRAME.areaCounts.at[draw], 1u);
    FRAME.visibleInstances.at[FRAME.areaDraws.at[draw].firstInstance + slot] = index;
}
