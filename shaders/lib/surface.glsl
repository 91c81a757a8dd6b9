// What all back ends hand to the rasteriser: a clip position and a colour.

bool isHighlighted(uint element) {
    return (FRAME.highlight.at[element >> 5u] & (1u << (element & 31u))) != 0u;
}

// A highlighted element keeps its hue at full brightness and hides what is under it.
vec4 highlighted(vec4 colour) {
    const float peak = max(max(colour.r, colour.g), max(colour.b, 1e-3));
    return vec4(mix(colour.rgb / peak, vec3(1.0), 0.25), 1.0);
}

vec4 colourOf(LayerState layer, uint element, bool isBore) {
    if (has(FRAME.flags, kFrameMono)) {
        return vec4(1.0);
    }
    const vec4 colour = isBore ? vec4(vec3(0.004), layer.colour.a) : layer.colour;
    if (isHighlighted(element)) {
        return isBore ? colour : highlighted(colour);
    }
    return has(FRAME.flags, kFrameDimOthers) ? vec4(colour.rgb * 0.12, colour.a) : colour;
}

// Faces in one plane: the higher layer rank wins, then highlighted elements, and what is solid before the inside of a hole (whose wall may be
// at the same place). Moves z by so many steps of depth resolution. `slenderness` is length over width: a rasteriser works out the slope of a sliver
// the worse the thinner it is, and the step grows with that.
vec4 clipPosition(vec3 position, LayerState layer, uint element, bool isBore, bool isUpper, float slenderness) {
    const uint shift = isUpper ? kLayerTopRankShift : kLayerBottomRankShift;
    const int rank = int((layer.flags >> shift) & 0xffu);
    const int steps = 3 * rank + (isHighlighted(element) ? 1 : 0) - (isBore ? 1 : 0);
    const float nudge = float(steps) * (1.0 + FRAME.sliverNudge * slenderness);
    vec4 clip = FRAME.clipFromBoard * vec4(position - FRAME.centre, 1.0);
    clip.z += nudge * (FRAME.nudgeZ * clip.z + FRAME.nudgeW * clip.w);
    return clip;
}
