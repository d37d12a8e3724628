#version 330 core
// Added up along a line of sight that begins on a section plane: how many solids it begins in.
layout(location = 0) out float o_winding;
void main() { o_winding = gl_FrontFacing ? -1.0 : 1.0; }
