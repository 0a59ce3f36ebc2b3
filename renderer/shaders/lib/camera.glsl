// The region of the picture that a dispatch works on, and the camera's rays. Set by view/camera_march.h.
#pragma once

uniform ivec2 regionOrigin, regionEnd, size;
uniform vec3 eye, right, up, back;  // right and up are scaled to half the picture at distance 1

ivec2 regionPixel() { return regionOrigin + ivec2(gl_GlobalInvocationID.xy); }
bool inRegion(ivec2 pixel) { return all(lessThan(pixel, regionEnd)); }
int regionSlot(ivec2 pixel) {
  return (pixel.y - regionOrigin.y) * (regionEnd.x - regionOrigin.x) + pixel.x - regionOrigin.x;
}

// Through a place in the pixel, in [0,1]^2.
vec3 cameraDirection(ivec2 pixel, vec2 place) {
  vec2 ndc = (vec2(pixel) + place) / vec2(size) * 2.0 - 1.0;
  return normalize(ndc.x * right - ndc.y * up - back);
}
