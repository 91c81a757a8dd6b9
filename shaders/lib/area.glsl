// p' = origin + M(mirror) * R * p with R = (c s; -s c).
vec2 placed(AreaInstance instance, vec2 p) {
    const vec2 cs = instance.cosSin;
    const vec2 turned = vec2(cs.x * p.x + cs.y * p.y, -cs.y * p.x + cs.x * p.y);
    return instance.origin + vec2(instance.isMirrored != 0u ? -turned.x : turned.x, turned.y);
}

// The height of an area's upper or lower face.
float faceOf(AreaInstance instance, LayerState layer, bool isUpper) {
    const bool isFarFromBoard = isUpper != has(layer.flags, kLayerHangs);
    if (instance.height > 0.0 && isFarFromBoard) {
        return isUpper ? layer.z0 + instance.height : layer.z1 - instance.height;
    }
    return isUpper ? layer.z1 : layer.z0;
}
