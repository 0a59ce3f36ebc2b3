#include "renderer/shadow/metric_faces.h"

#include "renderer/gl/texture.h"
#include "renderer/shaders/shared/bindings.h"
#include "renderer/shadow/additive_target.h"

namespace pileus::shadow {
Result<void> drawMetricFaces(const Gpu& gpu, const MetricOptions& options, MapPass& pass,
                             const ShadowBlock& block) {
  const gpu::BlockRecord record = block.record();
  const int metric = options.metric == Metric::Cosine ? METRIC_COSINE : METRIC_FOURIER, edge = record.place.z,
            layers = block.layers();
  PILEUS_TRY(gl::Program * program,
             gpu.shaders.program({"shadow/metric_faces.vert.glsl", "shadow/metric_faces.frag.glsl"},
                                 {{"METRIC", metric}, {"TERMS", options.coefficients}}));
  // Half maps are summed in float and rounded once.
  gl::Texture sum;
  if (block.texels() != Texels::Float) {
    PILEUS_TRY(
        sum, gl::Texture::create(GL_TEXTURE_2D_ARRAY, GL_RGBA32F, ivec3(ivec2(edge), layers), "metric sum"));
  }
  AdditiveTarget target;
  for (int face = 0; face < block.faces(); ++face) {
    const int first = record.place.w + face * layers;
    target.attach(sum ? sum.id() : block.texture(), sum ? 0 : first, layers,
                  sum ? ivec2(0) : ivec2(record.place), edge, true);
    PILEUS_CHECK(pass.bind(gpu, *program));
    program->set("face", face);
    pass.timer().begin();
    glDrawArraysInstanced(GL_TRIANGLES, 0, 36, GLsizei(pass.volumes().size()));
    pass.timer().end();
    if (!sum) continue;
    GLuint out = 0;
    glCreateFramebuffers(1, &out);
    glDisable(GL_SCISSOR_TEST);
    const int x = record.place.x, y = record.place.y;
    for (int layer = 0; layer < layers; ++layer) {
      glNamedFramebufferReadBuffer(target.framebuffer(), GL_COLOR_ATTACHMENT0 + GLenum(layer));
      glNamedFramebufferTextureLayer(out, GL_COLOR_ATTACHMENT0, block.texture(), 0, first + layer);
      glBlitNamedFramebuffer(target.framebuffer(), out, 0, 0, edge, edge, x, y, x + edge, y + edge,
                             GL_COLOR_BUFFER_BIT, GL_NEAREST);
    }
    glEnable(GL_SCISSOR_TEST);
    glDeleteFramebuffers(1, &out);
  }
  glFinish();
  return {};
}

}  // namespace pileus::shadow
