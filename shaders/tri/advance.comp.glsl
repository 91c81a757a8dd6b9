#version 460
#extension GL_GOOGLE_include_directive : require
#define THREADS 1u
#define RUN advance()
#include "kernel.glsl"
