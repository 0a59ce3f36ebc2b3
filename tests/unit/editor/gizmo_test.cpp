// The viewport's mathematics: projection, dragging of gizmos, camera moves and their presets.
#include <gtest/gtest.h>

#include <cmath>

#include "editor/picture/camera_control.h"
#include "editor/picture/node_placement.h"
#include "editor/preferences/navigation_preset.h"
#include "editor/viewport/handles/gizmo.h"
#include "nodes/graph/graph_animation.h"
#include "renderer/scene/light.h"

namespace pileus::editor {
namespace {

const scene::Camera kCamera{{3, 4, 12}, {1, 1, 1}, {0, 1, 0}, 40};
const Projection kView(kCamera, {100, 50}, {900, 500});

void expectNear(const dvec3& a, const dvec3& b, double tolerance) {
  EXPECT_NEAR(a.x, b.x, tolerance);
  EXPECT_NEAR(a.y, b.y, tolerance);
  EXPECT_NEAR(a.z, b.z, tolerance);
}

TEST(Projection, RaysPassThroughWhatTheyShow) {
  EXPECT_NEAR(kView.screen(kCamera.target)->x, 500, 1e-3);
  EXPECT_NEAR(kView.screen(kCamera.target)->y, 275, 1e-3);
  for (const dvec3 p : {dvec3(0.3, 2, -1), dvec3(-2, 0, 4), dvec3(2, 3, 9)}) {
    const Ray ray = kView.ray(*kView.screen(p));
    const dvec3 nearest = ray.origin + glm::dot(p - ray.origin, ray.direction) * ray.direction;
    EXPECT_LT(glm::length(nearest - p), 1e-4 * glm::length(p - ray.origin));
  }
  // The renderer's own rays are these.
  const dvec3 d = scene::rayDirection(kCamera, 800.0 / 450, {0.25, 0.75});
  expectNear(kView.ray({300, 387.5}).direction, d, 1e-6);
}

TEST(Projection, ClipsWhatIsBehindTheCamera) {
  const dvec3 behind = kCamera.eye + 5.0 * (kCamera.eye - kCamera.target);
  EXPECT_FALSE(kView.screen(behind));
  EXPECT_EQ(kView.metresPerPixel(behind), 0);
  EXPECT_FALSE(kView.segment(behind, behind + dvec3(1, 0, 0)));
  // A line through the near plane keeps its direction on the screen.
  const auto whole = kView.segment({0, 0, 0}, behind + dvec3(0.5, 0, 0));
  ASSERT_TRUE(whole);
  EXPECT_NEAR(whole->first.x, kView.screen({0, 0, 0})->x, 1e-2);
  const dvec3 half = glm::mix(dvec3(0), behind + dvec3(0.5, 0, 0), 0.1);
  const vec2 a = whole->first, along = glm::normalize(whole->second - a), mid = *kView.screen(half) - a;
  EXPECT_NEAR(along.x * mid.y - along.y * mid.x, 0, 0.5);
  EXPECT_GT(glm::dot(along, mid), 0);
}

TEST(GizmoMath, ClosestPointOfTwoLines) {
  const Ray ray{{0, 0, 10}, {0, 0, -1}};
  EXPECT_NEAR(*alongLine(ray, {-3, 2, 0}, {1, 0, 0}), 3, 1e-12);
  EXPECT_NEAR(*alongLine(ray, {0, 2, 0}, glm::normalize(dvec3(0, 1, 1))), -std::sqrt(2.0) * 2, 1e-12);
  EXPECT_FALSE(alongLine(ray, {1, 0, 0}, {0, 0, 1})) << "along the ray there is none";
  EXPECT_FALSE(alongLine(ray, {0, 0, 20}, {1, 0, 0})) << "behind the eye";
}

TEST(GizmoMath, RingAnglesGoRoundRightHanded) {
  const dvec3 axis(0, 0, 1), zero(1, 0, 0);
  for (const double angle : {-3.0, -1.0, 0.2, 1.5, 2.9}) {
    const dvec3 p(2 * std::cos(angle), 2 * std::sin(angle), 0);
    const dvec3 eye(1, 1, 7);
    EXPECT_NEAR(*ringAngle({eye, glm::normalize(p - eye)}, dvec3(0), axis, zero), angle, 1e-9);
  }
  // Seen from its edge it still turns with the pointer.
  const auto edge = [&](double y) {
    return *ringAngle({{10, 0, 0}, glm::normalize(dvec3(-10, y, 0))}, dvec3(0), axis, zero);
  };
  EXPECT_GT(edge(0.5), edge(0.1));
  EXPECT_LT(edge(-0.5), edge(0.1));
}

TEST(GizmoMath, EulerAnglesComeBackAndStayClose) {
  for (const dvec3 euler :
       {dvec3(10, 20, 30), dvec3(-170, 80, 100), dvec3(400, -30, 5), dvec3(0, 90, 20), dvec3(33, -90, 0)}) {
    const dvec3 back = eulerDegrees(rotationOf(euler), euler);
    expectNear(back, euler, 1e-4);
  }
  // A turn about a world axis is that turn.
  const dvec3 start(20, 30, 40);
  const glm::dmat3 wanted = turned({0, 0, 1}, glm::radians(25.0)) * rotationOf(start);
  expectNear(eulerDegrees(wanted, start), {20, 30, 65}, 1e-9);
}

TEST(GizmoMath, SunAnglesAreThoseOfItsDirection) {
  for (const dvec2 a : {dvec2(30, 40), dvec2(-100, -20), dvec2(500, 70)}) {
    const dvec2 back = azimuthElevation(scene::sunDirection(a.x, a.y), a.x);
    EXPECT_NEAR(back.x, a.x, 1e-9);
    EXPECT_NEAR(back.y, a.y, 1e-9);
  }
  EXPECT_EQ(azimuthElevation({0, 1, 0}, 77).x, 77);
  EXPECT_EQ(roundStep(0.3), 0.5);
  EXPECT_EQ(roundStep(7), 10);
  EXPECT_EQ(tidy(123456.789, 2000), 123456.79);
}

GizmoTarget transform() {
  GizmoTarget t;
  t.node = "T";
  t.moves = t.turns = t.scales = true;
  t.position = {1, 2, 0.5};
  return t;
}

/// From a handle's place to another point of the world, by the pointer.
std::optional<GizmoDragged> drag(const GizmoFrame& frame, GizmoHandle handle, const dvec3& from,
                                 const dvec3& to, bool snap = false, double grid = 1) {
  return dragGizmo({handle, frame, kView.ray(*kView.screen(from))}, kView.ray(*kView.screen(to)), snap, grid);
}

TEST(Gizmo, HandlesAreOfConstantSizeAndFoundWhereTheyAreDrawn) {
  for (const dvec3 at : {dvec3(1, 1, 1), dvec3(-8, 0, -30), dvec3(2.5, 3, 9)}) {
    GizmoTarget t = transform();
    t.position = at;
    const auto frame = gizmoFrame(t, GizmoMode::Move, false, kView, 80, {});
    ASSERT_TRUE(frame);
    EXPECT_NEAR(frame->size / kView.metresPerPixel(at), 80, 1e-6);
    const auto shapes = gizmoShapes(*frame, kView, 1);
    const dvec3 tip = at + frame->size * dvec3(0, 1, 0);
    const auto hit = gizmoAt(shapes, *kView.screen(tip), 6);
    ASSERT_TRUE(hit);
    EXPECT_EQ(*hit, (GizmoHandle{GizmoHandle::Part::Axis, 1}));
    EXPECT_EQ(gizmoAt(shapes, *kView.screen(at), 6)->part, GizmoHandle::Part::Free);
    EXPECT_FALSE(gizmoAt(shapes, *kView.screen(at) + vec2(0, 200), 6));
  }
  GizmoTarget behind = transform();
  behind.position = kCamera.eye + 2.0 * (kCamera.eye - kCamera.target);
  EXPECT_FALSE(gizmoFrame(behind, GizmoMode::Move, false, kView, 80, {}));
}

TEST(Gizmo, MovesFollowThePointerUnderPerspective) {
  const auto frame = gizmoFrame(transform(), GizmoMode::Move, false, kView, 80, {});
  const dvec3 c = frame->center;
  auto moved = drag(*frame, {GizmoHandle::Part::Axis, 0}, c + dvec3(0.5, 0, 0), c + dvec3(2.25, 0, 0));
  expectNear(moved->target.position, c + dvec3(1.75, 0, 0), 1e-3);
  EXPECT_EQ(moved->readout.substr(0, 2), "X ");
  moved = drag(*frame, {GizmoHandle::Part::Plane, 1}, c, c + dvec3(-1, 0, 1.5));
  expectNear(moved->target.position, c + dvec3(-1, 0, 1.5), 1e-3);
  moved = drag(*frame, {GizmoHandle::Part::Free, 0}, c, c + 0.7 * kView.right() - 0.4 * kView.up());
  expectNear(moved->target.position, c + 0.7 * kView.right() - 0.4 * kView.up(), 1e-3);
  moved = drag(*frame, {GizmoHandle::Part::Axis, 0}, c, c + dvec3(1.7, 0, 0), true, 0.5);
  expectNear(moved->target.position, {2.5, 2, 0.5}, 1e-9);
}

TEST(Gizmo, LocalAxesAreTheNodesOwn) {
  GizmoTarget t = transform();
  t.rotate = {0, 90, 0};
  const auto frame = gizmoFrame(t, GizmoMode::Move, true, kView, 80, {});
  expectNear(frame->axes[0], {0, 0, -1}, 1e-12);
  const auto moved = drag(*frame, {GizmoHandle::Part::Axis, 0}, t.position, t.position + dvec3(0, 0, -2));
  expectNear(moved->target.position, t.position + dvec3(0, 0, -2), 1e-3);
}

TEST(Gizmo, TurnsAndScalesKeepThePivotInPlace) {
  GizmoTarget t = transform();
  t.pivot = {5, 0, 0};
  const auto frame = gizmoFrame(t, GizmoMode::Rotate, false, kView, 80, {});
  const dvec3 c = frame->center;
  const auto at = [&](double a) { return c + frame->size * dvec3(std::sin(a), 0, std::cos(a)); };
  const auto turnedBy = drag(*frame, {GizmoHandle::Part::Ring, 1}, at(0.2), at(0.7));
  expectNear(turnedBy->target.rotate, {0, glm::degrees(0.5), 0}, 1e-2);
  EXPECT_EQ(turnedBy->target.position, c);
  expectNear(dvec3(turnedBy->target.placement() * dvec4(t.pivot, 1)), c, 1e-9);
  const auto snapped = drag(*frame, {GizmoHandle::Part::Ring, 1}, at(0.2), at(0.7), true);
  expectNear(snapped->target.rotate, {0, 30, 0}, 1e-9);

  const auto grown = gizmoFrame(t, GizmoMode::Scale, false, kView, 80, {});
  const auto scaled =
      drag(*grown, {GizmoHandle::Part::ScaleAxis, 2}, c + dvec3(0, 0, 0.8), c + dvec3(0, 0, 1.6));
  expectNear(scaled->target.scale, {1, 1, 2}, 1e-3);
  const auto all = drag(*grown, {GizmoHandle::Part::ScaleAll, 0}, c, c + grown->size * kView.right());
  expectNear(all->target.scale, dvec3(2), 1e-3);
}

TEST(Gizmo, TheSunFollowsItsDisc) {
  GizmoTarget t;
  t.node = "Sun";
  t.sun = true;
  t.azimuth = 20, t.elevation = 30;
  const auto frame = gizmoFrame(t, GizmoMode::Select, false, kView, 80, {1, 1, 1});
  ASSERT_TRUE(frame);
  const auto disc = [&](double az, double el) {
    return frame->center + frame->size * scene::sunDirection(az, el);
  };
  const auto moved = drag(*frame, {GizmoHandle::Part::SunDisc, 0}, disc(20, 30), disc(50, 10));
  EXPECT_NEAR(moved->target.azimuth, 50, 1);
  EXPECT_NEAR(moved->target.elevation, 10, 1);
  const auto level = drag(*frame, {GizmoHandle::Part::SunAzimuth, 0}, disc(10, 0), disc(-35, 0));
  EXPECT_NEAR(level->target.azimuth, -25, 1e-2);
  EXPECT_EQ(level->target.elevation, 30);
  const auto upright = drag(*frame, {GizmoHandle::Part::SunElevation, 0}, disc(20, 10), disc(20, 40), true);
  EXPECT_EQ(upright->target.elevation, 60);
  EXPECT_EQ(upright->target.azimuth, 20);
}

TEST(Gizmo, AConeOpensByItsRim) {
  GizmoTarget t;
  t.node = "Spot";
  t.moves = t.aims = t.hasCone = true;
  t.position = {0, 3, 0}, t.aim = {0, 0, 0}, t.cone = 60;
  const auto frame = gizmoFrame(t, GizmoMode::Select, false, kView, 80, {});
  const dvec3 u = glm::normalize(glm::cross(dvec3(0, -1, 0), kView.forward()));
  const auto rim = [&](double half) {
    return t.position + 3.0 * (std::cos(half) * dvec3(0, -1, 0) + std::sin(half) * u);
  };
  const auto opened =
      drag(*frame, {GizmoHandle::Part::Cone, 0}, rim(glm::radians(30.0)), rim(glm::radians(45.0)));
  EXPECT_NEAR(opened->target.cone, 90, 0.05);
}

TEST(GizmoTarget, WritesOnlyWhatWasDragged) {
  nodes::Graph graph = *nodes::addNode(nodes::Graph{}, "volume.transform", {}, "T");
  graph = *nodes::setParam(graph, "T", "translate", dvec3(1, 2, 3));
  const auto before = gizmoTarget(graph, "T", {10, 0, 0}, 1);
  ASSERT_TRUE(before);
  expectNear(before->position, {11, 2, 3}, 1e-12);
  GizmoTarget after = *before;
  after.rotate = {0, 0, 90};
  const auto written = withTarget(graph, *before, after, 10, 1);
  ASSERT_TRUE(written);
  const nodes::Node& node = *nodes::findNode(*written, "T");
  // The pivot stays at 11 2 3, so the origin goes to 11 -8 3.
  expectNear(std::get<dvec3>(node.params.at("translate")), {11, -8, 3}, 1e-6);
  expectNear(std::get<dvec3>(node.params.at("rotate")), {0, 0, 90}, 1e-9);
  EXPECT_FALSE(node.params.contains("scale"));
  EXPECT_FALSE(gizmoTarget(*nodes::addNode(nodes::Graph{}, "render.volume", {}, "R"), "R", {}, 1));
}

TEST(GizmoTarget, AnimatedValuesAreThoseOfTheFrameAndGetAKeyThere) {
  nodes::Graph graph = *nodes::addNode(nodes::Graph{}, "light.spot", {}, "S");
  graph = *nodes::setKey(graph, "S", "position", 1, dvec3(0, 0, 0), nodes::Interpolation::Linear);
  graph = *nodes::setKey(graph, "S", "position", 11, dvec3(10, 0, 0), nodes::Interpolation::Linear);
  const auto before = gizmoTarget(graph, "S", {}, 4);
  ASSERT_TRUE(before && before->moves);
  expectNear(before->position, {3, 0, 0}, 1e-12);
  GizmoTarget after = *before;
  after.position.y = 2;
  after.aim = {1, 2, 3};
  const auto written = withTarget(graph, *before, after, 10, 4);
  ASSERT_TRUE(written);
  const nodes::AnimationKey* key = nodes::findKey(*written, {"S", "position", 4});
  ASSERT_TRUE(key);
  expectNear(std::get<dvec3>(key->value), {3, 2, 0}, 1e-9);
  const nodes::Node& node = *nodes::findNode(*written, "S");
  EXPECT_EQ(node.animated.at("position").keys.size(), 3u);
  EXPECT_FALSE(node.animated.contains("target")) << "what is constant stays so";
  expectNear(std::get<dvec3>(node.params.at("target")), {1, 2, 3}, 1e-9);
}

TEST(CameraControl, TurnsAboutAnyPointWithALevelHorizon) {
  const dvec3 pivot(-2, 0.5, 3);
  const vec2 before = *kView.screen(pivot);
  const scene::Camera camera = orbitedAbout(kCamera, pivot, {0.6, 0.2});
  const vec2 after = *Projection(camera, kView.min(), kView.max()).screen(pivot);
  EXPECT_NEAR(before.x, after.x, 1e-2);
  EXPECT_NEAR(before.y, after.y, 1e-2);
  EXPECT_NEAR(glm::length(camera.eye - pivot), glm::length(kCamera.eye - pivot), 1e-9);
  EXPECT_NEAR(scene::basis(camera)[0].y, 0, 1e-12) << "the picture's right is level";
  const scene::Camera same = orbitedAbout(kCamera, kCamera.target, {0.3, -0.2}),
                      plain = orbited(kCamera, {0.3, -0.2});
  expectNear(same.eye, plain.eye, 1e-9);
}

TEST(CameraControl, DollyKeepsThePointUnderThePointer) {
  const dvec3 point(4, -1, 2);
  const scene::Camera camera = dolliedTo(kCamera, point, 0.5);
  const vec2 before = *kView.screen(point),
             after = *Projection(camera, kView.min(), kView.max()).screen(point);
  EXPECT_NEAR(before.x, after.x, 1e-2);
  EXPECT_NEAR(before.y, after.y, 1e-2);
  EXPECT_NEAR(glm::length(camera.eye - camera.target), 0.5 * glm::length(kCamera.eye - kCamera.target), 1e-9);
}

TEST(CameraControl, LooksFromAnAxis) {
  const scene::Camera side = seenFrom(kCamera, {1, 0, 0});
  EXPECT_EQ(side.target, kCamera.target);
  EXPECT_NEAR(side.eye.y, 1, 1e-12);
  const scene::Camera top = seenFrom(kCamera, {0, 1, 0});
  EXPECT_GT(top.eye.y - top.target.y, 0.999 * glm::length(top.eye - top.target));
  EXPECT_GT(glm::length(glm::cross(glm::normalize(top.eye - top.target), top.up)), 1e-4)
      << "up is still defined";
}

TEST(Navigation, PresetsChooseTheMove) {
  using P = NavigationPreset;
  const auto move = [](P preset, NavigationInput in) { return navigationMove(preset, in).move; };
  for (const P preset : {P::Maya, P::Houdini}) {
    EXPECT_EQ(move(preset, {.button = 0, .alt = true}), CameraMove::Orbit);
    EXPECT_EQ(move(preset, {.button = 2, .alt = true}), CameraMove::Pan);
    EXPECT_EQ(move(preset, {.button = 1, .alt = true}), CameraMove::Dolly);
  }
  EXPECT_EQ(move(P::Houdini, {.button = 2, .space = true}), CameraMove::Pan);
  EXPECT_TRUE(navigationMove(P::Maya, {.button = 0, .space = true}).plain);
  EXPECT_FALSE(navigationMove(P::Houdini, {.button = 0, .space = true}).plain);
  EXPECT_EQ(move(P::Blender, {.button = 2}), CameraMove::Orbit);
  EXPECT_EQ(move(P::Blender, {.button = 2, .shift = true}), CameraMove::Pan);
  EXPECT_EQ(move(P::Blender, {.button = 2, .ctrl = true}), CameraMove::Dolly);
  EXPECT_TRUE(navigationMove(P::Blender, {.button = 2, .shift = true}).usesShift);
  EXPECT_EQ(move(P::Maya, {.button = 2}), CameraMove::Pan);
}

TEST(NewNodes, FitTheScene) {
  const Box3 large{{-200, 10, -250}, {200, 90, 250}};
  const auto fitted = [](const char* type, const Box3& bounds) {
    return fittedToScene(*nodes::addNode({}, type, {0, 0}, "New"), "New", bounds);
  };
  const auto placed = [&](const char* type) {
    return *gizmoTarget(fitted(type, large).graph, "New", dvec3(0), 1);
  };
  EXPECT_EQ(placed("volume.box").scale, dvec3(200));
  expectNear(placed("volume.box").position, {0, 50, 0}, 1e-6);
  EXPECT_EQ(placed("volume.sphere").scale, dvec3(100));
  const GizmoTarget plane = placed("solid.plane");
  EXPECT_EQ(plane.scale.x, 2000);
  EXPECT_EQ(plane.scale.z, 2000);
  EXPECT_EQ(plane.position.y, 10) << "it lies under the volumes";
  EXPECT_GT(placed("light.point").position.y, 90);
  expectNear(placed("light.spot").aim, {0, 50, 0}, 1e-6);
  EXPECT_NE(fitted("volume.box", large).note.find("200 m"), std::string::npos);
  // Where the defaults fit, and for what stands nowhere, nothing is written.
  const nodes::Graph plain = *nodes::addNode({}, "volume.box", {0, 0}, "New");
  EXPECT_EQ(fitted("volume.box", {{-1, -1, -1}, {1, 1, 1}}).graph, plain);
  EXPECT_EQ(fitted("volume.box", {}).graph, plain);
  EXPECT_EQ(fitted("light.sun", large).note, "");
  EXPECT_EQ(fitted("value.number", large).note, "");
}

}  // namespace
}  // namespace pileus::editor
