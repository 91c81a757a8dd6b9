#version 460

// One triangle that covers the whole target.
void main() {
    const vec2 corner = vec2((gl_VertexIndex & 1) * 4 - 1, (gl_VertexIndex & 2) * 2 - 1);
    gl_Position = vec4(corner, 1.0, 1.0);
}
