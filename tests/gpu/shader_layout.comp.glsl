#version 460
#extension GL_GOOGLE_include_directive : require
#include "../../shaders/lib/frame.glsl"
#include "../../shaders/shared/section.h"
#include "../../shaders/shared/raster.h"

// Every struct that crosses between C++ and GLSL, in blocks of their own: shader_layout_test reads their offsets off the reflection.
layout(local_size_x = 1) in;
layout(set = 0, binding = 0, scalar) buffer LetBlock { Let let[2]; };
layout(set = 0, binding = 1, scalar) buffer ClusterBlock { Cluster cluster[2]; };
layout(set = 0, binding = 2, scalar) buffer LayerStateBlock { LayerState layerState[2]; };
layout(set = 0, binding = 4, scalar) buffer AreaInstanceBlock { AreaInstance areaInstance[2]; };
layout(set = 0, binding = 5, scalar) buffer ShapeBoundBlock { ShapeBound shapeBound[2]; };
layout(set = 0, binding = 6, scalar) buffer DrawIndexedBlock { DrawIndexed drawIndexed[2]; };
layout(set = 0, binding = 7, scalar) buffer DrawBlock { Draw draw[2]; };
layout(set = 0, binding = 3, scalar) buffer AreaDrawBlock { AreaDraw areaDraw[2]; };
layout(set = 0, binding = 16, scalar) buffer AreaRunBlock { AreaRun areaRun[2]; };
layout(set = 0, binding = 8, scalar) buffer FrameDataBlock { FrameData frameData[2]; };
layout(set = 0, binding = 9, scalar) buffer PushStructBlock { Push pushStruct[2]; };
layout(set = 0, binding = 10, scalar) buffer StandardVertexBlock { StandardVertex standardVertex[2]; };
layout(set = 0, binding = 11, scalar) buffer StandardPartBlock { StandardPartRecord standardPart[2]; };
layout(set = 0, binding = 12, scalar) buffer CutTrapezoidBlock { SectionTrapezoid cutTrapezoid[2]; };
layout(set = 0, binding = 13, scalar) buffer RasterCopyBlock { RasterCopy rasterCopy[2]; };
layout(set = 0, binding = 14, scalar) buffer RasterPushBlock { RasterPush rasterPush[2]; };
layout(set = 0, binding = 15, scalar) buffer ShadowsBlock { Shadows shadows[2]; };

void main() {
    // Reflection lists what is used.
    let[0] = let[1];
    cluster[0] = cluster[1];
    layerState[0] = layerState[1];
    areaInstance[0] = areaInstance[1];
    shapeBound[0] = shapeBound[1];
    drawIndexed[0] = drawIndexed[1];
    draw[0] = draw[1];
    areaDraw[0] = areaDraw[1];
    areaRun[0] = areaRun[1];
    frameData[0] = frameData[1];
    pushStruct[0] = pushStruct[1];
    standardVertex[0] = standardVertex[1];
    rasterCopy[0] = rasterCopy[1];
    rasterPush[0] = rasterPush[1];
    shadows[0] = shadows[1];
    standardPart[0] = standardPart[1];
    cutTrapezoid[0] = cutTrapezoid[1];
}
