// What is in view.

// Whether what `onlyAs` says is drawn on the layer.
bool isOnLayer(LayerState layer, uint onlyAs) {
    return has(layer.flags, kLayerVisible) && (onlyAs != 0u || !has(layer.flags, kLayerMilledOnly)) &&
           !has(onlyAs, has(FRAME.flags, kFrameFabricated) ? kOnlyAsDesigned : kOnlyAsFabricated);
}

// Whether a box (half extents around its middle, relative to FRAME.centre) may be in view.
bool isBoxInView(vec3 middle, vec3 extent) {
    for (uint i = 0u; i < kPlaneCount; ++i) {
        const vec4 plane = FRAME.planes[i];
        if (dot(plane.xyz, middle) + dot(abs(plane.xyz), extent) + plane.w < 0.0) {
            return false;
        }
    }
    return true;
}

vec3 middleOf(vec2 middle, LayerState layer) {
    return vec3(middle, 0.5 * (layer.z0 + layer.z1)) - FRAME.centre;
}

vec3 extentOf(vec2 extent, LayerState layer) {
    return vec3(extent, 0.5 * (layer.z1 - layer.z0) + FRAME.boreProtrusionMm);
}
