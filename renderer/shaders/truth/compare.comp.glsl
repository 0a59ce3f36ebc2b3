// A comparison as a display-ready picture: false colours of an error, or transmittance as grey.
#include "shared/compare.h"
layout(local_size_x = 8, local_size_y = 8) in;

layout(rgba8, binding = IMAGE_ERROR) uniform writeonly image2D target;
layout(binding = UNIT_COMPARED) uniform sampler2D compared;
layout(binding = UNIT_TRUTH) uniform sampler2D truth;
layout(binding = UNIT_COLOURS) uniform sampler1D colours;  // from -1 to 1
uniform ivec2 size;
uniform int show;
uniform float scale;  // the error shown in the colours' ends

vec3 falseColour(float e) { return textureLod(colours, 0.5 + 0.5 * clamp(e / scale, -1.0, 1.0), 0.0).rgb; }

void main() {
  ivec2 pixel = ivec2(gl_GlobalInvocationID.xy);
  if (any(greaterThanEqual(pixel, size))) return;
  vec4 a = texelFetch(compared, pixel, 0), b = texelFetch(truth, pixel, 0);
  vec3 shown;
  if (show == SHOW_RADIANCE_ERROR) {
    shown = falseColour(dot(a.rgb - b.rgb, vec3(0.2722287, 0.6740818, 0.0536895)));  // luminance of ACEScg
  } else if (show == SHOW_SHADOW_ERROR) {
    // What is hardly there is hardly shown.
    shown = falseColour(a.x / max(b.z, 1e-6) * smoothstep(0.0, 0.02, b.z));
  } else if (show == SHOW_WORST_ERROR) {
    shown = falseColour(a.z);
  } else {
    float T = (show == SHOW_MAPPED_TRANSMITTANCE ? b.x : b.y) / max(b.z, 1e-6);
    shown = vec3(pow(clamp(T, 0.0, 1.0), 1.0 / 2.2) * smoothstep(0.0, 0.02, b.z));
  }
  imageStore(target, pixel, vec4(shown, 1.0));
}
