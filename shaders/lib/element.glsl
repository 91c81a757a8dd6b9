// How single elements look.
#ifndef COPPERSCOPE_SHADERS_LIB_ELEMENT_GLSL
#define COPPERSCOPE_SHADERS_LIB_ELEMENT_GLSL

uint stateOf(uint element) {
    const uint word = FRAME.elementStates.at[element / kElementsPerWord];
    return word >> (8u * (element % kElementsPerWord)) & 0xffu;
}

bool standsOut(uint state) {
    return (state & (kElementHighlighted | kElementColourMask)) != 0u;
}

// Not drawn in this pass over the board.
bool isHidden(uint element) {
    const uint state = stateOf(element);
    return has(state, kElementHidden) || (has(FRAME.flags, kFrameStandingOut) && !standsOut(state));
}

#endif
