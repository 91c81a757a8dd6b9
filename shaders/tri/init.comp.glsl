#version 460
#extension GL_GOOGLE_include_directive : require
#define THREADS FOREST.vertexCount
#define RUN initVertex(index)
#include "kernel.glsl"
