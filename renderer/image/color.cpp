#include "renderer/image/color.h"

#include <fmt/ranges.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <map>
#include <mutex>
#include <sstream>

#include "embedded_color.h"
#include "renderer/base/file.h"
#include "renderer/base/log.h"
#include "renderer/image/color_source.h"
#include "renderer/image/reason.h"

namespace OCIO = OCIO_NAMESPACE;

namespace pileus::image {
namespace {

// Everything OpenColorIO does without loss, so that the CPU and the GPU form agree; LUTs are inverted the
// same way in both.
constexpr auto kOptimization = static_cast<OCIO::OptimizationFlags>(
    OCIO::OPTIMIZATION_LOSSLESS | OCIO::OPTIMIZATION_LUT_INV_FAST | OCIO::OPTIMIZATION_NO_DYNAMIC_PROPERTIES);

struct Display {
  std::string name;
  std::string defaultView;
  std::vector<std::string> views;
};

void forwardLibraryLog() {
  static std::once_flag once;
  std::call_once(once, [] {
    OCIO::SetLoggingFunction(
        [](const char* message) { log::info("{}", clampReason(message ? message : "")); });
  });
}

std::string quotedList(const std::vector<std::string>& names) {
  return names.empty() ? std::string("(none)") : fmt::format("'{}'", fmt::join(names, "', '"));
}

void addTextures(const OCIO::GpuShaderDesc& shader, std::vector<LutTexture>& out) {
  const char *name = nullptr, *sampler = nullptr;
  const float* values = nullptr;
  OCIO::Interpolation interpolation{};
  for (unsigned i = 0; i < shader.getNum3DTextures(); ++i) {
    unsigned edge = 0;
    shader.get3DTexture(i, name, sampler, edge, interpolation);
    shader.get3DTextureValues(i, values);
    const std::size_t count = std::size_t(3) * edge * edge * edge;
    out.push_back({sampler,
                   3,
                   ivec3(static_cast<int>(edge)),
                   3,
                   interpolation != OCIO::INTERP_NEAREST,
                   {values, values + count}});
  }
  for (unsigned i = 0; i < shader.getNumTextures(); ++i) {
    unsigned width = 0, height = 0;
    OCIO::GpuShaderDesc::TextureType type{};
    shader.getTexture(i, name, sampler, width, height, type, interpolation);
    shader.getTextureValues(i, values);
    const int channels = type == OCIO::GpuShaderDesc::TEXTURE_RED_CHANNEL ? 1 : 3;
    const std::size_t count = static_cast<std::size_t>(channels) * width * height;
    // A LUT longer than a texture row is folded into rows; OpenColorIO declares a sampler2D for those only.
    out.push_back({sampler,
                   height > 1 ? 2 : 1,
                   ivec3(static_cast<int>(width), static_cast<int>(height), 1),
                   channels,
                   interpolation != OCIO::INTERP_NEAREST,
                   {values, values + count}});
  }
}

}  // namespace

struct ColorConfig::Impl {
  OCIO::ConstConfigRcPtr config;
  std::string description;
  Key key;
  ColorSource source;
  std::vector<Display> displays;
  std::vector<std::string> looks;

  mutable std::mutex mutex;  // guards the two caches
  struct Choice {
    std::string display, view, look;
    auto operator<=>(const Choice&) const = default;
  };
  mutable std::map<Choice, OCIO::ConstProcessorRcPtr> processors;
  mutable std::map<Choice, GpuTransform> gpuTransforms;

  const Display* display(const std::string& name) const {
    const auto it =
        std::find_if(displays.begin(), displays.end(), [&](const Display& d) { return d.name == name; });
    return it == displays.end() ? nullptr : &*it;
  }

  Result<Choice> choose(const std::string& displayName, const std::string& viewName,
                        const std::string& look) const {
    const Display* d = displayName.empty() ? &displays.front() : display(displayName);
    if (!d) {
      std::vector<std::string> names;
      for (const Display& each : displays) names.push_back(each.name);
      return fail(Code::Arguments, "there is no display '{}'; the colour config has {}", displayName,
                  quotedList(names));
    }
    if (!look.empty() && std::find(looks.begin(), looks.end(), look) == looks.end())
      return fail(Code::Arguments, "there is no look '{}'; the colour config has {}", look,
                  quotedList(looks));
    if (viewName.empty()) return Choice{d->name, d->defaultView, look};
    if (std::find(d->views.begin(), d->views.end(), viewName) == d->views.end())
      return fail(Code::Arguments, "there is no view '{}' for display '{}'; the colour config has {}",
                  viewName, d->name, quotedList(d->views));
    return Choice{d->name, viewName, look};
  }

  Error failed(const Choice& choice, const std::exception& e) const {
    return fail(Code::Input, "{}: view '{}' of display '{}' cannot be made: {}", description, choice.view,
                choice.display, clampReason(e.what()));
  }

  /// May throw OCIO::Exception. The mutex is held.
  OCIO::ConstProcessorRcPtr processor(const Choice& choice) const {
    if (auto it = processors.find(choice); it != processors.end()) return it->second;
    auto toView = OCIO::DisplayViewTransform::Create();
    toView->setSrc(source.space.c_str());
    toView->setDisplay(choice.display.c_str());
    toView->setView(choice.view.c_str());
    auto group = OCIO::GroupTransform::Create();
    if (source.fromAces2065) {
      auto toAces = OCIO::BuiltinTransform::Create();
      toAces->setStyle("ACEScg_to_ACES2065-1");
      group->appendTransform(toAces);
    }
    if (!choice.look.empty()) {
      // Instead of those the view asks for, as compositors do.
      auto look = OCIO::LookTransform::Create();
      look->setSrc(source.space.c_str());
      look->setDst(source.space.c_str());
      look->setLooks(choice.look.c_str());
      group->appendTransform(look);
      toView->setLooksBypass(true);
    }
    group->appendTransform(toView);
    return processors[choice] = config->getProcessor(group);
  }
};

ColorConfig::ColorConfig(std::unique_ptr<Impl> impl) : impl_(std::move(impl)) {}
ColorConfig::~ColorConfig() = default;

Result<std::shared_ptr<const ColorConfig>> ColorConfig::shipped() { return read("", ""); }

Result<std::shared_ptr<const ColorConfig>> ColorConfig::load(const std::string& path) {
  std::string file = path, name = path;
  if (const char* variable = std::getenv("OCIO"); file.empty() && variable && *variable) {
    file = variable;
    name = file + " ($OCIO)";
  }
  return read(file, std::move(name));
}

/// `file` "": the shipped config.
Result<std::shared_ptr<const ColorConfig>> ColorConfig::read(const std::string& file, std::string name) {
  forwardLibraryLog();
  if (file.rfind("ocio://", 0) == 0)
    return fail(Code::Input,
                "{}: configs inside the library need OpenColorIO 2.2, this build has {}; give a file, or "
                "nothing for the shipped config",
                name, OCIO::GetVersion());
  auto impl = std::make_unique<Impl>();
  try {
    if (file.empty()) {
      name = "Pileus (ACEScg)";
      const auto files = embedded_color();
      const auto shipped = std::find_if(files.begin(), files.end(),
                                        [](const EmbeddedFile& f) { return f.path == "pileus.ocio"; });
      if (shipped == files.end())
        return fail(Code::Internal, "the shipped colour config is not part of this build");
      std::istringstream stream{std::string(shipped->bytes)};
      impl->config = OCIO::Config::CreateFromStream(stream);
    } else {
      const auto text = readFile(file, std::size_t(64) << 20);
      if (!text)
        return fail(Code::Input, "{}{}", text.error().message, name == file ? "" : "; it is named by $OCIO");
      PILEUS_CHECK(checkProfile(name, *text));
      impl->config = OCIO::Config::CreateFromFile(file.c_str());
    }
    const OCIO::Config& config = *impl->config;
    impl->key = Hasher().add(std::string_view(config.getCacheID())).add(std::string_view(name)).key();
    impl->source = chooseColorSource(config);
    impl->description = impl->source.note.empty() ? name : name + ": " + impl->source.note;
    for (int i = 0; i < config.getNumLooks(); ++i) impl->looks.emplace_back(config.getLookNameByIndex(i));
    const std::string first = config.getDefaultDisplay();
    for (int d = 0; d < config.getNumDisplays(); ++d) {
      Display display{config.getDisplay(d), config.getDefaultView(config.getDisplay(d)), {}};
      for (int v = 0; v < config.getNumViews(display.name.c_str()); ++v)
        display.views.emplace_back(config.getView(display.name.c_str(), v));
      if (display.views.empty()) continue;
      const bool isFirst = display.name == first;
      impl->displays.insert(isFirst ? impl->displays.begin() : impl->displays.end(), std::move(display));
    }
  } catch (const std::exception& e) {
    return fail(Code::Input, "{}: not a usable colour config: {}", name, clampReason(e.what()));
  }
  if (impl->displays.empty())
    return fail(Code::Input, "{}: the colour config has no display with a view", name);
  if (impl->source.space.empty())
    return fail(Code::Input, "{}: the colour config has no colour spaces", name);
  try {
    impl->config->validate();
  } catch (const std::exception& e) {
    // Studios live with configs that are not whole; a view that is broken says so when it is chosen.
    log::info("{}: the colour config is used although it does not validate: {}", name, clampReason(e.what()));
  }
  return std::shared_ptr<const ColorConfig>(new ColorConfig(std::move(impl)));
}

std::string ColorConfig::description() const { return impl_->description; }
const Key& ColorConfig::key() const { return impl_->key; }

std::vector<std::string> ColorConfig::displays() const {
  std::vector<std::string> names;
  for (const Display& d : impl_->displays) names.push_back(d.name);
  return names;
}

std::vector<std::string> ColorConfig::views(const std::string& display) const {
  const Display* d = display.empty() ? &impl_->displays.front() : impl_->display(display);
  return d ? d->views : std::vector<std::string>{};
}

std::string ColorConfig::defaultDisplay() const { return impl_->displays.front().name; }

std::string ColorConfig::defaultView(const std::string& display) const {
  const Display* d = display.empty() ? &impl_->displays.front() : impl_->display(display);
  return d ? d->defaultView : std::string{};
}

std::vector<std::string> ColorConfig::looks() const { return impl_->looks; }

std::string ColorConfig::workingSpace() const { return impl_->source.space; }

Result<GpuTransform> ColorConfig::gpuTransform(const std::string& display, const std::string& view,
                                               const std::string& look) const {
  PILEUS_TRY(const auto choice, impl_->choose(display, view, look));
  const std::lock_guard lock(impl_->mutex);
  if (auto it = impl_->gpuTransforms.find(choice); it != impl_->gpuTransforms.end()) return it->second;
  try {
    auto shader = OCIO::GpuShaderDesc::CreateShaderDesc();
    shader->setLanguage(OCIO::GPU_LANGUAGE_GLSL_4_0);
    shader->setFunctionName("ocioDisplay");
    shader->setResourcePrefix("ocio_");
    impl_->processor(choice)->getOptimizedGPUProcessor(kOptimization)->extractGpuShaderInfo(shader);
    if (shader->getNumUniforms() != 0)
      return fail(Code::Input,
                  "{}: view '{}' of display '{}' has {} live parameters, which Pileus does not drive",
                  impl_->description, choice.view, choice.display, shader->getNumUniforms());
    GpuTransform out;
    out.glsl = shader->getShaderText();
    addTextures(*shader, out.textures);
    Hasher hash;
    hash.add(out.glsl);
    for (const LutTexture& t : out.textures) {
      hash.add(t.sampler)
          .add(t.dimensions)
          .add(t.size.x)
          .add(t.size.y)
          .add(t.size.z)
          .add(t.channels)
          .add(t.linear);
      hash.bytes(t.texels.data(), t.texels.size() * sizeof(float));
    }
    out.key = hash.key();
    return impl_->gpuTransforms[choice] = std::move(out);
  } catch (const std::exception& e) {
    return impl_->failed(choice, e);
  }
}

Result<void> ColorConfig::applyCpu(const std::string& display, const std::string& view, float* rgba,
                                   std::size_t pixels, const std::string& look) const {
  PILEUS_TRY(const auto choice, impl_->choose(display, view, look));
  try {
    OCIO::ConstCPUProcessorRcPtr cpu;
    {
      const std::lock_guard lock(impl_->mutex);
      cpu = impl_->processor(choice)->getOptimizedCPUProcessor(OCIO::BIT_DEPTH_F32, OCIO::BIT_DEPTH_F32,
                                                               kOptimization);
    }
    constexpr std::size_t kBlock = 4096;
    tbb::parallel_for(std::size_t(0), (pixels + kBlock - 1) / kBlock, [&](std::size_t block) {
      float* first = rgba + block * kBlock * 4;
      const std::size_t count = std::min(kBlock, pixels - block * kBlock);
      std::array<float, kBlock> alpha;
      for (std::size_t i = 0; i < count; ++i) alpha[i] = first[i * 4 + 3];
      OCIO::PackedImageDesc desc(first, static_cast<long>(count), 1, 4);
      cpu->apply(desc);
      for (std::size_t i = 0; i < count; ++i) first[i * 4 + 3] = alpha[i];
    });
  } catch (const std::exception& e) {
    return impl_->failed(choice, e);
  }
  return {};
}

std::vector<std::string> ColorConfig::colorSpaces() const {
  std::vector<std::string> out;
  const int count =
      impl_->config->getNumColorSpaces(OCIO::SEARCH_REFERENCE_SPACE_SCENE, OCIO::COLORSPACE_ALL);
  for (int i = 0; i < count; ++i)
    out.emplace_back(
        impl_->config->getColorSpaceNameByIndex(OCIO::SEARCH_REFERENCE_SPACE_SCENE, OCIO::COLORSPACE_ALL, i));
  return out;
}

Result<void> ColorConfig::toWorkingSpace(const std::string& colorspace, float* rgb,
                                         std::size_t pixels) const {
  const auto builtin = [](const char* style, OCIO::TransformDirection direction) {
    auto out = OCIO::BuiltinTransform::Create();
    out->setStyle(style);
    out->setDirection(direction);
    return out;
  };
  try {
    auto group = OCIO::GroupTransform::Create();
    if (colorspace.empty()) {
      group->appendTransform(builtin("UTILITY - ACES-AP1_to_LINEAR-REC709_BFD", OCIO::TRANSFORM_DIR_INVERSE));
    } else {
      if (!impl_->config->getColorSpace(colorspace.c_str()))
        return fail(Code::Arguments, "colorspace: there is no colour space '{}'; the colour config has {}",
                    colorspace, quotedList(colorSpaces()));
      auto toWorking = OCIO::ColorSpaceTransform::Create();
      toWorking->setSrc(colorspace.c_str());
      toWorking->setDst(impl_->source.space.c_str());
      group->appendTransform(toWorking);
      if (impl_->source.fromAces2065)
        group->appendTransform(builtin("ACEScg_to_ACES2065-1", OCIO::TRANSFORM_DIR_INVERSE));
    }
    const auto cpu = impl_->config->getProcessor(group)->getOptimizedCPUProcessor(
        OCIO::BIT_DEPTH_F32, OCIO::BIT_DEPTH_F32, kOptimization);
    constexpr std::size_t kBlock = 4096;
    tbb::parallel_for(std::size_t(0), (pixels + kBlock - 1) / kBlock, [&](std::size_t block) {
      const std::size_t first = block * kBlock;
      OCIO::PackedImageDesc desc(rgb + first * 3, static_cast<long>(std::min(kBlock, pixels - first)), 1, 3);
      cpu->apply(desc);
    });
  } catch (const std::exception& e) {
    return fail(Code::Input, "colorspace: {}: '{}' cannot be converted: {}", impl_->description, colorspace,
                clampReason(e.what()));
  }
  return {};
}

}  // namespace pileus::image
