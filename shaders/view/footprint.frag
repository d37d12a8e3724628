#version 330 core
// What stands over a place of the floor: 1 where something does.
layout(location = 0) out vec4 o_covered;

void main() { o_covered = vec4(1.0); }
