#version 460
#extension GL_GOOGLE_include_directive : require
#define kTrees FOREST.tinyTrees
#define kMostVertices kTinyVertices
#define kMostEdges kTinyEdges
#include "tree.glsl"
