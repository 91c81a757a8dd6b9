#version 460
#extension GL_GOOGLE_include_directive : require
#define THREADS FOREST.vertexCount
#define RUN claimPlace(index)
#include "kernel.glsl"
