#pragma once
// The transfer function as it is: pieces of [0, 1] between its knots, on which colour and extinction are linear, so that
// neither a knot nor a step is smeared. Knots are pairs of numbers, head and tail, as a float alone would move those
// that lie close. A guide over equal cells of the scalar says where to begin to look. Each side supplies
//   Real TABLE(pieceNear)(Real s)       number of a piece that begins at s or before: the last that begins at s's cell
//   Rgba TABLE(piecePlace)(Real piece)  head and tail of its lower end, head and tail of its upper end
//   Rgba TABLE(pieceLow)(Real piece), TABLE(pieceHigh)(Real piece)  (r, g, b, kappa) at its ends
// The last piece ends a little above 1, so that every scalar lies below the upper end of a piece.

struct Piece {
  Real number;
  Rgba place;
};

// How far s is past the lower end, and how far before the upper end, of a piece.
FUNCTION Real pastLow(Piece piece, Real s) { return (s - piece.place.r) - piece.place.g; }
FUNCTION Real beforeHigh(Piece piece, Real s) { return (piece.place.b - s) + piece.place.a; }
FUNCTION Real extentOf(Piece piece) { return (piece.place.b - piece.place.r) + (piece.place.a - piece.place.g); }

// Where s lies in the piece, from 0 to 1. perExtent: 1 / extentOf(piece).
FUNCTION Real shareOf(Piece piece, Real s, Real perExtent) {
  Real share = pastLow(piece, s) * perExtent;
  return select(share > Real(0.0), select(share < Real(1.0), share, Real(1.0)), Real(0.0));
}
FUNCTION Real shareOf(Piece piece, Real s) { return shareOf(piece, s, Real(1.0) / extentOf(piece)); }

FUNCTION Rgba mixed(Rgba low, Rgba high, Real share) {
  Real rest = Real(1.0) - share;
  return Rgba(rest * low.r + share * high.r, rest * low.g + share * high.g, rest * low.b + share * high.b,
              rest * low.a + share * high.a);
}

// The piece that s lies in; at a knot, the upper one.
TABLE_FUNCTION Piece findPiece(TABLES Real s) {
  Piece piece;
  piece.number = TABLE(pieceNear)(s);
  Mask past;
  do {
    piece.place = TABLE(piecePlace)(piece.number);
    past = beforeHigh(piece, s) <= Real(0.0);
    piece.number = select(past, piece.number + Real(1.0), piece.number);
  } while (anyLane(past));
  return piece;
}

// (r, g, b, kappa) at s; at a step, the upper side.
TABLE_FUNCTION Rgba curveAt(TABLES Real s) {
  Piece piece = findPiece(WITH_TABLES s);
  return mixed(TABLE(pieceLow)(piece.number), TABLE(pieceHigh)(piece.number), shareOf(piece, s));
}
