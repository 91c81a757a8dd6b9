// What all back ends hand to the rasteriser: a clip position and a colour.

#include "element.glsl"

const vec3 kSilhouette = vec3(0.0015);
const float kBoreShade = 0.4;  // of holes of what stands out, which must be seen where nothing but a hole is left

// A highlighted element with a colour of its own keeps its hue at full brightness.
vec3 highlighted(vec3 colour) {
    return colour / max(max(colour.r, colour.g), max(colour.b, 1e-3));
}

vec3 standingOut(uint state) {
    const uint row = state & kElementColourMask;
    const vec3 colour = FRAME.palette.at[row == 0u ? kHighlightRow : row - 1u];
    return has(state, kElementHighlighted) ? highlighted(colour) : colour;
}

// What does not stand out: in flat views fading into the background; in 3D turning grey first, with enough left of its lights and shadows to see
// where things lie.
vec3 dimmed(vec3 colour) {
    const float strength = FRAME.restStrength;
    if (has(FRAME.flags, kFrameFlat)) {
        return mix(FRAME.background, colour, strength);
    }
    const vec3 grey = vec3(dot(colour, vec3(0.2126, 0.7152, 0.0722)));
    return mix(FRAME.background, mix(grey, colour, strength), strength * (1.5 - 0.5 * strength));
}

vec4 colourOf(LayerState layer, uint element, bool isBore) {
    if (has(FRAME.flags, kFrameMono)) {
        return vec4(1.0);
    }
    if (has(FRAME.flags, kFrameSilhouettes)) {
        return vec4(kSilhouette, 1.0);
    }
    const uint state = stateOf(element);
    const vec4 plain = isBore ? vec4(vec3(0.004), layer.colour.a) : layer.colour;
    if (!standsOut(state)) {
        return vec4(dimmed(plain.rgb), plain.a);
    }
    const float depthShade = has(FRAME.flags, kFrameStandingOut) ? layer.colour.a : 1.0;
    return vec4(standingOut(state) * (isBore ? kBoreShade : depthShade), 1.0);  // and hides what is under it
}

// What stands out shines like metal whatever it is, in its own colour, and no shadow falls on it: so a plane is no flat patch. The dark inside of
// a hole does not shine.
uint materialOf(LayerState layer, uint element, bool isBore) {
    const uint ofLayer = layer.flags >> kLayerMaterialShift & (kMaterialMask | kMaterialShadowed);
    const uint plain = standsOut(stateOf(element)) ? kMaterialMetal : ofLayer;
    return isBore ? kMaterialMatt : plain;
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
