// Where the a-buffer keeps the fragments of a tile: one list a pixel, the lists of all pixels one after another, (payload,
// distance) each, 8 bytes. `ends[p]` is the end of the list of pixel p once all fragments are stored; the list begins where
// that of pixel p - 1 ends.
uniform ivec2 tileCorner;
uniform int tileWidth;

layout(std430, binding = 3) buffer Ends { uint ends[]; };

int pixelOfTile() {
  ivec2 place = ivec2(gl_FragCoord.xy) - tileCorner;
  return place.y * tileWidth + place.x;
}
