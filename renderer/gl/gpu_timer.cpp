#include "renderer/gl/gpu_timer.h"

namespace pileus::gl {

GpuTimer::~GpuTimer() {
  for (const GLuint q : waiting_) glDeleteQueries(1, &q);
}

void GpuTimer::begin() {
  GLuint query = 0;
  glGenQueries(1, &query);
  glBeginQuery(GL_TIME_ELAPSED, query);
  waiting_.push_back(query);
}

void GpuTimer::end() { glEndQuery(GL_TIME_ELAPSED); }

double GpuTimer::takeMs() {
  double ms = 0;
  while (!waiting_.empty()) {
    GLint ready = 0;
    glGetQueryObjectiv(waiting_.front(), GL_QUERY_RESULT_AVAILABLE, &ready);
    if (!ready) break;
    GLuint64 ns = 0;
    glGetQueryObjectui64v(waiting_.front(), GL_QUERY_RESULT, &ns);
    ms += static_cast<double>(ns) * 1e-6;
    glDeleteQueries(1, &waiting_.front());
    waiting_.pop_front();
  }
  return ms;
}

}  // namespace pileus::gl
