// camera.perspective: a pinhole camera.
#include "nodes/declare/describe.h"

namespace pileus::nodes {
namespace {

struct In {
  dvec3 eye{0, 0, 5};
  dvec3 target{0};
  dvec3 up{0, 1, 0};
  double fov = 40;
  bool lock = false;
};

struct Out {
  CameraValue camera;
};

void describe(Describe<In, Out>& d) {
  d.name("Camera").category("Camera").keywords("perspective view pinhole lens eye");
  d.help("A pinhole camera. Linked to a render it replaces the viewport's free camera.");
  d.in("eye", &In::eye).unit("m").range(-1e7, 1e7).soft(-20, 20).help("Where it stands.");
  d.in("target", &In::target)
      .unit("m")
      .range(-1e7, 1e7)
      .soft(-20, 20)
      .help("What it looks at; orbiting turns about it.");
  d.in("up", &In::up).range(-1e6, 1e6).soft(-1, 1).help("The direction that is up in the picture.");
  d.in("fov", &In::fov).unit("deg").range(0.1, 170).soft(10, 100).help("Vertical angle of view.");
  d.in("lock", &In::lock)
      .forEditor()
      .help("Moves in the viewport leave it alone: they look around freely, with a way back.");
  d.out("camera", &Out::camera).help("The camera.");
}

Result<Out> evaluate(const In& in, EvalContext& ctx) {
  if (glm::length(in.target - in.eye) < 1e-9)
    return fail(Code::Input, "target: is where the eye is; move one of them");
  if (glm::length(in.up) < 1e-9) return fail(Code::Input, "up: has no direction; 0 1 0 is the usual one");
  if (glm::length(glm::cross(glm::normalize(in.target - in.eye), glm::normalize(in.up))) < 1e-6)
    ctx.warn("up: is parallel to the view; another direction is used");
  return Out{{std::make_shared<const scene::Camera>(scene::Camera{in.eye, in.target, in.up, in.fov})}};
}

}  // namespace

NodeType node_camera_perspective() { return makeNode<In, Out>("camera.perspective", 1, describe, evaluate); }

}  // namespace pileus::nodes
