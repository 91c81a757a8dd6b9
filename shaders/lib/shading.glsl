// How bright a surface is: the same for all back ends.

// A headlight seen from over the left shoulder: caps bright, walls clearly darker and different on every side, so that thickness is readable.
// `normal` of unit length; caps are exactly horizontal, walls exactly vertical.
// What stands out is lit more evenly: it must be seen from all sides.
float brightness(vec3 normal) {
    if (normal.z != 0.0) {
        return 1.0;
    }
    const float side = 0.36 + 0.22 * dot(normal.xy, FRAME.light);
    return has(FRAME.flags, kFrameStandingOut) ? mix(side, 1.0, 0.6) : side;
}

bool isShaded() {
    return !has(FRAME.flags, kFrameFlat | kFrameMono);
}
