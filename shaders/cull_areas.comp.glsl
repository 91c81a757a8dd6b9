#version 460
#extension GL_GOOGLE_include_directive : require
#include "lib/frame.glsl"
#include "lib/area.glsl"
#include "lib/element.glsl"
#include "lib/in_view.glsl"
#include "lib/level.glsl"

// One thread per area instance: lists those in view for the two draws (caps and walls) of their batch.
layout(local_size_x = kCullGroupSize) in;

// Parts of bodies (leads, print) that are smaller than this are not drawn; there are many of them.
const float kSpeckPx = 0.5;

bool isSpeck(AreaInstance instance, vec3 middle, vec3 extent) {
    return instance.height > 0.0 && max(extent.x, extent.z) * pixelsPerMmAt(middle, extent) < kSpeckPx;
}

bool isInView(AreaInstance instance, LayerState layer) {
    if (!has(layer.flags, kLayerVisible) || !isDrawn(instance.onlyAs) || isHidden(instance.element)) {
        return false;
    }
    const float lower = faceOf(instance, layer, false);
    layer.z1 = faceOf(instance, layer, true);
    layer.z0 = lower;
    const ShapeBound bound = FRAME.bounds.at[instance.shape];
    const vec3 middle = middleOf(placed(instance, bound.centre), layer);
    const vec3 extent = extentOf(vec2(bound.radius), layer);
    return !has(FRAME.flags, kFrameCull) || (isBoxInView(middle, extent) && !isSpeck(instance, middle, extent));
}

void main() {
    const uint index = gl_GlobalInvocationID.x;
    if (index >= FRAME.instanceCount) {
        return;
    }
    const AreaInstance instance = FRAME.instances.at[index];
    if (!isInView(instance, FRAME.layers.at[instance.layer])) {
        return;
    }
    const uint draw = FRAME.drawOfInstance.at[index];
    const uint slot = atomicAdd(FRAME.capDraws.at[draw].instanceCount, 1u);
    atomicAdd(FRAME.wallDraws.at[draw].instanceCount, 1u);
    FRAME.visibleInstances.at[FRAME.capDraws.at[draw].firstInstance + slot] = index;
}
