// Random walks by the path tracer's own flights and phase functions, for the tests that know their means: of
// the way through a convex body under uniform light (body 1: the unit cube, 2: the unit ball, each around the
// origin), or of the squared distance at which what a point sends out is absorbed (body 0).
#include "shared/bindings.h"
#include "lib/camera.glsl"
#include "lib/scatter.glsl"
#include "lib/tiles.glsl"
layout(local_size_x = 8, local_size_y = 8) in;
// Of each walk. Body 0: x sum of absorbed weights, y of those times the squared distance; else: x length. z:
// collisions, w: is it over?
layout(std430, binding = BIND_TEST_OUT) writeonly buffer Out { vec4 outputs[]; };
uniform int body, firstWalk;
const int kMostCollisions = 3000;

void spendWork(int iterations) {}
bool workIsLeft() { return true; }
void addGlow(vec3 glow) {}

// The place on the body, evenly, and the direction into it, under the cosine, in which uniform light enters.
void enter(out vec3 p, out vec3 d) {
  vec3 u = random3(), v = random3();
  vec3 normal;
  if (body == 1) {
    int face = min(int(6.0 * u.z), 5), axis = face >> 1;
    float side = (face & 1) == 1 ? 0.5 : -0.5;
    p = axis == 0 ? vec3(side, u.xy - 0.5) : axis == 1 ? vec3(u.x - 0.5, side, u.y - 0.5)
                                                       : vec3(u.xy - 0.5, side);
    normal = axis == 0 ? vec3(side, 0.0, 0.0) : axis == 1 ? vec3(0.0, side, 0.0) : vec3(0.0, 0.0, side);
    normal *= -2.0;
  } else {
    p = directionAround(vec3(0.0, 1.0, 0.0), 2.0 * u.x - 1.0, u.y);
    normal = -p;
  }
  d = directionAround(normal, sqrt(v.x), v.y);
}

float bodyEnd(vec3 p, vec3 d) {
  if (body == 0) return 1e30;
  vec2 hit = body == 1 ? intersectBox(p, d, vec3(-0.5), vec3(0.5)) : intersectBall(p, d);
  return max(hit.y, 0.0);
}

void main() {
  ivec2 pixel = regionPixel();
  if (!inRegion(pixel)) return;
  seedPath(pixel, firstWalk);
  vec3 p = vec3(0.0), d = vec3(0.0, 1.0, 0.0);
  if (body == 0) {
    vec3 u = random3();
    d = directionAround(d, 2.0 * u.x - 1.0, u.y);
  } else {
    enter(p, d);
  }
  pathWeight = vec3(1.0), pathRatio = vec3(1.0), pathChannel = 0;
  ivec2 range = tileRange(ivec2(0));
  vec4 sum = vec4(0.0);
  int collisions = 0;
  bool over = false;
  do {
    Flight f = flightFrom(p, d, bodyEnd(p, d), range, false);
    fly(f);
    bool collided = f.state == kCollided;
    vec3 end = collided ? metAt : p + min(f.end, 1e15) * d;
    if (body != 0) sum.x += distance(p, end);
    over = !collided;
    if (collided) {
      Vertex v = mediumVertex(d);
      float absorbed = pathWeight.r * (1.0 - v.albedo.r);
      if (body == 0) sum.xy += absorbed * vec2(1.0, dot(end, end));
      pathWeight *= v.albedo;
      p = v.p, d = scatteredDirection(v);
      ++collisions;
      over = body == 0 && pathWeight.r < 1e-7;
    }
  } while (!over && collisions < kMostCollisions);
  outputs[regionSlot(pixel)] = vec4(sum.xy, float(collisions), over && violations == 0 ? 1.0 : 0.0);
}
