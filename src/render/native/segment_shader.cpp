#include "render/native/segment_shader.h"

#include "core/error.h"

namespace havs {

struct SegmentShader::Data {};

SegmentShader::SegmentShader(const PreparedScene&, const RenderPlan&, const InstructionSet&, const Progress&) {
  failRunning("no lookups yet");
}
SegmentShader::~SegmentShader() = default;

void SegmentShader::shade(SegmentQueue&) const {}

}  // namespace havs
