#pragma once
// Colour management: one OpenColorIO config (settings.ocio, else $OCIO, else the shipped one) and its display
// transforms. Any thread, but a DisplayTransform's GPU text is compiled by renderer/view/display on the GL
// thread.
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "renderer/base/hash.h"
#include "renderer/image/image.h"

namespace pileus::image {

/// A texture the GPU form of a transform samples. RGB32F, or R32F where channels is 1.
struct LutTexture {
  std::string sampler;  ///< uniform name in the shader text
  int dimensions = 1;   ///< 1 or 2 (1-D LUTs, as OCIO lays them out), 3
  ivec3 size{1};
  int channels = 3;
  bool linear = true;  ///< filter
  std::vector<float> texels;
};

/// `vec4 ocioDisplay(vec4 rgba)` as GLSL 4.0 text (no #version) and its textures.
struct GpuTransform {
  std::string glsl;
  std::vector<LutTexture> textures;
  Key key;  ///< of text and texels
};

class ColorConfig {
 public:
  /// "" = $OCIO if set, else the shipped config; otherwise a path. Error (Input) says what is wrong with the
  /// config; a config of a newer profile than the library says so.
  static Result<std::shared_ptr<const ColorConfig>> load(const std::string& path);
  /// The one that is part of the program, whatever $OCIO says.
  static Result<std::shared_ptr<const ColorConfig>> shipped();
  ~ColorConfig();

  std::string description() const;  ///< name or path, for the interface
  /// Of what it says and of the files it names: equal for the same config read twice.
  const Key& key() const;
  std::vector<std::string> displays() const;
  std::vector<std::string> views(const std::string& display) const;
  std::string defaultDisplay() const;
  std::string defaultView(const std::string& display) const;
  /// Looks by name, as the config lists them; often none.
  std::vector<std::string> looks() const;
  /// The space of this config that ACEScg pixels are handed to: ACEScg itself; ACES2065-1 through the role
  /// aces_interchange, after a built-in conversion; or, as description() then says, scene_linear taken as it
  /// is.
  std::string workingSpace() const;

  /// "" for display or view chooses the default; for the look those that the view itself asks for. Error
  /// (Arguments) lists what exists.
  Result<GpuTransform> gpuTransform(const std::string& display, const std::string& view,
                                    const std::string& look = {}) const;
  /// In place, RGBA interleaved float pixels (alpha untouched): the CPU twin of gpuTransform.
  Result<void> applyCpu(const std::string& display, const std::string& view, float* rgba, std::size_t pixels,
                        const std::string& look = {}) const;

  /// Names of the config's spaces that pixels of a file may be in.
  std::vector<std::string> colorSpaces() const;
  /// In place, RGB interleaved float pixels from one of them to linear ACEScg. "" is linear Rec. 709, by a
  /// matrix of the library's own, whatever the config. Error (Arguments) lists the spaces.
  Result<void> toWorkingSpace(const std::string& colorspace, float* rgb, std::size_t pixels) const;

 private:
  struct Impl;
  explicit ColorConfig(std::unique_ptr<Impl> impl);
  static Result<std::shared_ptr<const ColorConfig>> read(const std::string& file, std::string name);
  std::unique_ptr<Impl> impl_;
};

}  // namespace pileus::image
