#include "render/native/segment_shader.h"

#include "core/error.h"
#include "transfer/packed_curve.h"

namespace havs {

struct SegmentShader::Data { PackedCurve<float> curve; };

SegmentShader::SegmentShader(const PreparedScene& p, const RenderPlan&, const InstructionSet&, const Progress&):data_(std::make_unique<Data>()) {
  data_->curve = packCurve<float>(p.curve);
}
SegmentShader::~SegmentShader() = default;

void SegmentShader::shade(SegmentQueue& q) const {
  using A = Arithmetic<FloatLane>;
  CurveFetch<FloatLane> fetch(data_->curve);
  static const bool dummy = getenv("HAVS_DUMMY");
  for (size_t i = 0; i < q.count; ++i) {
    if (dummy) { for (int j=0;j<4;++j) q.rgba[4*i+j]=q.length[i]; continue; }
    auto c = A::exactSegment(fetch, q.scalarFront[i], q.scalarBack[i], q.length[i]);
    q.rgba[4*i]=c.r; q.rgba[4*i+1]=c.g; q.rgba[4*i+2]=c.b; q.rgba[4*i+3]=c.a;
  }
}

}  // namespace havs
