#pragma once
// The reference compiler of GLSL (glslangValidator, of Khronos) over what tests and program give to a driver:
// drivers take more or less than the standard says, it takes just that.
#include <filesystem>
#include <string>
#include <vector>

namespace pileus::test {

/// Whether it is installed (Debian package glslang-tools).
bool hasReferenceCompiler();

/// What it says against the programs in a folder (see gl::ShaderLibrary: NAME.comp, or NAME.vert and
/// NAME.frag), with files and lines; empty where it takes them all. Programs that it took before, in this
/// process or another, are passed over. The folder is empty afterwards.
std::string refusedPrograms(const std::filesystem::path& folder);

/// The folder into which this process, and those it starts, write the programs they compile. A test that ends
/// with one the reference compiler refuses has failed.
std::filesystem::path compiledPrograms();

}  // namespace pileus::test
