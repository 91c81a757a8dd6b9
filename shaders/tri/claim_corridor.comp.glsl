#version 460
#extension GL_GOOGLE_include_directive : require
#define THREADS contourCount()
#define RUN claimCorridor(index)
#include "kernel.glsl"
