// p' = origin + M(mirror) * R * p with R = (c s; -s c).
vec2 placed(AreaInstance instance, vec2 p) {
    const vec2 cs = instance.cosSin;
    const vec2 turned = vec2(cs.x * p.x + cs.y * p.y, -cs.y * p.x + cs.x * p.y);
    return instance.origin + vec2(instance.isMirrored != 0u ? -turned.x : turned.x, turned.y);
}
