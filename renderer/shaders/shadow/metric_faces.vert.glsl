// The twelve triangles of one volume's local box, seen from the light (Gautron et al. 2011: bounding boxes rasterised additively).
#include "lib/volume.glsl"
layout(std140, binding = BIND_LIGHTS) uniform LightBlock { LightRecord lights[MAX_LIGHTS]; };
flat out float side;  // -1 where the light ray enters, +1 where it leaves
out float depth;      // x along the light ray; linear in the face for a parallel light

void main() {
  int v = gl_InstanceID, face = gl_VertexID / 6, corner = gl_VertexID % 6;
  int axis = face >> 1, positive = face & 1;
  const ivec2 quad[6] = ivec2[6](ivec2(0, 0), ivec2(1, 0), ivec2(1, 1), ivec2(0, 0), ivec2(1, 1), ivec2(0, 1));
  vec3 c;
  c[axis] = float(positive);
  c[(axis + 1) % 3] = float(quad[corner].x);
  c[(axis + 2) % 3] = float(quad[corner].y);
  vec3 local = mix(boundsMin(v).xyz, boundsMax(v).xyz, c);
  vec3 q = (lights[0].lightFromWorld * (worldFromLocal(v) * vec4(local, 1.0))).xyz;
  // The outward normal against the ray, both in local space: true for mirrored placements too.
  vec3 along = (localFromWorld(v) * vec4(-lights[0].towards.xyz, 0.0)).xyz;
  side = (positive == 1 ? along[axis] : -along[axis]) < 0.0 ? -1.0 : 1.0;
  depth = q.z;
  gl_Position = vec4(2.0 * q - 1.0, 1.0);
}
