// What all back ends hand to the rasteriser: a clip position and a colour.

#include "element.glsl"

// A highlighted element keeps its hue at full brightness.
vec3 highlighted(vec3 colour) {
    const float peak = max(max(colour.r, colour.g), max(colour.b, 1e-3));
    return mix(colour / peak, vec3(1.0), 0.25);
}

vec4 colourOf(LayerState layer, uint element, bool isBore) {
    if (has(FRAME.flags, kFrameMono)) {
        return vec4(1.0);
    }
    const uint state = stateOf(element);
    const vec4 plain = isBore ? vec4(vec3(0.004), layer.colour.a) : layer.colour;
    if (!standsOut(state)) {
        return vec4(plain.rgb * FRAME.restBrightness, plain.a);
    }
    if (isBore) {
        return plain;
    }
    const uint row = state & kElementColourMask;
    const vec3 colour = row == 0u ? plain.rgb : FRAME.palette.at[row - 1u];
    return vec4(has(state, kElementHighlighted) ? highlighted(colour) : colour, 1.0);  // and hides what is under it
}

// Moves a clip position nearer by so many steps of depth resolution. `slenderness` is length over width: a rasteriser works out the slope of a sliver the
// worse the thinner it is, and the step grows with that.
vec4 nudged(vec4 clip, float steps, float slenderness) {
    clip.z += steps * (1.0 + FRAME.sliverNudge * slenderness) * (FRAME.nudgeZ * clip.z + FRAME.nudgeW * clip.w);
    return clip;
}

// Faces in one plane: the higher layer rank wins, then highlighted elements, and what is solid before the inside of a hole (whose wall may be
// at the same location). `position` is relative to FRAME.centre; `height` goes from 0 on the lower to 1 on the upper face.
vec4 clipPosition(vec3 position, LayerState layer, uint element, bool isBore, float height, float slenderness) {
    const float bottom = float((layer.flags >> kLayerBottomRankShift) & 0xffu);
    const float top = float((layer.flags >> kLayerTopRankShift) & 0xffu);
    const float steps = 3.0 * mix(bottom, top, height) + (standsOut(stateOf(element)) ? 1.0 : 0.0) - (isBore ? 1.0 : 0.0);
    return nudged(FRAME.clipFromBoard * vec4(position, 1.0), steps, slenderness);
}
