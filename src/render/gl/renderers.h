#pragma once
// What the rows of visibilityMethods() point to: a plan and a maker each, as VisibilityMethod says.
#include <memory>

#include "gl/shader_source.h"
#include "render/plan.h"
#include "scene/prepared_scene.h"
#include "scene/renderer.h"

namespace havs {

/// The items of MeshBuffers, of CellBuffers.
void planFaceBuffers(RenderPlan& plan, const SceneFacts& facts);
void planCellBuffers(RenderPlan& plan, const SceneFacts& facts);

void planKBuffer(RenderPlan& plan, const Scene& scene, const SceneFacts& facts, const Capabilities& capabilities);
std::unique_ptr<Renderer> makeKBufferRenderer(const PreparedScene& prepared, const RenderPlan& plan, StageTimes& stages,
                                              const Progress& progress);

inline constexpr std::size_t kBytesPerFragment = 8;  ///< of the a-buffer's lists
void planABuffer(RenderPlan& plan, const Scene& scene, const SceneFacts& facts, const Capabilities& capabilities);
std::unique_ptr<Renderer> makeABufferRenderer(const PreparedScene& prepared, const RenderPlan& plan, StageTimes& stages,
                                              const Progress& progress);

inline constexpr const char* kFramebufferFetch = "GL_EXT_shader_framebuffer_fetch";
void planCells(RenderPlan& plan, const Scene& scene, const SceneFacts& facts, const Capabilities& capabilities);
std::unique_ptr<Renderer> makeCellsRenderer(const PreparedScene& prepared, const RenderPlan& plan, StageTimes& stages,
                                            const Progress& progress);

/// Of modes() that need no order.
void planGathering(RenderPlan& plan, const Scene& scene, const SceneFacts& facts, const Capabilities& capabilities);
std::unique_ptr<Renderer> makeGatheringRenderer(const PreparedScene& prepared, const RenderPlan& plan,
                                                StageTimes& stages, const Progress& progress);

}  // namespace havs
