#version 460
#extension GL_GOOGLE_include_directive : require
#define THREADS 2u * FOREST.vertexCount
#define RUN decide(index)
#include "kernel.glsl"
