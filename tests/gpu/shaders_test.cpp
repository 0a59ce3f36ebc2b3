// Every shader compiles, says where it does not, and leaves room for more textures.
#include <epoxy/gl.h>

#include <algorithm>
#include <set>
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
                             {"PARTS", 8},
                             {"SHAPES", 7}};

/// Units of the uniforms of these types that are left in a program.
std::vector<int> unitsOf(const gl::Program& program, const std::set<GLenum>& types) {
  GLint count = 0;
  glGetProgramiv(program.id(), GL_ACTIVE_UNIFORMS, &count);
  std::vector<int> units;
  for (GLint i = 0; i < count; ++i) {
    char name[256] = {};
    GLint size = 0;
    GLenum type = 0;
    glGetActiveUniform(program.id(), GLuint(i), sizeof name, nullptr, &size, &type, name);
    if (!types.contains(type)) continue;
    glGetUniformiv(program.id(), glGetUniformLocation(program.id(), name), &units.emplace_back());
  }
  std::sort(units.begin(), units.end());
  return units;
}

const std::set<GLenum> kSamplers = {GL_SAMPLER_1D,
                                    GL_SAMPLER_2D,
                                    GL_SAMPLER_3D,
                                    GL_SAMPLER_2D_ARRAY,
                                    GL_SAMPLER_BUFFER,
                                    GL_INT_SAMPLER_BUFFER,
                                    GL_UNSIGNED_INT_SAMPLER_2D_ARRAY,
                                    GL_UNSIGNED_INT_SAMPLER_BUFFER};
const std::set<GLenum> kImages = {GL_IMAGE_2D, GL_IMAGE_2D_ARRAY, GL_UNSIGNED_INT_IMAGE_2D,
                                  GL_UNSIGNED_INT_IMAGE_BUFFER};

/// What OpenGL 4.5 guarantees of a stage; see gl::DeviceInfo.
void expectGuaranteed(const gl::Program& program, bool compute) {
  EXPECT_LE(unitsOf(program, kSamplers).size(), 16u);
  EXPECT_LE(unitsOf(program, kImages).size(), 8u);
  GLint blocks = 0;
  glGetProgramInterfaceiv(program.id(), GL_SHADER_STORAGE_BLOCK, GL_ACTIVE_RESOURCES, &blocks);
  EXPECT_LE(blocks, 8);
  glGetProgramInterfaceiv(program.id(), GL_UNIFORM_BLOCK, GL_ACTIVE_RESOURCES, &blocks);
  for (GLint i = 0; i < blocks; ++i) {
    GLint bytes = 0;
    glGetActiveUniformBlockiv(program.id(), GLuint(i), GL_UNIFORM_BLOCK_DATA_SIZE, &bytes);
    EXPECT_LE(bytes, 16384);
  }
  if (!compute) return;
  ivec3 group(0);
  glGetProgramiv(program.id(), GL_COMPUTE_WORK_GROUP_SIZE, &group.x);
  EXPECT_LE(group.x * group.y * group.z, 1024);
}

TEST(Shaders, EveryEntryCompilesWithinWhatIsGuaranteed) {
  test::renderer();
  gl::ShaderLibrary library;
  for (const std::string& entry : gl::ShaderLibrary::entries()) {
    std::vector<std::string> stages{entry};
    if (entry.find(".vert.") != entry.npos) continue;  // compiled with their fragment shader
    if (const auto at = entry.find(".frag."); at != entry.npos)
      stages.insert(stages.begin(), entry.substr(0, at) + ".vert.glsl");
    const auto program = library.program(stages, kWidest);
    ASSERT_TRUE(program) << program.error().message;
    SCOPED_TRACE(entry);
    expectGuaranteed(**program, stages.size() == 1);
  }
}

TEST(Shaders, MarchLeavesTextureUnits) {
  test::renderer();
  gl::ShaderLibrary library;
  for (const char* entry : {"view/volume_render.comp.glsl", "truth/shadow_error.comp.glsl"}) {
    const auto program = library.program({entry}, kWidest);
    ASSERT_TRUE(program) << program.error().message;
    // All that shared/bindings.h has for a march, and nothing that it calls free.
    EXPECT_EQ(unitsOf(**program, kSamplers), (std::vector{0, 1, 2, 3, 5, 6, 7, 8, 9, 10})) << entry;
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
