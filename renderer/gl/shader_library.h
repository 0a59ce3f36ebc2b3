#pragma once
// Programs by entry file and defines, compiled once. Sources are embedded; with $PILEUS_SHADERS naming the
// shaders folder they are read from disk instead and reload() picks up edits. Driver messages are given back
// with file names and lines. $PILEUS_SHADER_SOURCES names a folder into which goes what was compiled, as the
// driver got it: PROGRAM.comp, or PROGRAM.vert and PROGRAM.frag. GL thread.
#include <epoxy/gl.h>

#include <filesystem>
#include <map>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "renderer/base/math.h"
#include "renderer/base/result.h"

namespace pileus::gl {

using Defines = std::vector<std::pair<std::string, int>>;

/// A linked program; uniforms by name (the location is looked up once).
class Program {
 public:
  Program() = default;
  explicit Program(GLuint id) : id_(id) {}
  ~Program() {
    if (id_) glDeleteProgram(id_);
  }
  Program(Program&& o) noexcept : id_(std::exchange(o.id_, 0)), locations_(std::move(o.locations_)) {}
  Program& operator=(Program&& o) noexcept {
    std::swap(id_, o.id_);
    std::swap(locations_, o.locations_);
    return *this;
  }
  GLuint id() const { return id_; }
  void use() const { glUseProgram(id_); }
  void set(const char* name, int v) { glProgramUniform1i(id_, at(name), v); }
  void set(const char* name, float v) { glProgramUniform1f(id_, at(name), v); }
  void set(const char* name, ivec2 v) { glProgramUniform2i(id_, at(name), v.x, v.y); }
  void set(const char* name, vec2 v) { glProgramUniform2f(id_, at(name), v.x, v.y); }
  void set(const char* name, vec3 v) { glProgramUniform3f(id_, at(name), v.x, v.y, v.z); }
  void set(const char* name, ivec3 v) { glProgramUniform3i(id_, at(name), v.x, v.y, v.z); }
  void set(const char* name, vec4 v) { glProgramUniform4f(id_, at(name), v.x, v.y, v.z, v.w); }
  void set(const char* name, ivec4 v) { glProgramUniform4i(id_, at(name), v.x, v.y, v.z, v.w); }
  void set(const char* name, const mat4& v) {
    glProgramUniformMatrix4fv(id_, at(name), 1, GL_FALSE, &v[0][0]);
  }

 private:
  GLint at(const char* name);
  GLuint id_ = 0;
  std::map<std::string, GLint, std::less<>> locations_;
};

/// What a driver is given for an entry: one text, with includes put in.
struct ShaderSource {
  std::string text;
  std::vector<std::string> files;  ///< by the numbers that #line and a compiler's messages call them
};

/// Names of files for their numbers in a compiler's messages.
std::string withFileNames(const std::string& messages, const std::vector<std::string>& files);

class ShaderLibrary {
 public:
  /// entries: "view/volume_render.comp.glsl", or a .vert and a .frag. The reference stays valid for the
  /// library's life.
  Result<Program*> program(const std::vector<std::string>& entries, const Defines& defines = {});
  /// The same, with `extra` text inserted before the last entry's body (an OCIO transform), cached by
  /// `extraKey`.
  Result<Program*> program(const std::vector<std::string>& entries, const Defines& defines,
                           std::string_view extra, std::string_view extraKey);
  void reload() { programs_.clear(); }
  /// Every entry file (for the tests that compile them all).
  static std::vector<std::string> entries();
  /// `extra` is inserted before the entry's body. Needs no context.
  static Result<ShaderSource> source(const std::string& entry, const Defines& defines,
                                     std::string_view extra = {});
  /// What $PILEUS_SHADER_SOURCES would get of that program. Needs no context.
  static Result<void> writeSources(const std::filesystem::path& folder,
                                   const std::vector<std::string>& entries, const Defines& defines);

 private:
  std::map<std::string, Program> programs_;
};

}  // namespace pileus::gl
