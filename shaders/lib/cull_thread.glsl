// Rows of workgroups with a thread for each of many things (render::dispatchCull). There may be threads beyond the last.
uint cullThread() {
    const uint group = gl_WorkGroupID.y * gl_NumWorkGroups.x + gl_WorkGroupID.x;
    return group * kCullGroupSize + gl_LocalInvocationID.x;
}
