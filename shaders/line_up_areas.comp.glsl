#version 460
#extension GL_GOOGLE_include_directive : require
#include "lib/frame.glsl"

// One workgroup per run of area draws: the commands, of caps and of walls, of draws with instances in view, without gaps. They stay in order, so that
// pictures do not depend on which thread comes first.
layout(local_size_x = kCullGroupSize) in;

shared uint counts[kCullGroupSize];

void writeCommand(uint at, AreaDraw draw, uint instances) {
    FRAME.capDraws.at[at] =
        DrawIndexed(draw.indexCount, instances, draw.firstIndex, draw.vertexOffset, draw.firstInstance);
    FRAME.wallDraws.at[at] = Draw(draw.wallVertexCount, instances, draw.firstWallVertex, draw.firstInstance);
}

void main() {
    const AreaRun run = FRAME.areaRuns.at[gl_WorkGroupID.x];
    const uint thread = gl_LocalInvocationID.x;
    const uint share = (run.count + kCullGroupSize - 1u) / kCullGroupSize;
    const uint from = run.first + min(share * thread, run.count);
    const uint end = run.first + min(share * (thread + 1u), run.count);
    uint count = 0u;
    for (uint i = from; i < end; ++i) {
        count += FRAME.areaCounts.at[i] > 0u ? 1u : 0u;
    }
    counts[thread] = count;
    barrier();
    uint at = run.first;
    for (uint i = 0u; i < thread; ++i) {
        at += counts[i];
    }
    for (uint i = from; i < end; ++i) {
        const uint instances = FRAME.areaCounts.at[i];
        if (instances > 0u) {
            writeCommand(at++, FRAME.areaDraws.at[i], instances);
        }
    }
    if (thread == kCullGroupSize - 1u) {
        FRAME.commandCounts.at[gl_WorkGroupID.x] = at - run.first;
    }
}
