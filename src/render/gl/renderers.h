#pragma once
// What the rows of visibilityMethods() point to: a plan and a maker each, as VisibilityMethod says.
#include <memory>

#include "gl/shader_source.h"
#include "render/plan.h"
#include "scene/prepared_scene.h"
#include "scene/renderer.h"

namespace havs {

/// What the k-buffer's programs are compiled with.
ShaderOptions kbufferShaderOptions(const RenderPlan& plan);
void planKBuffer(RenderPlan& plan, const Scene& scene, const Capabilities& capabilities);
std::unique_ptr<Renderer> makeKBufferRenderer(const PreparedScene& prepared, const RenderPlan& plan, StageTimes& stages,
                                              const Progress& progress);

inline constexpr std::size_t kBytesPerFragment = 8;  ///< of the a-buffer's lists
void planABuffer(RenderPlan& plan, const Scene& scene, const Capabilities& capabilities);
std::unique_ptr<Renderer> makeABufferRenderer(const PreparedScene& prepared, const RenderPlan& plan, StageTimes& stages,
                                              const Progress& progress);

inline constexpr const char* kFramebufferFetch = "GL_EXT_shader_framebuffer_fetch";
void planCells(RenderPlan& plan, const Scene& scene, const Capabilities& capabilities);
std::unique_ptr<Renderer> makeCellsRenderer(const PreparedScene& prepared, const RenderPlan& plan, StageTimes& stages,
                                            const Progress& progress);

}  // namespace havs
