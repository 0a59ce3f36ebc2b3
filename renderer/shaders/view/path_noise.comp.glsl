// Sums over a path-traced picture, PATH_NOISE_PIXELS of its pixels an invocation, row by row: of what
// counts (alpha above 0.01) the mean over RGB, the same of the squared deviations, and how many they are.
#include "shared/path.h"
layout(local_size_x = 64) in;

layout(rgba32f, binding = IMAGE_MEAN) uniform readonly image2D meanImage;
layout(rgba32f, binding = IMAGE_DEVIATIONS) uniform readonly image2D deviationImage;
layout(std430, binding = BIND_PATH_STATES) writeonly buffer Sums { vec4 sums[]; };
uniform ivec2 size;

void main() {
  int part = int(gl_GlobalInvocationID.x), first = part * PATH_NOISE_PIXELS, pixels = size.x * size.y;
  if (first >= pixels) return;
  vec3 sum = vec3(0.0);
  for (int i = first; i < min(first + PATH_NOISE_PIXELS, pixels); ++i) {
    ivec2 p = ivec2(i % size.x, i / size.x);
    vec4 mean = imageLoad(meanImage, p), deviation = imageLoad(deviationImage, p);
    vec3 one = vec3(mean.r + mean.g + mean.b, deviation.r + deviation.g + deviation.b, 3.0) / 3.0;
    sum += mean.a > 0.01 ? one : vec3(0.0);
  }
  sums[part] = vec4(sum, 0.0);
}
