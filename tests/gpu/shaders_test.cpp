// Every shader compiles, says where it does not, and leaves room for more textures.
#include <epoxy/gl.h>

#include <algorithm>
#include <vector>

#include "renderer/gl/shader_library.h"
#include "renderer/shaders/shared/records.h"
#include "tests/support/gpu.h"

namespace pileus {
namespace {

/// With everything in it that needs something bound.
const gl::Defines kWidest = {{"METRIC_FLOATS", 8},
                             {"BASIS_FLOATS", 8},
                             {"STORES", 7},
                             {"LIGHT_KINDS", 31},
                             {"STORE", 1},
                             {"INTERVALS", 4},
                             {"BRICKS", 1},
                             {"WEIGHTS", 1},
                             {"HORIZON", 1},
                             {"PROBES", 64},
                             {"COEFFICIENTS", 8},
                             {"DAMPING", 1},
                             {"PERSPECTIVE", 1},
                             {"STEP_HALVES", 2},
                             {"LOOKUP_BASES", 15},
                             {"RESUME", 1},
                             {"BATCHED", 1},
                             {"WINDOWED", 1},
                             {"FILL", 1},
                             {"FILTER", 2},
                             {"SOLIDS", 1},
                             {"TERMS", 4},
                             {"METRIC", METRIC_COSINE},
                             {"METRIC_COUNT", 4},
                             {"BASIS", BASIS_COSINE},
                             {"ACTIVE", 4},
                             {"OVERFLOW", 1},
                             {"LIGHTS", 0},
                             {"SHAPES", 7}};

TEST(Shaders, EveryEntryCompiles) {
  test::renderer();
  gl::ShaderLibrary library;
  for (const std::string& entry : gl::ShaderLibrary::entries()) {
    std::vector<std::string> stages{entry};
    if (entry.find(".vert.") != entry.npos) continue;  // compiled with their fragment shader
    if (const auto at = entry.find(".frag."); at != entry.npos)
      stages.insert(stages.begin(), entry.substr(0, at) + ".vert.glsl");
    const auto program = library.program(stages, kWidest);
    EXPECT_TRUE(program) << program.error().message;
  }
}

/// Units of the samplers that are left in a program.
std::vector<int> unitsOf(const gl::Program& program) {
  GLint count = 0;
  glGetProgramiv(program.id(), GL_ACTIVE_UNIFORMS, &count);
  std::vector<int> units;
  for (GLint i = 0; i < count; ++i) {
    char name[256] = {};
    GLint size = 0;
    GLenum type = 0;
    glGetActiveUniform(program.id(), GLuint(i), sizeof name, nullptr, &size, &type, name);
    const GLenum samplers[] = {GL_SAMPLER_1D,
                               GL_SAMPLER_2D,
                               GL_SAMPLER_3D,
                               GL_SAMPLER_2D_ARRAY,
                               GL_SAMPLER_BUFFER,
                               GL_INT_SAMPLER_BUFFER,
                               GL_UNSIGNED_INT_SAMPLER_2D_ARRAY,
                               GL_UNSIGNED_INT_SAMPLER_BUFFER};
    if (std::find(std::begin(samplers), std::end(samplers), type) == std::end(samplers)) continue;
    glGetUniformiv(program.id(), glGetUniformLocation(program.id(), name), &units.emplace_back());
  }
  std::sort(units.begin(), units.end());
  return units;
}

TEST(Shaders, MarchLeavesTextureUnits) {
  test::renderer();
  gl::ShaderLibrary library;
  for (const char* entry : {"view/volume_render.comp.glsl", "truth/shadow_error.comp.glsl"}) {
    const auto program = library.program({entry}, kWidest);
    ASSERT_TRUE(program) << program.error().message;
    // All that shared/bindings.h has for a march, and nothing that it calls free.
    EXPECT_EQ(unitsOf(**program), (std::vector{0, 1, 2, 3, 5, 6, 7, 8, 9, 10})) << entry;
  }
}

TEST(Shaders, MessagesNameFileAndLine) {
  test::renderer();
  test::ExpectLogged expected;
  gl::ShaderLibrary library;
  const auto program = library.program({"shadow/lookup.comp.glsl"}, {},
                                       "#define lookupTransmittance noSuchFunction(\n", "broken");
  ASSERT_FALSE(program);
  EXPECT_NE(program.error().message.find(".glsl:"), std::string::npos) << program.error().message;
}

}  // namespace
}  // namespace pileus
