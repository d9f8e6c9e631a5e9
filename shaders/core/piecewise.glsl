#pragma once
// The same means as core/integral_functions.glsl, from piece to piece between the knots of the transfer function: for
// segments that cross few of them, most of which lie within one piece. From the lower scalar up, whichever is in front.

struct PieceWalk {
  Piece piece;
  Real begin;     // of the stretch, past the piece's lower end
  Real toBorder;  // from there to the piece's upper end
  Real toHigh;    // and to the segment's higher scalar
};

// The stretch of a segment in one piece: from where to where it goes, as shares of the piece, and what part of the segment
// it is.
struct PieceStretch {
  Real from;
  Real to;
  Real part;
  Mask crosses;  // the segment goes on in the next piece
};

TABLE_FUNCTION PieceWalk walkFrom(TABLES Real low, Real whole) {
  PieceWalk walk;
  walk.piece = findPiece(WITH_TABLES low);
  walk.begin = pastLow(walk.piece, low);
  walk.toBorder = beforeHigh(walk.piece, low);
  walk.toHigh = whole;
  return walk;
}

FUNCTION Real share(Real past, Real perExtent) { return atMost(atLeast(past * perExtent, Real(0.0)), Real(1.0)); }

FUNCTION PieceStretch stretchIn(PieceWalk walk, Real high, Real whole) {
  PieceStretch s;
  Real extent = extentOf(walk.piece);
  Real perExtent = Real(1.0) / extent;
  s.crosses = walk.toBorder < walk.toHigh;
  s.from = share(walk.begin, perExtent);
  s.to = select(s.crosses, Real(1.0), share(pastLow(walk.piece, high), perExtent));
  Real stretch = select(s.crosses, walk.toBorder, walk.toHigh);
  Mask isPart = stretch < whole;
  s.part = Real(1.0);
  WHERE_ANY(isPart) { s.part = select(isPart, stretch / whole, Real(1.0)); }
  return s;
}

TABLE_FUNCTION void goOn(TABLES INOUT(PieceWalk) walk, Mask goesOn, Real high) {
  walk.piece.number = select(goesOn, walk.piece.number + Real(1.0), walk.piece.number);
  walk.piece.place = TABLE(piecePlace)(walk.piece.number);
  walk.begin = Real(0.0);
  walk.toBorder = extentOf(walk.piece);
  walk.toHigh = pastLow(walk.piece, high);
}

TABLE_FUNCTION Real meanExtinctionByPieces(TABLES Real scalarFront, Real scalarBack) {
  Mask rises = scalarBack > scalarFront;
  Real low = select(rises, scalarFront, scalarBack);
  Real high = select(rises, scalarBack, scalarFront);
  Real whole = high - low;
  PieceWalk walk = walkFrom(WITH_TABLES low, whole);
  Real sum = Real(0.0);
  Mask goesOn = whole >= Real(0.0);
  do {
    PieceStretch s = stretchIn(walk, high, whole);
    Rgba ends = TABLE(pieceExtinction)(walk.piece.number);
    sum = select(goesOn, sum + s.part * between(ends.r, ends.g, Real(0.5) * (s.from + s.to)), sum);
    goesOn = goesOn && s.crosses;
    WHERE_ANY(goesOn) { goOn(WITH_TABLES walk, goesOn, high); }
  } while (anyLane(goesOn));
  return sum;
}

// Colour times extinction in r, g, b; extinction itself in a.
TABLE_FUNCTION Rgba meanLightByPieces(TABLES Real scalarFront, Real scalarBack) {
  Mask rises = scalarBack > scalarFront;
  Real low = select(rises, scalarFront, scalarBack);
  Real high = select(rises, scalarBack, scalarFront);
  Real whole = high - low;
  PieceWalk walk = walkFrom(WITH_TABLES low, whole);
  Rgba sum = Rgba(Real(0.0), Real(0.0), Real(0.0), Real(0.0));
  Mask goesOn = whole >= Real(0.0);
  do {
    PieceStretch s = stretchIn(walk, high, whole);
    Rgba atLow = TABLE(pieceLow)(walk.piece.number);
    Rgba atHigh = TABLE(pieceHigh)(walk.piece.number);
    Rgba light = meanLightOfStretch(mixed(atLow, atHigh, s.from), mixed(atLow, atHigh, s.to));
    Real part = select(goesOn, s.part, Real(0.0));
    sum = Rgba(sum.r + part * light.r, sum.g + part * light.g, sum.b + part * light.b, sum.a + part * light.a);
    goesOn = goesOn && s.crosses;
    WHERE_ANY(goesOn) { goOn(WITH_TABLES walk, goesOn, high); }
  } while (anyLane(goesOn));
  return sum;
}
