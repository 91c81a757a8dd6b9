// What fills the cut through a board that is cut open.
#ifndef COPPERSCOPE_SHADERS_SHARED_CUT_H
#define COPPERSCOPE_SHADERS_SHARED_CUT_H

#include "frame.h"

#ifdef __cplusplus
namespace shader {
#endif

// An upright rectangle as it is drawn, mm in the coordinates of the board.
struct CutRectangle {
    vec3 colour;  // linear
    uint rank;    // of rectangles at the same place the one of higher rank is seen
    vec2 from;
    vec2 to;
    float bottom;
    float top;
};
GPU_SIZE(CutRectangle, 40);

GPU_READ(CutRectangles, CutRectangle, 4);

// Push constants.
struct CutPush {
    GPU_ADDRESS(Frame) frame;
    GPU_ADDRESS(CutRectangles) rectangles;
};
GPU_SIZE(CutPush, 16);

#ifdef __cplusplus
}  // namespace shader
#endif
#endif
