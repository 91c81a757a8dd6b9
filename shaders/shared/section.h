// What fills the cut of a section plane.
#ifndef COPPERSCOPE_SHADERS_SHARED_SECTION_H
#define COPPERSCOPE_SHADERS_SHARED_SECTION_H

#include "frame.h"

#ifdef __cplusplus
namespace shader {
#endif

// An upright rectangle as it is drawn, mm in the coordinates of the board.
struct SectionRectangle {
    vec3 colour;  // linear
    uint rank;    // of rectangles at the same location the one of higher rank is seen
    vec2 from;
    vec2 to;
    float bottom;
    float top;
};
GPU_SIZE(SectionRectangle, 40);

GPU_READ(SectionRectangles, SectionRectangle, 4);

// Push constants.
struct SectionPush {
    GPU_ADDRESS(Frame) frame;
    GPU_ADDRESS(SectionRectangles) rectangles;
};
GPU_SIZE(SectionPush, 16);

#ifdef __cplusplus
}  // namespace shader
#endif
#endif
