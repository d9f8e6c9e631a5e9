#pragma once
// Means of extinction and of light (colour times extinction) between two scalars by the integral functions of the
// transfer function, K(s) and G(s), kept at the knots. A difference of two running sums would lose the digits of a short
// segment; so what a segment has of its first and last piece is integrated there, and only what lies between, whole
// pieces, is a difference, of sums kept as head and tail. front = back needs no special case: both ends lie in one piece.
// Besides what core/curve.glsl needs, each side supplies
//   Rgba TABLE(pieceExtinction)(Real piece)  kappa at its lower and upper end, head and tail of K at its lower end
//   Rgba TABLE(lightHead)(Real piece), TABLE(lightTail)(Real piece)  G at its lower end: head and tail of r, g, b

// What a segment covers: [lowShare, highShare] of the piece `first`, whole pieces, and [0, lastShare] of the piece
// `last`. firstPart and lastPart are their parts of the segment, and a length of the scalar times perScalar is one.
struct Coverage {
  Real first;
  Real last;
  Real lowShare;
  Real highShare;
  Real lastShare;
  Real firstPart;
  Real lastPart;
  Real perScalar;
  Mask several;  // first and last are two
};

TABLE_FUNCTION Coverage coverageOf(TABLES Real scalarFront, Real scalarBack) {
  Mask rises = scalarBack > scalarFront;
  Real low = select(rises, scalarFront, scalarBack);
  Real high = select(rises, scalarBack, scalarFront);
  Piece first = findPiece(WITH_TABLES low);
  Piece last = findPiece(WITH_TABLES high);
  Coverage c;
  c.first = first.number;
  c.last = last.number;
  c.several = last.number > first.number;
  c.lowShare = shareOf(first, low);
  c.highShare = select(c.several, Real(1.0), shareOf(first, high));
  c.lastShare = shareOf(last, high);
  Real whole = high - low;
  c.perScalar = Real(1.0) / select(whole > Real(0.0), whole, Real(1.0));
  c.firstPart = select(c.several, beforeHigh(first, low) * c.perScalar, Real(1.0));
  c.lastPart = select(c.several, pastLow(last, high) * c.perScalar, Real(0.0));
  return c;
}

FUNCTION Real between(Real low, Real high, Real share) { return (Real(1.0) - share) * low + share * high; }

TABLE_FUNCTION Real meanExtinction(TABLES Coverage c) {
  Rgba first = TABLE(pieceExtinction)(c.first);
  Rgba next = TABLE(pieceExtinction)(select(c.several, c.first + Real(1.0), c.first));
  Rgba last = TABLE(pieceExtinction)(c.last);
  Real inFirst = between(first.r, first.g, Real(0.5) * (c.lowShare + c.highShare));
  Real inLast = between(last.r, last.g, Real(0.5) * c.lastShare);
  Real middle = (last.b - next.b) + (last.a - next.a);
  return c.firstPart * inFirst + c.lastPart * inLast +
         select(c.several, c.perScalar * middle, Real(0.0));
}

// The mean of colour times extinction over a stretch on which both are linear: (r, g, b, kappa) at its ends.
FUNCTION Rgba meanLightOfStretch(Rgba a, Rgba b) {
  Real wa = (Real(2.0) * a.a + b.a) * Real(1.0 / 6.0);
  Real wb = (a.a + Real(2.0) * b.a) * Real(1.0 / 6.0);
  return Rgba(wa * a.r + wb * b.r, wa * a.g + wb * b.g, wa * a.b + wb * b.b, wa + wb);
}

// Colour times extinction in r, g, b; extinction itself in a.
TABLE_FUNCTION Rgba meanLight(TABLES Coverage c) {
  Rgba low = TABLE(pieceLow)(c.first);
  Rgba high = TABLE(pieceHigh)(c.first);
  Rgba inFirst = meanLightOfStretch(mixed(low, high, c.lowShare), mixed(low, high, c.highShare));
  low = TABLE(pieceLow)(c.last);
  Rgba inLast = meanLightOfStretch(low, mixed(low, TABLE(pieceHigh)(c.last), c.lastShare));
  Real next = select(c.several, c.first + Real(1.0), c.first);
  Rgba head = TABLE(lightHead)(next);
  Rgba tail = TABLE(lightTail)(next);
  Rgba lastHead = TABLE(lightHead)(c.last);
  Rgba lastTail = TABLE(lightTail)(c.last);
  Real perScalar = select(c.several, c.perScalar, Real(0.0));
  return Rgba(c.firstPart * inFirst.r + c.lastPart * inLast.r +
                  perScalar * ((lastHead.r - head.r) + (lastTail.r - tail.r)),
              c.firstPart * inFirst.g + c.lastPart * inLast.g +
                  perScalar * ((lastHead.g - head.g) + (lastTail.g - tail.g)),
              c.firstPart * inFirst.b + c.lastPart * inLast.b +
                  perScalar * ((lastHead.b - head.b) + (lastTail.b - tail.b)),
              meanExtinction(WITH_TABLES c));
}

// The colour of a segment with the attenuation inside it left out of its light, not of its opacity (lookup `integral`).
TABLE_FUNCTION Rgba integralSegment(TABLES Real scalarFront, Real scalarBack, Real length) {
  Rgba light = meanLight(WITH_TABLES coverageOf(WITH_TABLES scalarFront, scalarBack));
  Real alpha = Real(0.0) - expm1OfNegative(Real(0.0) - length * light.a);
  // Without attenuation light has no bound of its own; colours are at most 1, and so is light at most the opacity.
  return Rgba(atMost(length * light.r, alpha), atMost(length * light.g, alpha), atMost(length * light.b, alpha), alpha);
}
