#version 460
#extension GL_GOOGLE_include_directive : require
#include "../../shaders/tri/predicates.h"

struct Question {
    ivec2 points[4];
    uvec4 ids;
};
struct Answer {
    uvec2 orient;
    uvec4 inCircle;
    uint isInside;
    uint rank;
};
layout(buffer_reference, scalar, buffer_reference_align = 4) readonly buffer Questions { Question at[]; };
layout(buffer_reference, scalar, buffer_reference_align = 4) buffer Answers { Answer at[]; };
layout(push_constant, scalar) uniform Push {
    Questions questions;
    Answers answers;
    uint count;
    uint reserved;
};
layout(local_size_x = 64) in;

void main() {
    const uint i = gl_GlobalInvocationID.x;
    if (i < count) {
        const Question q = questions.at[i];
        Answer answer;
        answer.orient = orient(q.points[0], q.points[1], q.points[2]);
        answer.inCircle = inCircle(q.points[0], q.points[1], q.points[2], q.points[3]);
        answer.isInside = isInPerturbedCircle(q.points[0], q.points[1], q.points[2], q.points[3], q.ids) ? 1u : 0u;
        answer.rank = isNegative128(answer.inCircle) ? 0u : rankOf(answer.inCircle);
        answers.at[i] = answer;
    }
}
