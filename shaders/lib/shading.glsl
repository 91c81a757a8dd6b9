// How bright a surface is and what it mirrors: the same for all back ends.

// A headlight seen from over the left shoulder: caps bright, walls clearly darker and different on every side, so that thickness is readable.
// `normal` of unit length; caps are exactly horizontal, walls exactly vertical.
// What stands out is lit more evenly: it must be seen from all sides.
float brightness(vec3 normal) {
    if (normal.z != 0.0) {
        return 1.0;
    }
    const float side = 0.36 + 0.22 * dot(normal.xy, FRAME.light);
    return has(FRAME.flags, kFrameStandingOut) ? mix(side, 1.0, 0.45) : side;
}

bool isShaded() {
    return !has(FRAME.flags, kFrameFlat | kFrameMono);
}

// A large lamp in a dim room: by how much of it is mirrored, from a broad glow around it to its image.
const vec2 kMetalRange = vec2(0.72, 0.75);   // of its colour: in the dim room, and what the glow adds
const vec2 kGlossRange = vec2(0.035, 0.06);  // white: of the glow, of the image
const float kGlossAtEdge = 0.10;             // where sight grazes the surface, everything mirrors

// How much light the bodies around let through to a location, relative to FRAME.centre, of the side that is seen.
float lightBesideBodies(vec2 location) {
    const vec2 at = max((location - SHADOWS.origin) * SHADOWS.cellsPerMm, vec2(0.0));
    const uvec2 cell = min(uvec2(at), uvec2(SHADOWS.width, SHADOWS.height) - 1u);
    const vec4 corners = unpackUnorm4x8(SHADOWS.cells.at[cell.y * SHADOWS.width + cell.x]);
    const vec2 part = clamp(at - vec2(cell), 0.0, 1.0);
    const vec2 sides = mix(corners.xz, corners.yw, part.x);
    return 1.0 - SHADOWS.strength * mix(sides.x, sides.y, part.y);
}

// Of a level face that may have shadows; walls have none.
float lightOf(uint material, vec3 normal, vec2 location) {
    const bool isShadowed = normal.z != 0.0 && has(material, kMaterialShadowed);
    return isShadowed ? lightBesideBodies(location) : 1.0;
}

// Colour as it is added to what shows through: multiplied by its opacity, with what is mirrored on top. `normal` is a unit vector, `toEye` leads to
// the viewer, `location` is relative to FRAME.centre. Only arithmetic: software devices run both sides of a condition.
vec4 shaded(vec4 colour, uint material, vec3 normal, vec3 toEye, vec2 location) {
    const uint kind = material & kMaterialMask;
    const float perMm = inversesqrt(dot(toEye, toEye));
    const float facing = dot(toEye, normal);
    const float lamp = max((2.0 * facing * dot(normal, FRAME.keyLight) - dot(toEye, FRAME.keyLight)) * perMm, 0.0);
    const float lamp2 = lamp * lamp;
    const float glow = lamp2 * lamp2 * lamp2;
    const float image = glow * glow * glow * glow;
    const float beside = 1.0 - facing * perMm;
    const float away = beside * beside;
    const float metal = kind == kMaterialMetal ? kMetalRange.x + kMetalRange.y * glow : 1.0;
    const float gloss = kind == kMaterialGloss
                            ? kGlossRange.x * glow + kGlossRange.y * image + kGlossAtEdge * away * away
                            : 0.0;
    const vec3 light = colour.rgb * (brightness(normal) * metal * colour.a) + gloss * FRAME.restStrength;
    return vec4(light * lightOf(material, normal, location), colour.a);
}

// Flat views have colours as they are.
vec4 unshaded(vec4 colour) {
    return vec4(colour.rgb * colour.a, colour.a);
}
