// Isosurfaces alone: between them there is nothing.
Rgba lookUp(Segment segment) {
  segment.length = Real(0.0);
  return Rgba(segment.length, segment.length, segment.length, segment.length);
}
