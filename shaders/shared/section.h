// What fills the cut of a section plane.
#ifndef COPPERSCOPE_SHADERS_SHARED_SECTION_H
#define COPPERSCOPE_SHADERS_SHARED_SECTION_H

#include "frame.h"

#ifdef __cplusplus
namespace shader {
#endif

// An upright trapezoid with level edges as it is drawn, mm in the coordinates of the board.
struct SectionTrapezoid {
    vec3 colour;  // linear
    uint rank;    // of those at the same location the one of higher rank is seen
    vec2 from;
    vec2 to;
    vec2 upperFrom;
    vec2 upperTo;
    float bottom;
    float top;
};
GPU_SIZE(SectionTrapezoid, 56);

GPU_READ(SectionTrapezoids, SectionTrapezoid, 4);

// Push constants.
struct SectionPush {
    GPU_ADDRESS(Frame) frame;
    GPU_ADDRESS(SectionTrapezoids) trapezoids;
};
GPU_SIZE(SectionPush, 16);

#ifdef __cplusplus
}  // namespace shader
#endif
#endif
