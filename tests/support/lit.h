#pragma once
// What the GPU says a light sends to points, and where rays meet solids: lib/light_transmittance.glsl and
// lib/solid.glsl behind a function.
#include "renderer/shaders/shared/bindings.h"
#include "renderer/shadow/shadow_pass.h"
#include "renderer/view/light_set.h"
#include "tests/support/gpu.h"

namespace pileus::test {

struct Lit {
  dvec3 towards{0};
  double distance = 0;
  dvec3 irradiance{0};  ///< without shadow
  double transmittance = 1;
  dvec3 arriving{0};
  double visibility = 0;
  dvec3 normal{0};  ///< of the nearest solid
  double hit = 0;   ///< its distance; 1e30 for none
  int solid = -1;
};

/// `directions` may be empty where no solids are drawn.
inline std::vector<Lit> lit(const shadow::ShadowedLight& light, const std::vector<dvec3>& points,
                            const scene::SolidList& drawn = {}, const std::vector<dvec3>& directions = {}) {
  const shadow::Gpu gpu = renderer().gpu();
  view::LightSet lights({light}, {}, drawn);
  residency::VolumeSet volumes;
  while (volumes.prepare(gpu.bricks, lights.volumes(), 1e9).value().fraction < 1) {
  }
  gl::Defines defines = lights.defines();
  defines.push_back({"SHAPES", volumes.shapes()});
  auto program = gpu.shaders.program({"test/light.comp.glsl"}, defines);
  if (!program) {
    ADD_FAILURE() << program.error().message;
    std::abort();
  }
  std::vector<vec4> in, out(points.size() * 5);
  for (std::size_t i = 0; i < points.size(); ++i) {
    in.push_back(vec4(vec3(points[i]), 0));
    in.push_back(vec4(i < directions.size() ? vec3(directions[i]) : vec3(0), 0));
  }
  gl::Buffer input, output;
  EXPECT_TRUE(input.assign(std::span<const vec4>(in)));
  EXPECT_TRUE(output.reserve(out.size() * sizeof(vec4)));
  (*program)->use();
  residency::SceneTable table;
  EXPECT_TRUE(lights.bind(gpu.store, table));
  volumes.bind(gpu.bricks, table, **program);
  EXPECT_TRUE(table.bind(**program));
  input.bindStorage(BIND_TEST_IN);
  output.bindStorage(BIND_TEST_OUT);
  (*program)->set("count", int(points.size()));
  (*program)->set("solidCount", int(drawn.size()));
  glDispatchCompute(GLuint((points.size() + 63) / 64), 1, 1);
  glMemoryBarrier(GL_BUFFER_UPDATE_BARRIER_BIT);
  glGetNamedBufferSubData(output.id(), 0, GLsizeiptr(out.size() * sizeof(vec4)), out.data());
  std::vector<Lit> result;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const vec4* o = &out[5 * i];
    result.push_back({dvec3(o[0]), double(o[0].w), dvec3(o[1]), double(o[1].w), dvec3(o[2]), double(o[2].w),
                      dvec3(o[3]), double(o[3].w), int(o[4].x)});
  }
  return result;
}

/// A shadow of any kind, built to the end.
inline shadow::ShadowedLight shadowed(const scene::Light& light, const shadow::ShadowSpec& spec,
                                      const volume::InstanceList& volumes,
                                      const scene::SolidList& solids = {}) {
  if (spec.kind == shadow::ShadowSpec::Kind::RayMarch)
    return {light, shadow::marchedShadow(light, volumes, solids, spec.stepScale)};
  auto map = shadow::buildShadow(renderer().gpu(), spec, light, volumes, solids);
  if (!map) {
    ADD_FAILURE() << map.error().message;
    std::abort();
  }
  return {light, *map};
}

inline scene::Light pointAt(const dvec3& position, float intensity = 1) {
  scene::Light light;
  light.kind = scene::LightKind::Point;
  light.position = position;
  light.emitted = vec3(intensity);
  return light;
}

inline scene::Light spotAt(const dvec3& position, const dvec3& target, double cone, double softness = 0.2) {
  scene::Light light = pointAt(position);
  light.kind = scene::LightKind::Spot;
  light.towards = glm::normalize(position - target);
  light.cone = cone;
  light.softness = softness;
  return light;
}

inline scene::Solid solidPlane(const dvec3& center, const dvec3& size, const dvec3& rotate = dvec3(0),
                               vec3 albedo = vec3(0.5f)) {
  return {scene::SolidShape::Plane, composeTransform(center, rotate, {size.x, 1, size.z}), albedo};
}
inline scene::Solid solidBox(const dvec3& center, const dvec3& size, const dvec3& rotate = dvec3(0),
                             vec3 albedo = vec3(0.5f)) {
  return {scene::SolidShape::Box, composeTransform(center, rotate, size), albedo};
}

inline image::Image render(const view::RenderScene& scene) {
  view::VolumeRenderPass pass(scene);
  runToEnd(pass);
  return view::readBack(*pass.picture()).value();
}

/// RGBA of the ray from the eye to the target.
inline vec4 along(const dvec3& eye, const dvec3& target, view::RenderScene scene) {
  scene.options.size = ivec2(9, 9);
  scene.options.samples = 1;
  scene.options.camera = {
      eye, target, std::abs(glm::normalize(target - eye).y) > 0.99 ? dvec3(0, 0, 1) : dvec3(0, 1, 0), 0.01};
  const image::Image image = render(scene);
  const float* p = &image.layers[0].pixels[(4 * 9 + 4) * 4];
  return {p[0], p[1], p[2], p[3]};
}

}  // namespace pileus::test
