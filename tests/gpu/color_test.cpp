// The GPU form of every display transform against its CPU twin, on the shipped config and on configs with
// LUTs.
#include <epoxy/gl.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <fstream>

#include "renderer/gl/context.h"
#include "renderer/image/color.h"
#include "tests/support/support.h"

namespace pileus {
namespace {

namespace fs = std::filesystem;
using image::LutTexture;

constexpr const char* kVertex = R"(#version 450 core
void main() { gl_Position = vec4(gl_VertexID == 1 ? 3.0 : -1.0, gl_VertexID == 2 ? 3.0 : -1.0, 0.0, 1.0); })";

GLuint compile(GLenum stage, const std::string& text) {
  const GLuint shader = glCreateShader(stage);
  const char* source = text.c_str();
  glShaderSource(shader, 1, &source, nullptr);
  glCompileShader(shader);
  GLint ok = 0;
  glGetShaderiv(shader, GL_COMPILE_STATUS, &ok);
  if (!ok) {
    char log[4096];
    glGetShaderInfoLog(shader, sizeof log, nullptr, log);
    ADD_FAILURE() << log;
  }
  return shader;
}

GLuint upload(const LutTexture& lut) {
  const std::array<GLenum, 4> targets{0, GL_TEXTURE_1D, GL_TEXTURE_2D, GL_TEXTURE_3D};
  const GLenum target = targets[static_cast<std::size_t>(lut.dimensions)];
  const GLenum format = lut.channels == 1 ? GL_RED : GL_RGB,
               internal = lut.channels == 1 ? GL_R32F : GL_RGB32F;
  GLuint id = 0;
  glCreateTextures(target, 1, &id);
  if (lut.dimensions == 1) {
    glTextureStorage1D(id, 1, internal, lut.size.x);
    glTextureSubImage1D(id, 0, 0, lut.size.x, format, GL_FLOAT, lut.texels.data());
  } else if (lut.dimensions == 2) {
    glTextureStorage2D(id, 1, internal, lut.size.x, lut.size.y);
    glTextureSubImage2D(id, 0, 0, 0, lut.size.x, lut.size.y, format, GL_FLOAT, lut.texels.data());
  } else {
    glTextureStorage3D(id, 1, internal, lut.size.x, lut.size.y, lut.size.z);
    glTextureSubImage3D(id, 0, 0, 0, 0, lut.size.x, lut.size.y, lut.size.z, format, GL_FLOAT,
                        lut.texels.data());
  }
  for (const GLenum wrap : {GL_TEXTURE_WRAP_S, GL_TEXTURE_WRAP_T, GL_TEXTURE_WRAP_R})
    glTextureParameteri(id, wrap, GL_CLAMP_TO_EDGE);
  for (const GLenum filter : {GL_TEXTURE_MIN_FILTER, GL_TEXTURE_MAG_FILTER})
    glTextureParameteri(id, filter, lut.linear ? GL_LINEAR : GL_NEAREST);
  return id;
}

/// The transform of one row of RGBA pixels on the GPU, in float.
std::vector<float> applyGpu(const image::GpuTransform& transform, const std::vector<float>& pixels) {
  const int width = static_cast<int>(pixels.size() / 4);
  const std::string fragment =
      "#version 450 core\n" + transform.glsl +
      "\nuniform sampler2D picture;\nout vec4 shown;\n"
      "void main() { shown = ocioDisplay(texelFetch(picture, ivec2(gl_FragCoord.xy), 0)); }\n";
  const GLuint program = glCreateProgram(), vs = compile(GL_VERTEX_SHADER, kVertex),
               fs = compile(GL_FRAGMENT_SHADER, fragment);
  glAttachShader(program, vs);
  glAttachShader(program, fs);
  glLinkProgram(program);
  GLint linked = 0;
  glGetProgramiv(program, GL_LINK_STATUS, &linked);
  EXPECT_TRUE(linked);
  glUseProgram(program);

  GLuint pictures[2], framebuffer = 0, vertices = 0;
  glCreateTextures(GL_TEXTURE_2D, 2, pictures);
  for (const GLuint picture : pictures) glTextureStorage2D(picture, 1, GL_RGBA32F, width, 1);
  glTextureSubImage2D(pictures[0], 0, 0, 0, width, 1, GL_RGBA, GL_FLOAT, pixels.data());
  glTextureParameteri(pictures[0], GL_TEXTURE_MIN_FILTER, GL_NEAREST);
  glBindTextureUnit(0, pictures[0]);
  std::vector<GLuint> luts;
  for (const LutTexture& lut : transform.textures) {
    luts.push_back(upload(lut));
    const auto unit = static_cast<GLuint>(luts.size());
    glUniform1i(glGetUniformLocation(program, lut.sampler.c_str()), static_cast<GLint>(unit));
    glBindTextureUnit(unit, luts.back());
  }
  glCreateFramebuffers(1, &framebuffer);
  glNamedFramebufferTexture(framebuffer, GL_COLOR_ATTACHMENT0, pictures[1], 0);
  glBindFramebuffer(GL_FRAMEBUFFER, framebuffer);
  glViewport(0, 0, width, 1);
  glCreateVertexArrays(1, &vertices);
  glBindVertexArray(vertices);
  glDrawArrays(GL_TRIANGLES, 0, 3);
  std::vector<float> out(pixels.size());
  glGetTextureImage(pictures[1], 0, GL_RGBA, GL_FLOAT, static_cast<GLsizei>(out.size() * sizeof(float)),
                    out.data());
  EXPECT_EQ(glGetError(), static_cast<GLenum>(GL_NO_ERROR));

  glDeleteVertexArrays(1, &vertices);
  glDeleteFramebuffers(1, &framebuffer);
  glDeleteTextures(2, pictures);
  glDeleteTextures(static_cast<GLsizei>(luts.size()), luts.data());
  for (const GLuint shader : {vs, fs}) glDeleteShader(shader);
  glDeleteProgram(program);
  return out;
}

/// Dark to far above white, neutral and saturated.
std::vector<float> colors() {
  std::vector<float> out;
  const std::array levels{0.0f, 0.002f, 0.05f, 0.18f, 0.5f, 1.0f, 4.0f, 30.0f};
  for (const float r : levels)
    for (const float g : levels)
      for (const float b : levels) out.insert(out.end(), {r, g, b, 0.75f});
  return out;
}

void expectTwins(const image::ColorConfig& config, const std::string& display, const std::string& view,
                 float tolerance) {
  std::vector<float> cpu = colors();
  const auto gpu = config.gpuTransform(display, view);
  ASSERT_TRUE(gpu) << gpu.error().message;
  const std::vector<float> shown = applyGpu(*gpu, cpu);
  ASSERT_TRUE(config.applyCpu(display, view, cpu.data(), cpu.size() / 4));
  for (std::size_t i = 0; i < cpu.size(); ++i)
    ASSERT_NEAR(shown[i], cpu[i], tolerance * std::max(1.0f, std::abs(cpu[i])))
        << display << " / " << view << ", pixel " << i / 4 << ", channel " << i % 4;
}

class ColorGpu : public testing::Test {
 protected:
  void SetUp() override {
    auto made = gl::HeadlessContext::create();
    ASSERT_TRUE(made) << made.error().message;
    context_ = std::move(*made);
  }
  std::unique_ptr<gl::HeadlessContext> context_;
};

TEST_F(ColorGpu, ShippedViewsEqualTheirCpuTwins) {
  const auto config = image::ColorConfig::load(std::string(PILEUS_SOURCE_DIR) + "/presets/color/pileus.ocio");
  ASSERT_TRUE(config) << config.error().message;
  for (const std::string& display : (*config)->displays())
    for (const std::string& view : (*config)->views(display)) expectTwins(**config, display, view, 1e-4f);
}

/// A short LUT is a sampler1D, a cube a sampler3D.
TEST_F(ColorGpu, ShortAndCubicLutsEqualTheirCpuTwins) {
  const fs::path folder = test::scratchFolder();
  std::ofstream curve(folder / "curve.spi1d");
  curve << "Version 1\nFrom 0.0 4.0\nLength 33\nComponents 1\n{\n";
  for (int i = 0; i < 33; ++i) curve << std::sqrt(static_cast<double>(i) / 32.0) << "\n";
  curve << "}\n";
  curve.close();
  std::ofstream cube(folder / "cube.spi3d");
  cube << "SPILUT 1.0\n3 3\n5 5 5\n";
  for (int r = 0; r < 5; ++r)
    for (int g = 0; g < 5; ++g)
      for (int b = 0; b < 5; ++b)
        cube << r << ' ' << g << ' ' << b << ' ' << (r * r) / 16.0 << ' ' << (r + g) / 8.0 << ' '
             << (b * g) / 16.0 << "\n";
  cube.close();
  std::ofstream(folder / "luts.ocio")
      << "ocio_profile_version: 2\nsearch_path: .\nroles: {default: ACEScg, scene_linear: ACEScg}\n"
         "file_rules: [!<Rule> {name: Default, colorspace: default}]\n"
         "displays:\n  Screen:\n    - !<View> {name: Curve, colorspace: curve}\n    - !<View> {name: Cube, "
         "colorspace: cube}\n"
         "    - !<View> {name: Tetrahedra, colorspace: tetrahedra}\n    - !<View> {name: Steps, colorspace: "
         "steps}\n"
         "colorspaces:\n  - !<ColorSpace> {name: ACEScg, isdata: false}\n"
         "  - !<ColorSpace> {name: curve, from_scene_reference: !<FileTransform> {src: curve.spi1d, "
         "interpolation: linear}}\n"
         "  - !<ColorSpace> {name: steps, from_scene_reference: !<FileTransform> {src: curve.spi1d, "
         "interpolation: nearest}}\n"
         "  - !<ColorSpace> {name: cube, from_scene_reference: !<FileTransform> {src: cube.spi3d, "
         "interpolation: linear}}\n"
         "  - !<ColorSpace> {name: tetrahedra, from_scene_reference: !<FileTransform> {src: cube.spi3d, "
         "interpolation: "
         "tetrahedral}}\n";
  const auto config = image::ColorConfig::load((folder / "luts.ocio").string());
  ASSERT_TRUE(config) << config.error().message;
  const auto curveOnGpu = (*config)->gpuTransform("Screen", "Curve"),
             cubeOnGpu = (*config)->gpuTransform("Screen", "Cube");
  ASSERT_TRUE(curveOnGpu && cubeOnGpu);
  ASSERT_EQ(curveOnGpu->textures.size(), 1u);
  EXPECT_EQ(curveOnGpu->textures[0].dimensions, 1);
  ASSERT_EQ(cubeOnGpu->textures.size(), 1u);
  EXPECT_EQ(cubeOnGpu->textures[0].dimensions, 3);
  // Texture units filter with 8 bits of fraction.
  for (const char* view : {"Curve", "Steps", "Cube", "Tetrahedra"})
    expectTwins(**config, "Screen", view, 1.0f / 256.0f);
}

TEST_F(ColorGpu, ViewsOfOtherConfigsEqualTheirCpuTwins) {
  PILEUS_NEEDS_DATA();
  for (const char* name : {"blender-3.4-filmic/config.ocio", "nuke-default_osl/config.ocio",
                           "aces_builtin/cg-config-v1.0.0_aces-v1.3_ocio-v2.1.ocio"}) {
    const auto config = image::ColorConfig::load((*test::dataFolder() / "ocio" / name).string());
    ASSERT_TRUE(config) << config.error().message;
    for (const std::string& display : (*config)->displays())
      for (const std::string& view : (*config)->views(display))
        // A false-colour view is all steps: one quantum of the texture unit may fall on the next colour.
        if (view != "False Color") expectTwins(**config, display, view, 4e-3f);
  }
}

}  // namespace
}  // namespace pileus
