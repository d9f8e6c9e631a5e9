#pragma once
// The device that a scene names, opened.
#include "render/make_renderer.h"
#if __has_include("render/devices.h")
#include "render/devices.h"
#endif

namespace havs {

#if __has_include("render/devices.h")
using OpenDevice = RenderDevice;
inline OpenDevice openDevice(const Scene& scene) { return openRenderDevice(scene.device, scene.threads); }
#else
struct OpenDevice {
  std::unique_ptr<Device> context;
  std::string renderer;
  Capabilities capabilities;
};
inline OpenDevice openDevice(const Scene& scene) {
  auto context = makeDevice(scene.device, scene.threads);
  std::string renderer = context->renderer();
  Capabilities capabilities = capabilitiesOf(*context);
  return {std::move(context), std::move(renderer), std::move(capabilities)};
}
#endif

}  // namespace havs
