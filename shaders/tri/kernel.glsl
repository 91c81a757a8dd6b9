#version 460
#extension GL_GOOGLE_include_directive : require
// A kernel that does RUN for every index below THREADS (CMakeLists.txt).
#include "forest.glsl"
#include "access.h"
#include "mesh.h"
#include "insert.h"
#include "flip.h"
#include "constrain.h"
#include "erase.h"
#include "advance.h"

layout(local_size_x = kGroupSize) in;

void main() {
    const uint index = groupIndex() * kGroupSize + gl_LocalInvocationID.x;
    if (index < THREADS) {
        RUN;
    }
}
