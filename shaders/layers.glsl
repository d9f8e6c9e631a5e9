// Layers of a pixel's ray (boundary surface, wire frame) between its segments: a list of each pixel, near first, in
// memory. As the fragments of a pixel leave in order, the way from one to the next, its farther end excluded, holds the
// layers that come now: so no state is kept of which have been, and each is composited once. Those nearer than the
// segment's middle come before it, the others behind.
#ifdef HAVS_LAYERS
layout(std430, binding = 4) readonly buffer LayerBegins { uint layerBegins[]; };  // of each pixel, row 0 on top
layout(std430, binding = 5) readonly buffer LayerDistances { float layerDistances[]; };
layout(std430, binding = 6) readonly buffer LayerColors { vec4 layerColors[]; };  // premultiplied
uniform ivec2 layerCorner;                                                        // the tile's lower left pixel
uniform int layerRowLength;

Rgba compositeSegment(Rgba color, Rgba ofSegment, float middle, float from, float to) {
  int pixel = (layerCorner.y - int(gl_FragCoord.y)) * layerRowLength + layerCorner.x + int(gl_FragCoord.x);
  uint end = layerBegins[pixel + 1];
  Rgba behind = Rgba(0.0);
  for (uint i = layerBegins[pixel]; i < end; ++i) {
    float distance = layerDistances[i];
    if (distance >= to) break;
    if (distance < from) continue;
    if (distance < middle) color = compositeUnder(color, layerColors[i]);
    else behind = compositeUnder(behind, layerColors[i]);
  }
  return compositeUnder(compositeUnder(color, ofSegment), behind);
}
#else
Rgba compositeSegment(Rgba color, Rgba ofSegment, float middle, float from, float to) {
  return compositeUnder(color, ofSegment);
}
#endif

const float kBehindAll = 3.0e38;
Rgba compositeRest(Rgba color, float from) {
  return compositeSegment(color, Rgba(0.0), kBehindAll, from, kBehindAll);
}
