// p' = origin + M(mirror) * R * p with R = (c s; -s c).
vec2 placed(AreaInstance instance, vec2 p) {
    const vec2 cs = instance.cosSin;
    const vec2 rotated = vec2(cs.x * p.x + cs.y * p.y, -cs.y * p.x + cs.x * p.y);
    return instance.origin + vec2(instance.isMirrored != 0u ? -rotated.x : rotated.x, rotated.y);
}

// The height of an area's upper or lower face.
float faceOf(AreaInstance instance, LayerState layer, bool isUpper) {
    const bool growsDown = has(layer.flags, kLayerGrowsDown);
    if (instance.height > 0.0) {
        const float away = isUpper != growsDown ? instance.height : instance.floor;
        return growsDown ? layer.z1 - away : layer.z0 + away;
    }
    return isUpper ? layer.z1 : layer.z0;
}

// The layer as this area shows it: in the colour of its material.
LayerState layerOf(AreaInstance instance) {
    LayerState layer = FRAME.layers.at[instance.layer];
    if (instance.material != 0u) {
        layer.colour.rgb = FRAME.palette.at[kMaterialRow + instance.material - 1u];
    }
    return layer;
}
