#version 460
#extension GL_GOOGLE_include_directive : require
#define kTrees FOREST.smallTrees
#define kMostVertices kSmallVertices
#define kMostEdges kSmallEdges
#include "tree.glsl"
