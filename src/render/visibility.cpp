#include "render/visibility.h"

#include "core/find_row.h"
#include "render/gl/renderers.h"
#include "render/native/renderers.h"

namespace havs {

std::span<const VisibilityMethod> visibilityMethods() {
  static const std::vector<VisibilityMethod> rows{
      {.name = "kbuffer",
       .description = "k nearest fragments of a pixel in render targets (Callahan et al. 2005)",
       .extensions = {"GL_EXT_shader_framebuffer_fetch"},
       .needsOrder = true,
       .maximumK = 14,
       .dropsLateFragments = true,
       .carriesColors = true,
       .carriesLight = true,
       .takesLayers = true,
       .gl = {planKBuffer, makeKBufferRenderer},
       .native = {planNativeKBuffer, makeNativeRenderer}},
      {.name = "abuffer",
       .description = "all fragments of a pixel in memory, sorted; exact for any order of the faces (Carpenter 1984)",
       .needsOrder = false,
       .takesLayers = true,
       .gl = {planABuffer, makeABufferRenderer}},
      {.name = "cells",
       .description = "each cell's segment blended as its faces come; as exact as their order (cycles, --sort)",
       .needsOrder = true,
       .endsPixelsEarly = false,
       .gl = {planCells, makeCellsRenderer}},
  };
  return rows;
}

const VisibilityMethod& visibilityMethod(const std::string& name) {
  return findRow(visibilityMethods(), name, "visibility method");
}

}  // namespace havs
