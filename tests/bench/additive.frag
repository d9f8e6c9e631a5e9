// The least that a picture of all faces can cost: one target, plain additive blending, no k-buffer.
smooth in float scalar;
smooth in float depth;
flat in float onBoundary;
layout(location = 0) out vec4 sum;

void main() { sum = vec4(scalar, depth, onBoundary, 1.0); }
