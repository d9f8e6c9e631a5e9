#include "render/devices.h"

#include <vector>

#include "core/find_row.h"
#include "render/make_renderer.h"
#include "render/native/instruction_sets.h"

namespace havs {
namespace {

RenderDevice openContext(const RenderDeviceRow& row, std::size_t threads) {
  RenderDevice device;
  device.name = row.name;
  device.context = makeDevice(row.name, threads);
  device.renderer = device.context->renderer();
  device.version = device.context->version();
  device.capabilities = capabilitiesOf(*device.context);
  return device;
}

RenderDevice openNative(const RenderDeviceRow& row, std::size_t) {
  RenderDevice device;
  device.name = row.name;
  device.renderer = describe(widestInstructionSet());
  device.capabilities.native = true;
  device.capabilities.hasExtension = [](const std::string&) { return false; };
  return device;
}

}  // namespace

std::span<const RenderDeviceRow> renderDevices() {
  static const std::vector<RenderDeviceRow> rows = [] {
    std::vector<RenderDeviceRow> all;
    for (const DeviceRow& row : deviceRows()) all.push_back({row.name, row.description, openContext});
    all.push_back({kNativeDevice, "SIMD lanes on all cores, without OpenGL", openNative});
    return all;
  }();
  return rows;
}

RenderDevice openRenderDevice(const std::string& name, std::size_t threads) {
  const RenderDeviceRow& row = findRow(renderDevices(), name, "device", "--device");
  return row.open(row, threads);
}

}  // namespace havs
