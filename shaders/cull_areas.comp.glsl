#version 460
#extension GL_GOOGLE_include_directive : require
#include "lib/frame.glsl"
#include "lib/area.glsl"
#include "lib/element.glsl"
#include "lib/in_view.glsl"

// One thread per area instance: lists those in view for the two draws (caps and walls) of their batch.
layout(local_size_x = kCullGroupSize) in;

bool isInView(AreaInstance instance, LayerState layer) {
    if (!has(layer.flags, kLayerVisible) || !isDrawn(instance.onlyAs) || isHidden(instance.element)) {
        return false;
    }
    const ShapeBound bound = FRAME.bounds.at[instance.shape];
    return !has(FRAME.flags, kFrameCull) || isBoxInView(middleOf(placed(instance, bound.centre), layer),
                                                        extentOf(vec2(bound.radius), layer));
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
