#include "renderer/shadow/additive_target.h"

namespace pileus::shadow {
namespace {

struct Switch {
  GLenum state;
  bool on;  ///< while drawing
};
constexpr Switch kSwitches[] = {{GL_CULL_FACE, false},
                                {GL_DEPTH_TEST, false},
                                {GL_SCISSOR_TEST, true},
                                {GL_DEPTH_CLAMP, true},
                                {GL_BLEND, true}};
constexpr GLenum kEquations[] = {GL_BLEND_EQUATION_RGB, GL_BLEND_EQUATION_ALPHA};
constexpr GLenum kFactors[] = {GL_BLEND_SRC_RGB, GL_BLEND_DST_RGB, GL_BLEND_SRC_ALPHA, GL_BLEND_DST_ALPHA};

void turn(GLenum state, bool on) { on ? glEnable(state) : glDisable(state); }

}  // namespace

AdditiveTarget::AdditiveTarget() {
  glCreateFramebuffers(1, &framebuffer_);
  glCreateVertexArrays(1, &vertices_);
  glGetIntegerv(GL_VIEWPORT, viewport_);
  glGetIntegerv(GL_SCISSOR_BOX, scissor_);
  glGetIntegerv(GL_DRAW_FRAMEBUFFER_BINDING, &bound_);
  glGetIntegerv(GL_VERTEX_ARRAY_BINDING, &boundVertices_);
  for (int i = 0; i < 2; ++i) glGetIntegerv(kEquations[i], &equations_[i]);
  for (int i = 0; i < 4; ++i) glGetIntegerv(kFactors[i], &factors_[i]);
  glBindFramebuffer(GL_DRAW_FRAMEBUFFER, framebuffer_);
  glBindVertexArray(vertices_);
  for (int i = 0; i < 5; ++i) {
    enabled_[i] = glIsEnabled(kSwitches[i].state);
    turn(kSwitches[i].state, kSwitches[i].on);
  }
  glBlendEquation(GL_FUNC_ADD);
  glBlendFunc(GL_ONE, GL_ONE);
}

AdditiveTarget::~AdditiveTarget() {
  for (int i = 0; i < 5; ++i) turn(kSwitches[i].state, enabled_[i]);
  glBlendEquationSeparate(GLenum(equations_[0]), GLenum(equations_[1]));
  glBlendFuncSeparate(GLenum(factors_[0]), GLenum(factors_[1]), GLenum(factors_[2]), GLenum(factors_[3]));
  glBindVertexArray(GLuint(boundVertices_));
  glBindFramebuffer(GL_DRAW_FRAMEBUFFER, GLuint(bound_));
  glViewport(viewport_[0], viewport_[1], viewport_[2], viewport_[3]);
  glScissor(scissor_[0], scissor_[1], scissor_[2], scissor_[3]);
  glDeleteFramebuffers(1, &framebuffer_);
  glDeleteVertexArrays(1, &vertices_);
}

void AdditiveTarget::attach(GLuint texture, int first, int layers, ivec2 origin, int edge, bool clear) {
  GLenum buffers[8];
  for (int layer = 0; layer < layers; ++layer) {
    buffers[layer] = GL_COLOR_ATTACHMENT0 + GLenum(layer);
    glNamedFramebufferTextureLayer(framebuffer_, buffers[layer], texture, 0, first + layer);
  }
  glNamedFramebufferDrawBuffers(framebuffer_, layers, buffers);
  glViewport(origin.x, origin.y, edge, edge);
  glScissor(origin.x, origin.y, edge, edge);
  const vec4 zero(0);
  for (int layer = 0; clear && layer < layers; ++layer)
    glClearNamedFramebufferfv(framebuffer_, GL_COLOR, layer, &zero.x);
}

}  // namespace pileus::shadow
