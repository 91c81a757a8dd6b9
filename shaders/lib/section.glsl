// Boards cut by a section plane. Frames without one have pipelines in which this is nothing.
layout(constant_id = 0) const bool kHasSection = false;

// Whether a location (relative to FRAME.centre) is cut away. Fragment shaders test it last: derivatives end with `discard`.
bool isClipped(vec3 position) {
    return kHasSection && dot(FRAME.sectionPlane.xy, position.xy) > FRAME.sectionPlane.z;
}
