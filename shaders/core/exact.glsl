// The colour of a segment without any table of colours: cut at the knots of the transfer function (core/curve.glsl), each
// piece by the exact integral (core/integration.glsl). The usual segment lies within one piece and is thin: it takes
// one turn of both loops.

// A piece is integrated in steps of at most this optical depth, by few nodes each.
CONSTANT Scalar kStepDepth = Scalar(kDouble ? 0.1 : 0.69);
CONSTANT Scalar kUsedUp = Scalar(kDouble ? 1.0e-17 : 1.0e-8);  // transparency that nothing shows behind

// The weights of a piece at most kStepDepth deep. All of exp(-depth) is seen from half the depth, so that the remaining
// exponent is small enough for its series.
FUNCTION SegmentWeights weightsOfStep(Real opticalFront, Real opticalBack) {
  Real halfDepth = Real(0.25) * (opticalFront + opticalBack);
  Real front = Real(0.0);
  Real back = Real(0.0);
  const int first = kDouble ? 0 : kFirstStepNode;
  const int count = kDouble ? kShallowNodes : kStepNodes;
  for (int i = first; i < first + count; ++i) {
    Real s = Real(kNode[i]);
    Real slope = opticalFront * (Real(1.0) - s) + opticalBack * s;
    Real depth = Real(0.5) * s * (opticalFront + slope);
    Real light = Real(kNodeWeight[i]) * slope * (Real(1.0) + expm1Reduced(halfDepth - depth));
    front = front + (Real(1.0) - s) * light;
    back = back + s * light;
  }
  Real through = expOfNegative(-halfDepth);
  SegmentWeights w;
  w.back = through * back;
  w.front = atMost(through * front, Real(1.0) - w.back);
  w.alpha = w.front + w.back;
  return w;
}

// A sum of many small parts, with what its roundings have left out: hundreds of pieces would lose 3e-8 each.
struct LongSum {
  Rgba sum;
  Rgba rest;
};

FUNCTION void addTo(INOUT(Real) sum, INOUT(Real) rest, Real part) {
  PRECISE Real total = sum + part;
  PRECISE Real taken = total - sum;
  PRECISE Real left = part - taken;
  rest = rest + left;
  sum = total;
}

FUNCTION Real transparencyOf(LongSum light) { return (Real(1.0) - light.sum.a) - light.rest.a; }

FUNCTION void addUnder(INOUT(LongSum) light, Rgba back) {
  Real through = transparencyOf(light);
  addTo(light.sum.r, light.rest.r, through * back.r);
  addTo(light.sum.g, light.rest.g, through * back.g);
  addTo(light.sum.b, light.rest.b, through * back.b);
  addTo(light.sum.a, light.rest.a, through * back.a);
}

// Under `light` a piece on which (r, g, b, kappa) goes linearly from `front` to `back`.
FUNCTION void addPiece(INOUT(LongSum) light, Rgba front, Rgba back, Real length) {
  Real opticalFront = atMost(front.a * length, Real(kDepthLimit));
  Real opticalBack = atMost(back.a * length, Real(kDepthLimit));
  Rgba near = front;
  Mask goesOn;
  do {
    Real reach = reachOfDepth(opticalFront, opticalBack, Real(kStepDepth));
    Rgba far = mixed(near, back, reach);
    Real opticalFar = (Real(1.0) - reach) * opticalFront + reach * opticalBack;
    SegmentWeights w = weightsOfStep(reach * opticalFront, reach * opticalFar);
    addUnder(light, weightedColor(near, far, w));
    near = far;
    opticalFront = (Real(1.0) - reach) * opticalFar;
    opticalBack = (Real(1.0) - reach) * opticalBack;  // 0 at the end: a lane that is done adds nothing
    goesOn = reach < Real(1.0) && transparencyOf(light) > Real(kUsedUp);
  } while (anyLane(goesOn));
}

TABLE_FUNCTION Rgba exactSegment(TABLES Real scalarFront, Real scalarBack, Real length) {
  Mask rises = scalarBack > scalarFront;
  Real direction = select(rises, Real(1.0), Real(-1.0));
  Real borderShare = select(rises, Real(1.0), Real(0.0));
  Real whole = absolute(scalarBack - scalarFront);
  Real wholeOrOne = select(whole > Real(0.0), whole, Real(1.0));

  Piece piece = findPiece(WITH_TABLES scalarFront);
  Real share = shareOf(piece, scalarFront);
  Real toBorder = select(rises, beforeHigh(piece, scalarFront), pastLow(piece, scalarFront));
  Real toBack = whole;
  LongSum light;
  light.sum = Rgba(Real(0.0), Real(0.0), Real(0.0), Real(0.0));
  light.rest = light.sum;
  Mask goesOn = length >= Real(0.0);
  do {
    Mask crosses = toBorder < toBack;
    Real farShare = select(crosses, borderShare, shareOf(piece, scalarBack));
    Rgba low = TABLE(pieceLow)(piece.number);
    Rgba high = TABLE(pieceHigh)(piece.number);
    Real part = select(whole > Real(0.0), atMost(toBorder, toBack) / wholeOrOne, Real(1.0));
    addPiece(light, mixed(low, high, share), mixed(low, high, farShare), select(goesOn, part * length, Real(0.0)));
    goesOn = goesOn && crosses && transparencyOf(light) > Real(kUsedUp);

    piece.number = select(goesOn, piece.number + direction, piece.number);
    piece.place = TABLE(piecePlace)(piece.number);
    share = Real(1.0) - borderShare;
    toBorder = extentOf(piece);
    toBack = select(rises, pastLow(piece, scalarBack), beforeHigh(piece, scalarBack));
  } while (anyLane(goesOn));
  return Rgba(light.sum.r + light.rest.r, light.sum.g + light.rest.g, light.sum.b + light.rest.b,
              light.sum.a + light.rest.a);
}
