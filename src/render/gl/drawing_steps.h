#pragma once
// Steps that drawing has in common, whatever the visibility method.
#include "gl/framebuffer.h"
#include "gl/program.h"
#include "gl/program_cache.h"
#include "image/image.h"
#include "render/gl/tile.h"
#include "render/plan.h"

namespace havs {

/// What the plan's programs are compiled with: its defines, its lookup, the extension that orders pixels where it has
/// one.
ShaderOptions shaderOptions(const RenderPlan& plan);

/// The plan's program of that role.
const Program& programOf(ProgramCache& programs, const RenderPlan& plan, const std::string& role);

/// A transparent picture of the view's size.
Image emptyPicture(const View& view);

/// Uses `program` and sets what the vertex shaders and pixels need of the view. The viewport must be the
/// tile's.
void useForView(const Program& program, const View& view, const Tile& tile);

/// Reads the lower left part of target 0, of the tile's size, into the picture, whose rows go from the top down.
void readTile(const Framebuffer& framebuffer, const Tile& tile, Image& image);

}  // namespace havs
