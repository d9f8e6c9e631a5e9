// Cells on OpenGL: every face in order through cells.vert and cells.frag, blended front to back; then, where the order
// is asked about, once more through cells_certificate.frag.
#include <algorithm>
#include <array>
#include <cmath>

#include "gl/check.h"
#include "gl/framebuffer.h"
#include "gl/program_cache.h"
#include "render/gl/cell_buffers.h"
#include "render/gl/drawing_steps.h"
#include "render/gl/lookup_textures.h"
#include "render/gl/renderers.h"
#include "render/gl/stage_sum.h"
#include "render/make_renderer.h"
#include "render/scene_sorter.h"

namespace havs {
namespace {

constexpr std::array kZero{0.0f, 0.0f, 0.0f, 0.0f};
constexpr std::array kNothingSeen{-3.0e38f, 0.0f, 0.0f, 0.0f};  // as cells_certificate.frag starts

class CellsRenderer final : public Renderer {
 public:
  CellsRenderer(const PreparedScene& prepared, const RenderPlan& plan, StageTimes& stages, const Progress& progress)
      : plan_(plan),
        sorter_(makeSceneSorter(prepared, plan.sort, PartOrder::asInWhole)),
        color_(programOf(programs_, plan, "colour")) {
    if (plan.certificate) certify_ = &programOf(programs_, plan, "certificate");
    {
      const ScopedStage timer(stages, "table");
      textures_.emplace(prepared, plan, progress);
    }
    const ScopedStage timer(stages, "upload_mesh");
    cells_.emplace(prepared);
    glFinish();
  }

  Drawing draw(const View& view, StageTimes& stages, const Progress&) override {
    makeTargets(std::min(plan_.tileWidth, view.width), std::min(plan_.tileHeight, view.height));
    {
      const ScopedStage timer(stages, "order");
      sorter_->sort(viewPointOf(view), order_);
    }
    {
      const ScopedStage timer(stages, "upload");
      cells_->setOrder(order_);
      glFinish();
    }
    Drawing drawing;
    drawing.image = emptyPicture(view);
    drawing.cycles = order_.cycles;
    const std::vector<Tile> tiles = tilesOf(view, plan_);
    drawing.tiles = tiles.size();
    {
      StageSum drawTime(stages, "draw"), readTime(stages, "readback");
      for (const Tile& tile : tiles) {
        drawTime.time([&] { drawTile(view, tile); });
        readTime.time([&] { readTile(*framebuffer_, tile, drawing.image); });
      }
    }
    if (plan_.certificate) {
      const ScopedStage timer(stages, "certificate");
      drawing.certificate = certify(view, tiles);
    }
    return drawing;
  }

 private:
  void makeTargets(int width, int height) {
    if (target_ && target_->width() == width && target_->height() == height) return;
    framebuffer_.reset();
    seenFramebuffer_.reset();
    target_ = Texture::image2D("colour", GL_RGBA32F, width, height);
    framebuffer_.emplace("colour", Framebuffer::Targets{*target_});
    if (!plan_.certificate) return;
    seen_ = Texture::image2D("order seen", GL_RGBA32F, width, height);
    seenFramebuffer_.emplace("order seen", Framebuffer::Targets{*seen_});
  }

  void begin(const Framebuffer& framebuffer, const std::array<float, 4>& value, const Program& program,
             const View& view, const Tile& tile) const {
    framebuffer.bind();
    glViewport(0, 0, tile.width, tile.height);
    for (const GLenum capability : {GL_DEPTH_TEST, GL_CULL_FACE, GL_BLEND}) glDisable(capability);
    framebuffer.clear(0, value);
    useForView(program, view, tile);
    program.set("toView", glm::mat3(glm::dmat3(view.right, view.up, view.forward)));
    program.set("pixelToBase", glm::vec4(pixelToBase(view, tile)));
    GLint subPixelBits = 0;
    glGetIntegerv(GL_SUBPIXEL_BITS, &subPixelBits);
    program.set("grid", std::ldexp(1.0f, subPixelBits));
    program.set("viewport", glm::vec2(tile.width, tile.height));
    cells_->bind(program);
  }

  void drawTile(const View& view, const Tile& tile) const {
    begin(*framebuffer_, kZero, color_, view, tile);
    textures_->bind(color_);
    glEnable(GL_BLEND);
    glBlendFunc(GL_ONE_MINUS_DST_ALPHA, GL_ONE);
    cells_->draw();
    glDisable(GL_BLEND);
    glFinish();
    checkGl("drawing");
  }

  Certificate certify(const View& view, const std::vector<Tile>& tiles) const {
    Image seen = emptyPicture(view);
    for (const Tile& tile : tiles) {
      begin(*seenFramebuffer_, kNothingSeen, *certify_, view, tile);
      cells_->draw();
      glFinish();
      checkGl("looking at the order of cells");
      readTile(*seenFramebuffer_, tile, seen);
    }
    Certificate certificate;
    for (std::size_t i = 0; i < seen.rgba.size(); i += 4) {
      const auto misordered = static_cast<std::uint32_t>(seen.rgba[i + 1]);
      certificate.count.push_back(misordered);
      certificate.misordered += misordered;
      certificate.pixels += misordered > 0;
      certificate.fragments += static_cast<std::size_t>(seen.rgba[i + 2]);
    }
    return certificate;
  }

  RenderPlan plan_;
  std::unique_ptr<FaceSorter> sorter_;
  FaceOrder order_;
  ProgramCache programs_;
  const Program& color_;
  const Program* certify_ = nullptr;  ///< only where the plan asks for a certificate
  std::optional<LookupTextures> textures_;
  std::optional<CellBuffers> cells_;
  std::optional<Texture> target_, seen_;
  std::optional<Framebuffer> framebuffer_, seenFramebuffer_;
};

}  // namespace

std::unique_ptr<Renderer> makeCellsRenderer(const PreparedScene& prepared, const RenderPlan& plan, StageTimes& stages,
                                            const Progress& progress) {
  return std::make_unique<CellsRenderer>(prepared, plan, stages, progress);
}

}  // namespace havs
