// Layers of a pixel's ray (boundary surface, wire frame) between its segments: a list of each pixel, near first, in
// memory. As the fragments of a pixel leave in order, the way from one to the next, its farther end excluded, holds the
// layers that come now: so no state is kept of which have been, and each is composited once. Those nearer than the
// segment's middle come before it, the others behind. The first way begins before everything, once a fragment has left:
// until then a nearer one may come.
#ifdef HAVS_LAYERS
layout(std430, binding = 4) readonly buffer LayerBegins { uint layerBegins[]; };  // of each pixel, row 0 on top
layout(std430, binding = 5) readonly buffer LayerDistances { float layerDistances[]; };
layout(std430, binding = 6) readonly buffer LayerColors { vec4 layerColors[]; };  // premultiplied
uniform ivec2 layerCorner;                                                        // the tile's lower left pixel
uniform int layerRowLength;

// Where the pixel's list begins and ends. To be called before any loop: of a value that is read from memory in a loop
// and wanted again behind it, llvmpipe loses what pixels had that left the loop before their neighbours.
uvec2 layersOfPixel() {
  int pixel = (layerCorner.y - int(gl_FragCoord.y)) * layerRowLength + layerCorner.x + int(gl_FragCoord.x);
  return uvec2(layerBegins[pixel], layerBegins[pixel + 1]);
}

Rgba compositeSegment(uvec2 layers, Rgba color, Rgba ofSegment, float middle, float from, float to) {
  Rgba behind = Rgba(0.0);
  for (uint i = layers.x; i < layers.y; ++i) {
    float distance = layerDistances[i];
    if (distance >= to) break;
    if (distance < from) continue;
    if (distance < middle) color = compositeUnder(color, layerColors[i]);
    else behind = compositeUnder(behind, layerColors[i]);
  }
  return compositeUnder(compositeUnder(color, ofSegment), behind);
}
#else
uvec2 layersOfPixel() { return uvec2(0u); }
Rgba compositeSegment(uvec2 layers, Rgba color, Rgba ofSegment, float middle, float from, float to) {
  return compositeUnder(color, ofSegment);
}
#endif

const float kBehindAll = 3.0e38;
Rgba compositeRest(uvec2 layers, Rgba color, float from) {
  return compositeSegment(layers, color, Rgba(0.0), kBehindAll, from, kBehindAll);
}
