#version 330 core
// How much of the sky each visible fragment sees: ambient occlusion in screen space (after McGuire et al. 2011,
// "alchemy"), with few taps a sample in a pattern that differs by pixel and by sample.
#include "view/eye_depth.glsl"
#include "view/surface_bits.glsl"
uniform usampler2D t_surface;
uniform sampler2D t_depth;
uniform vec4 u_eye_plane;    // pixel to the plane at distance 1: scale and offset
uniform float u_perspective;  // 0 or 1
uniform vec3 u_eye_right;
uniform vec3 u_eye_up;
uniform vec3 u_eye_back;
uniform float u_radius;       // unit frame
uniform float u_radius_px;    // at distance 1 for the perspective
uniform int u_taps;
uniform int u_sample;
layout(location = 0) out float o_openness;

vec3 eye_position(vec2 pixel, float depth) {
  float away = eye_distance(depth);
  return vec3((pixel * u_eye_plane.xy + u_eye_plane.zw) * mix(1.0, away, u_perspective), -away);
}

float noise(vec2 at) { return fract(52.9829189 * fract(dot(at, vec2(0.06711056, 0.00583715)))); }

void main() {
  ivec2 at = ivec2(gl_FragCoord.xy);
  uvec2 surface = texelFetch(t_surface, at, 0).rg;
  // The loop is left at once where there is no surface: software GL follows both sides of an if.
  int taps = surface.x == 0u ? 0 : u_taps;
  vec3 n = surface_normal(surface);
  if (surface_shows_back(surface)) n = -n;
  vec3 normal = vec3(dot(n, u_eye_right), dot(n, u_eye_up), dot(n, u_eye_back));
  vec3 origin = eye_position(gl_FragCoord.xy, texelFetch(t_depth, at, 0).r);
  vec2 seed = gl_FragCoord.xy + 5.588238 * float(u_sample);
  float start = noise(seed), turn = 6.2831853 * noise(seed.yx + 17.0);
  vec2 toward = vec2(cos(turn), sin(turn));
  float radius_px = u_radius_px / mix(1.0, -origin.z, u_perspective);
  ivec2 last = textureSize(t_depth, 0) - 1;
  float hidden = 0.0;
  for (int tap = 0; tap < taps; ++tap) {
    float share = (float(tap) + start) / float(taps);
    vec2 pixel = floor(gl_FragCoord.xy + share * radius_px * toward) + 0.5;
    toward = mat2(-0.73736888, 0.67549029, -0.67549029, -0.73736888) * toward;  // the golden angle
    vec3 beside = eye_position(pixel, texelFetch(t_depth, clamp(ivec2(pixel), ivec2(0), last), 0).r) - origin;
    float squared = dot(beside, beside);
    float near = max(0.0, 1.0 - squared / (u_radius * u_radius));
    float rise = max(0.0, dot(beside, normal) - 0.02 * u_radius);
    hidden += near * rise * inversesqrt(squared + 1e-9);
  }
  float covered = taps > 0 ? 2.4 * hidden / float(taps) : 0.0;
  o_openness = 1.0 / (1.0 + covered + covered * covered);
}
