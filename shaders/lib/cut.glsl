// Boards cut open along an upright plane. Frames without one have pipelines in which this is nothing.
layout(constant_id = 0) const bool kCuts = false;

// Whether a place (relative to FRAME.centre) is cut away. Fragment shaders ask it last: derivatives end with `discard`.
bool isCutAway(vec3 place) {
    return kCuts && dot(FRAME.cut.xy, place.xy) > FRAME.cut.z;
}
