#include "renderer/gl/shader_library.h"

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <optional>
#include <regex>
#include <set>
#include <sstream>

#include "embedded_shaders.h"
#include "renderer/base/file.h"
#include "renderer/base/hash.h"
#include "renderer/base/log.h"

namespace pileus::gl {
namespace {

Result<std::string> textOf(const std::string& path) {
  if (const char* folder = std::getenv("PILEUS_SHADERS"); folder && *folder)
    return readFile(std::filesystem::path(folder) / path);
  for (const EmbeddedFile& f : embedded_shaders())
    if (f.path == path) return std::string(f.bytes);
  return fail(Code::Internal, "shader {}: no such file", path);
}

/// Text with includes put in once each; `files` numbers them for #line.
Result<void> expand(const std::string& path, std::vector<std::string>& files, std::set<std::string>& seen,
                    std::string& out) {
  if (!seen.insert(path).second) return {};
  PILEUS_TRY(const std::string text, textOf(path));
  const std::size_t number = files.size();
  files.push_back(path);
  out += fmt::format("#line 1 {}\n", number);
  std::istringstream lines(text);
  std::string line;
  for (int n = 1; std::getline(lines, line); ++n) {
    if (line.rfind("#include \"renderer/", 0) == 0) {
      out += "\n";  // for C++, inside #ifdef __cplusplus of a shared header
    } else if (line.rfind("#include \"", 0) == 0) {
      const std::size_t end = line.find('"', 10);
      PILEUS_CHECK(expand(line.substr(10, end - 10), files, seen, out));
      out += fmt::format("#line {} {}\n", n + 1, number);
    } else if (line.rfind("#pragma once", 0) == 0) {
      out += "\n";
    } else {
      out += line + "\n";
    }
  }
  return {};
}

GLenum stageOf(const std::string& path) {
  if (path.find(".comp.") != path.npos) return GL_COMPUTE_SHADER;
  return path.find(".vert.") != path.npos ? GL_VERTEX_SHADER : GL_FRAGMENT_SHADER;
}

Result<GLuint> compile(const std::string& entry, const ShaderSource& source) {
  const GLuint shader = glCreateShader(stageOf(entry));
  const char* p = source.text.c_str();
  glShaderSource(shader, 1, &p, nullptr);
  glCompileShader(shader);
  GLint ok = 0;
  glGetShaderiv(shader, GL_COMPILE_STATUS, &ok);
  if (ok) return shader;
  std::string message(16384, '\0');
  GLsizei length = 0;
  glGetShaderInfoLog(shader, static_cast<GLsizei>(message.size()), &length, message.data());
  message.resize(static_cast<std::size_t>(length));
  glDeleteShader(shader);
  return fail(Code::Gpu, "shader {} does not compile:\n{}", entry, withFileNames(message, source.files));
}

/// Named by the content of the whole program.
Result<void> write(const std::filesystem::path& folder, const std::vector<std::string>& entries,
                   const std::vector<ShaderSource>& sources) {
  Hasher hasher;
  for (const ShaderSource& s : sources) hasher.add(s.text);
  for (std::size_t i = 0; i < sources.size(); ++i) {
    std::string text = sources[i].text;
    for (std::size_t f = 0; f < sources[i].files.size(); ++f)
      text += fmt::format("// {}: {}\n", f, sources[i].files[f]);
    const std::string stage = entries[i].substr(entries[i].find('.'), 5);  // ".comp"
    const std::filesystem::path path = folder / (hasher.key().hex() + stage);
    if (!(std::ofstream(path) << text).flush())
      return fail(Code::Input, "shader sources: {} cannot be written", path.string());
  }
  return {};
}

}  // namespace

/// "0:12(3): error" of Mesa, "0(12) : error" of NVIDIA, "ERROR: 0:12: " of the reference compiler.
std::string withFileNames(const std::string& messages, const std::vector<std::string>& files) {
  static const std::regex place(R"((^|\n)(?:ERROR: )?(\d+)[:(](\d+))");
  std::string out;
  auto last = messages.cbegin();
  for (std::sregex_iterator it(messages.begin(), messages.end(), place), end; it != end; ++it) {
    const std::size_t file = std::stoul((*it)[2]);
    out.append(last, (*it)[0].first);
    out += (*it)[1].str() + (file < files.size() ? files[file] : "?") + ":" + (*it)[3].str();
    last = (*it)[0].second;
  }
  return out.append(last, messages.cend());
}

Result<ShaderSource> ShaderLibrary::source(const std::string& entry, const Defines& defines,
                                           std::string_view extra) {
  ShaderSource source{"#version 450 core\n", {}};
  for (const auto& [name, value] : defines) source.text += fmt::format("#define {} {}\n", name, value);
  source.text += extra;
  std::set<std::string> seen;
  PILEUS_CHECK(expand(entry, source.files, seen, source.text));
  return source;
}

GLint Program::at(const char* name) {
  if (const auto it = locations_.find(std::string_view(name)); it != locations_.end()) return it->second;
  return locations_.emplace(name, glGetUniformLocation(id_, name)).first->second;
}

Result<Program*> ShaderLibrary::program(const std::vector<std::string>& entries, const Defines& defines) {
  return program(entries, defines, {}, {});
}

Result<Program*> ShaderLibrary::program(const std::vector<std::string>& entries, const Defines& defines,
                                        std::string_view extra, std::string_view extraKey) {
  std::string key(extraKey);
  for (const std::string& e : entries) key += "|" + e;
  for (const auto& [name, value] : defines) key += fmt::format("|{}={}", name, value);
  if (const auto it = programs_.find(key); it != programs_.end()) return &it->second;

  std::vector<ShaderSource> sources;
  for (const std::string& e : entries) {
    PILEUS_TRY(ShaderSource s, source(e, defines, &e == &entries.back() ? extra : std::string_view{}));
    sources.push_back(std::move(s));
  }
  const GLuint id = glCreateProgram();
  std::vector<GLuint> shaders;
  std::optional<Error> error;
  for (std::size_t i = 0; i < entries.size(); ++i) {
    auto shader = compile(entries[i], sources[i]);
    if (!shader) {
      error = shader.error();
      break;
    }
    shaders.push_back(*shader);
    glAttachShader(id, *shader);
  }
  if (!error) {
    glLinkProgram(id);
    GLint ok = 0;
    glGetProgramiv(id, GL_LINK_STATUS, &ok);
    if (!ok) {
      char message[4096] = {};
      glGetProgramInfoLog(id, sizeof message, nullptr, message);
      error = fail(Code::Gpu, "program {} does not link: {}", entries.front(), message);
    }
  }
  for (const GLuint s : shaders) {
    glDetachShader(id, s);
    glDeleteShader(s);
  }
  if (error) {
    glDeleteProgram(id);
    return *error;
  }
  if (const char* folder = std::getenv("PILEUS_SHADER_SOURCES"); folder && *folder)
    if (const auto written = write(folder, entries, sources); !written)
      log::warn("{}", written.error().message);
  glObjectLabel(GL_PROGRAM, id, static_cast<GLsizei>(entries.front().size()), entries.front().data());
  return &programs_.emplace(std::move(key), Program(id)).first->second;
}

Result<void> ShaderLibrary::writeSources(const std::filesystem::path& folder,
                                         const std::vector<std::string>& entries, const Defines& defines) {
  std::vector<ShaderSource> sources;
  for (const std::string& e : entries) {
    PILEUS_TRY(ShaderSource s, source(e, defines));
    sources.push_back(std::move(s));
  }
  return write(folder, entries, sources);
}

std::vector<std::string> ShaderLibrary::entries() {
  std::vector<std::string> out;
  for (const EmbeddedFile& f : embedded_shaders())
    if (f.path.find(".comp.") != f.path.npos || f.path.find(".frag.") != f.path.npos ||
        f.path.find(".vert.") != f.path.npos)
      out.emplace_back(f.path);
  return out;
}

}  // namespace pileus::gl
