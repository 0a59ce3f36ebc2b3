#include "renderer/shadow/additive_target.h"

namespace pileus::shadow {

AdditiveTarget::AdditiveTarget() {
  glCreateFramebuffers(1, &framebuffer_);
  glCreateVertexArrays(1, &vertices_);
  glGetIntegerv(GL_VIEWPORT, viewport_);
  glGetIntegerv(GL_DRAW_FRAMEBUFFER_BINDING, &bound_);
  glBindFramebuffer(GL_DRAW_FRAMEBUFFER, framebuffer_);
  glBindVertexArray(vertices_);
  for (const GLenum state : {GL_CULL_FACE, GL_DEPTH_TEST}) glDisable(state);
  for (const GLenum state : {GL_SCISSOR_TEST, GL_DEPTH_CLAMP, GL_BLEND}) glEnable(state);
  glBlendEquation(GL_FUNC_ADD);
  glBlendFunc(GL_ONE, GL_ONE);
}

AdditiveTarget::~AdditiveTarget() {
  for (const GLenum state : {GL_SCISSOR_TEST, GL_DEPTH_CLAMP, GL_BLEND}) glDisable(state);
  glBindVertexArray(0);
  glBindFramebuffer(GL_DRAW_FRAMEBUFFER, GLuint(bound_));
  glViewport(viewport_[0], viewport_[1], viewport_[2], viewport_[3]);
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
