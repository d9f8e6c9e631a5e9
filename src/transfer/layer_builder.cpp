#include "transfer/layer_builder.h"

namespace havs {
namespace {

/// Two neighbouring stretches in both senses (compositeUnder of core/compositing.glsl).
inline __attribute__((always_inline)) void join(const Lanes& lowerStretch, const Lanes& upperStretch, Lanes& result) {
  LaneVector lower, upper;
  load(lowerStretch, lower);
  load(upperStretch, upper);
  const LaneVector front = __builtin_shufflevector(lower, upper, 0, 1, 2, 3, 12, 13, 14, 15);
  const LaneVector back = __builtin_shufflevector(upper, lower, 0, 1, 2, 3, 12, 13, 14, 15);
  const LaneVector through = 1.0 - __builtin_shufflevector(front, front, 3, 3, 3, 3, 7, 7, 7, 7);
  store(front + through * back, result);
}

HAVS_FOR_WIDEST_LANES void composeWindows(const Lanes* elements, int span, int begin, int end, Lanes* fromBlockStart,
                                          Lanes* toBlockEnd, Lanes* windows) {
  const int lastStep = end - 1 + span;
  for (int i = begin; i < lastStep; ++i) {
    if (i == begin || i % span == 0)
      fromBlockStart[i] = elements[i];
    else
      join(fromBlockStart[i - 1], elements[i], fromBlockStart[i]);
  }
  for (int i = lastStep - 1; i >= begin; --i) {
    if (i == lastStep - 1 || (i + 1) % span == 0)
      toBlockEnd[i] = elements[i];
    else
      join(elements[i], toBlockEnd[i + 1], toBlockEnd[i]);
  }
  for (int low = begin; low < end; ++low) {
    if (low % span == 0)
      windows[low] = fromBlockStart[low + span - 1];
    else
      join(toBlockEnd[low], fromBlockStart[low + span - 1], windows[low]);
  }
}

}  // namespace

LayerBuilder::LayerBuilder(const GridPieces& grid, bool withDepths)
    : grid_(grid),
      steps_(grid.lines() - 1),
      withDepths_(withDepths),
      elements_(static_cast<std::size_t>(steps_)),
      fromBlockStart_(elements_.size()),
      toBlockEnd_(elements_.size()),
      windows_(elements_.size()),
      depths_(withDepths ? elements_.size() : 0),
      depthFromBlockStart_(depths_.size()),
      depthToBlockEnd_(depths_.size()) {}

void LayerBuilder::compose(double lengthPerScalar, int span, int begin, int end) {
  grid_.steps(begin, end - 1 + span, lengthPerScalar, elements_.data());
  composeWindows(elements_.data(), span, begin, end, fromBlockStart_.data(), toBlockEnd_.data(), windows_.data());
  if (withDepths_) composeDepths(lengthPerScalar, span, begin, end);
}

void LayerBuilder::composeDepths(double lengthPerScalar, int span, int begin, int end) {
  const int lastStep = end - 1 + span;
  for (int i = begin; i < lastStep; ++i) {
    const double before = i == begin || i % span == 0 ? 0 : depthFromBlockStart_[i - 1];
    depthFromBlockStart_[i] = before + grid_.depthOf(i, lengthPerScalar);
  }
  for (int i = lastStep - 1; i >= begin; --i) {
    const double behind = i == lastStep - 1 || (i + 1) % span == 0 ? 0 : depthToBlockEnd_[i + 1];
    depthToBlockEnd_[i] = grid_.depthOf(i, lengthPerScalar) + behind;
  }
  for (int low = begin; low < end; ++low)
    depths_[low] = (low % span == 0 ? 0 : depthToBlockEnd_[low]) + depthFromBlockStart_[low + span - 1];
}

}  // namespace havs
