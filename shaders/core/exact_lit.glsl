#pragma once
// exactSegment (core/exact.glsl) under light that goes linearly from one end of the segment to the other, as does the
// share of the extinction that a modulation leaves: both are taken at the ends of each piece, where the colour is. Of the
// products' bends within a piece, which are small against its own, nothing is kept.

struct LightAlong {
  Real front;
  Real back;
  Real densityFront;
  Real densityBack;
};

// (r, g, b, kappa) of the transfer function under the light at `share` of the way.
FUNCTION Rgba sampleInLight(Rgba at, LightAlong along, Real share) {
  Real light = (Real(1.0) - share) * along.front + share * along.back;
  Real density = (Real(1.0) - share) * along.densityFront + share * along.densityBack;
  return Rgba(at.r * light, at.g * light, at.b * light, at.a * density);
}

TABLE_FUNCTION Rgba exactSegmentInLight(TABLES Real scalarFront, Real scalarBack, Real length, LightAlong along) {
  Mask rises = scalarBack > scalarFront;
  Real direction = select(rises, Real(1.0), Real(-1.0));
  Real borderShare = select(rises, Real(1.0), Real(0.0));
  Real whole = absolute(scalarBack - scalarFront);
  Real perWhole = Real(1.0) / select(whole > Real(0.0), whole, Real(1.0));

  Piece piece = findPiece(WITH_TABLES scalarFront);
  Real share = shareOf(piece, scalarFront);
  Real toBorder = select(rises, beforeHigh(piece, scalarFront), pastLow(piece, scalarFront));
  Real toBack = whole;
  Real done = Real(0.0);  // of the way
  LongSum light;
  light.sum = Rgba(Real(0.0), Real(0.0), Real(0.0), Real(0.0));
  light.rest = light.sum;
  Mask goesOn = length >= Real(0.0);
  do {
    Mask crosses = toBorder < toBack;
    Real farShare = select(crosses, borderShare, shareOf(piece, scalarBack));
    Rgba low = TABLE(pieceLow)(piece.number);
    Rgba high = TABLE(pieceHigh)(piece.number);
    Real stretch = atMost(toBorder, toBack);
    Real part = select(stretch < whole, stretch * perWhole, Real(1.0));
    Real next = select(crosses, atMost(done + part, Real(1.0)), Real(1.0));
    addPiece(light, sampleInLight(mixed(low, high, share), along, done),
             sampleInLight(mixed(low, high, farShare), along, next), select(goesOn, part * length, Real(0.0)));
    done = next;
    goesOn = goesOn && crosses && transparencyOf(light) > Real(kUsedUp);

    WHERE_ANY(goesOn) {
      piece.number = select(goesOn, piece.number + direction, piece.number);
      piece.place = TABLE(piecePlace)(piece.number);
      share = Real(1.0) - borderShare;
      toBorder = extentOf(piece);
      toBack = select(rises, pastLow(piece, scalarBack), beforeHigh(piece, scalarBack));
    }
  } while (anyLane(goesOn));
  return Rgba(light.sum.r + light.rest.r, light.sum.g + light.rest.g, light.sum.b + light.rest.b,
              light.sum.a + light.rest.a);
}
