// p' = origin + M(mirror) * R * p with R = (c s; -s c).
vec2 placed(AreaInstance instance, vec2 p) {
    const vec2 cs = instance.cosSin;
    const vec2 rotated = vec2(cs.x * p.x + cs.y * p.y, -cs.y * p.x + cs.x * p.y);
    return instance.origin + vec2(instance.isMirrored != 0u ? -rotated.x : rotated.x, rotated.y);
}

// The height of an area's upper or lower face.
float faceOf(AreaInstance instance, LayerState layer, bool isUpper) {
    const bool isFarFromBoard = isUpper != has(layer.flags, kLayerGrowsDown);
    if (instance.height > 0.0 && isFarFromBoard) {
        return isUpper ? layer.z0 + instance.height : layer.z1 - instance.height;
    }
    return isUpper ? layer.z1 : layer.z0;
}
