#version 460
#extension GL_GOOGLE_include_directive : require
#define THREADS contourCount()
#define RUN rebuildCorridor(index)
#include "kernel.glsl"
