#pragma once
// Isosurfaces: the scalar is linear along a segment, so it is cut exactly where it crosses one, and the surfaces are
// composited between the parts, in the order of the ray.
// What is crossed follows from the numbers of surfaces at or below both ends: all in between, so those with
// front < value <= back or back < value <= front. As two segments that meet have one scalar there, none is missed and
// none crossed twice, wherever the scalar of a face lies.
UNIFORM(Texels, isosurfaceValues);  // ascending
UNIFORM(Texels, isosurfaceColors);  // (r, g, b, opacity), not premultiplied
UNIFORM(Scalar, isosurfaceCount);

// The number of surfaces at or below a scalar.
Real surfacesUpTo(Real scalar) {
  Real count = Real(0.0);
  for (int i = 0; i < int(isosurfaceCount); ++i)
    count = select(scalar >= Real(scalarAt(isosurfaceValues, i)), count + Real(1.0), count);
  return count;
}

// The premultiplied colour of a surface that a segment meets at a share of its way.
Rgba surfaceAt(Segment segment, Real share, Int surface) {
  Rgba color = rgbaAt(isosurfaceColors, surface);
  Real light = color.a;
  if (lit) light = light * lightAt(segment, share);
  return Rgba(color.r * light, color.g * light, color.b * light, color.a);
}

Rgba lookUpWithIsosurfaces(Segment segment) {
  Real below = surfacesUpTo(segment.scalarFront);
  Real last = surfacesUpTo(segment.scalarBack);
  Mask rises = last > below;
  Segment part = segment;
  Real begin = Real(0.0);  // of the part, as a share of the segment
  Rgba color = Rgba(Real(0.0), Real(0.0), Real(0.0), Real(0.0));
  Mask goesOn = segment.length >= Real(0.0);
  do {
    Mask crosses = goesOn && ((below < last) || (below > last));
    Int surface = toInt(select(crosses, select(rises, below, below - Real(1.0)), Real(0.0)));
    Real value = numberAt(isosurfaceValues, surface);
    Real difference = select(crosses, segment.scalarBack - segment.scalarFront, Real(1.0));
    Real end = select(crosses, (value - segment.scalarFront) / difference, Real(1.0));
    part.scalarBack = select(crosses, value, segment.scalarBack);
    part.length = segment.length * (end - begin);
    if (lit) part.back = payloadAt(segment, end);
    Rgba found = lookUpVolume(part);
    WHERE_ANY(crosses) { found = selectColor(crosses, compositeUnder(found, surfaceAt(segment, end, surface)), found); }
    color = selectColor(goesOn, compositeUnder(color, found), color);
    part.scalarFront = part.scalarBack;
    if (lit) part.front = part.back;
    begin = end;
    below = select(crosses, select(rises, below + Real(1.0), below - Real(1.0)), below);
    goesOn = crosses && (color.a < Real(1.0));
  } while (anyLane(goesOn));
  return color;
}
