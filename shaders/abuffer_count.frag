// The a-buffer, first pass: how many fragments each pixel has, by adding 1 for each. Blended, so that no driver takes
// the triangles for opaque and drops what they hide (docs/llvmpipe.md). A float counts exactly up to 2^24.
layout(location = 0) out float count;

void main() { count = 1.0; }
