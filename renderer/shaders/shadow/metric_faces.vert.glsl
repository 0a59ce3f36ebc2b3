// The twelve triangles of one volume's local box, seen from the light (Gautron et al. 2011: bounding boxes
// rasterised additively).
#include "lib/volume.glsl"
#include "lib/light.glsl"
uniform int face, mapEdge;
flat out float side;   // -1 where the light ray enters, +1 where it leaves
out vec3 inLight;      // sun: (u, v, x); else metres in light space: distance is not linear over a face
flat out vec4 depthOf; // x: of inLight.z (sun), or y: near, z: depth for a distance

void main() {
  int v = gl_InstanceID, box = gl_VertexID / 6, corner = gl_VertexID % 6;
  int axis = box >> 1, positive = box & 1;
  const ivec2 quad[6] =
      ivec2[6](ivec2(0, 0), ivec2(1, 0), ivec2(1, 1), ivec2(0, 0), ivec2(1, 1), ivec2(0, 1));
  vec3 c;
  c[axis] = float(positive);
  c[(axis + 1) % 3] = float(quad[corner].x);
  c[(axis + 2) % 3] = float(quad[corner].y);
  vec3 local = mix(boundsMin(v).xyz, boundsMax(v).xyz, c);
  vec3 q = (lights[0].lightFromWorld * (worldFromLocal(v) * vec4(local, 1.0))).xyz;
  // The outward normal against the ray, both in local space: true for mirrored placements too. A face that
  // lies wholly in front of a local light's plane is entered or left alike everywhere, so any point of it
  // tells.
  bool sun = lights[0].items.w == LIGHT_SUN;
  vec3 eye = (localFromWorld(v) * vec4(lights[0].position.xyz, 1.0)).xyz;
  vec3 onFace = mix(boundsMin(v).xyz, boundsMax(v).xyz, 0.5);
  onFace[axis] = mix(boundsMin(v).xyz, boundsMax(v).xyz, float(positive))[axis];
  vec3 along = sun ? (localFromWorld(v) * vec4(-lights[0].towards.xyz, 0.0)).xyz : onFace - eye;
  side = (positive == 1 ? along[axis] : -along[axis]) < 0.0 ? -1.0 : 1.0;
  inLight = q;
  depthOf = vec4(sun ? 1.0 : 0.0, lights[0].extent.z, lights[0].extent.x, 0.0);
  int kind = lights[0].items.w, a = kind == LIGHT_POINT ? face >> 1 : 2;
  float depth = kind == LIGHT_POINT && (face & 1) == 1 ? -q[a] : q[a];
  vec2 across = vec2(q[(a + 1) % 3], q[(a + 2) % 3]) * faceScale(kind, float(mapEdge)) / lights[0].extent.w;
  gl_Position = sun ? vec4(2.0 * q - 1.0, 1.0) : vec4(across, 0.0, depth);
}
