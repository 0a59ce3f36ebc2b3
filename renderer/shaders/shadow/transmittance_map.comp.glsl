// Transmittance function map (Delalandre et al. 2011): T itself, marched in order, projected on a basis over
// plain distance x.
#include "lib/basis.glsl"
#include "lib/ordered_march.glsl"
#include "lib/coefficient_target.glsl"
layout(local_size_x = 8, local_size_y = 8) in;

void main() {
  MapTexel mt = mapTexelOf(gl_GlobalInvocationID.xy);
  if (!mt.valid) return;
  MapRay ray = mapRay(0, mt.face, texelUv(mt), float(mapEdge));
  Stretch march = beginMarch(ray, tileRange(mt.tall));
  float c[BASIS_FLOATS];
  for (int i = 0; i < BASIS_FLOATS; ++i) c[i] = 0.0;
  float T = 1.0, done = 0.0, a, b, depth;
#if WINDOWED
  int slot = stateSlot(BASIS_FLOATS + 2);
  if (!firstWindow()) {
    T = windowStates[slot], done = windowStates[slot + 1];
    for (int i = 0; i < BASIS_FLOATS; ++i) c[i] = windowStates[slot + 2 + i];
  }
#endif
  // What is constant between two steps is projected as one piece, whatever its length.
  bool more;
  do {
    more = nextStep(march, T, a, b, depth);
    if (!more && !lastWindow()) break;
    float from = more ? a / ray.tMax : 1.0, to = more ? min(b / ray.tMax, 1.0) : 1.0;
    projectStep(BASIS, c, T * max(from - done, 0.0), done, max(from, done));
    float mean = depth < 1e-3 ? 1.0 - 0.5 * depth : (1.0 - exp(-depth)) / max(depth, 1e-20);
    projectStep(BASIS, c, T * mean * max(to - from, 0.0), from, to);
    T *= exp(-depth);
    done = to;
  } while (more);
#if WINDOWED
  windowStates[slot] = T, windowStates[slot + 1] = done;
  for (int i = 0; i < BASIS_FLOATS; ++i) windowStates[slot + 2 + i] = c[i];
  if (!lastWindow()) return;
#endif
  BlockRecord block = lights[0].coefficients;
  for (int layer = 0; layer < (BASIS_FLOATS + 3) / 4; ++layer) {
    vec4 v = vec4(0.0);
    for (int j = 0; j < 4 && 4 * layer + j < BASIS_FLOATS; ++j) v[j] = c[4 * layer + j];
    imageStore(target, ivec3(block.place.xy + mt.texel, block.place.w + mt.face * block.kind.y + layer), v);
  }
}
