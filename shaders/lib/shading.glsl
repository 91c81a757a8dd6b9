// How bright a surface is: the same for all back ends.

// A headlight seen from over the left shoulder: caps bright, walls clearly darker and different on every side, so that thickness is readable.
// `normal` of unit length; caps are exactly horizontal, walls exactly vertical.
float brightness(vec3 normal) {
    if (normal.z != 0.0) {
        return 1.0;
    }
    return 0.36 + 0.22 * dot(normal.xy, FRAME.light);
}

bool isShaded() {
    return !has(FRAME.flags, kFrameFlat | kFrameMono);
}
