#version 460
#extension GL_GOOGLE_include_directive : require
#include "shared/overlay.h"

layout(push_constant, scalar) uniform PushBlock {
    OverlayPush push;
};
layout(location = 0) out vec4 outColour;

vec3 toLinear(vec3 srgb) {
    return mix(pow((srgb + 0.055) / 1.055, vec3(2.4)), srgb / 12.92, lessThanEqual(srgb, vec3(0.04045)));
}

void main() {
    const uvec2 at = uvec2(gl_FragCoord.xy);
    // Invocations beside the picture load too, discarded or not (docs/driver-notes.md): they must stay inside.
    const uvec2 inside = min(at, uvec2(push.width, push.height) - 1u);
    const vec4 pixel = unpackUnorm4x8(push.pixels.at[inside.y * push.width + inside.x]);
    if (at != inside || pixel.a == 0.0) {
        discard;
    }
    if (push.isInPlane != 0u) {
        const float board = uintBitsToFloat(push.depths.at[inside.y * push.width + inside.x]);
        if (board > dot(push.plane, vec3(gl_FragCoord.xy, 1.0))) {
            discard;  // nearer is greater
        }
    }
    outColour = vec4(toLinear(pixel.rgb / pixel.a), pixel.a);
}
