#pragma once
// The colour of a segment without any table of colours: cut at the knots of the transfer function (core/curve.glsl), each
// piece by the exact integral (core/integration.glsl). The usual segment lies within one piece and is thin: it takes
// one turn of both loops.

// A piece is integrated in steps of at most this optical depth; kUsedUp is a transparency that nothing shows through.
CONSTANT Scalar kStepDepth = Scalar(kDouble ? 0.05 : 0.69);  // half of it is small enough for expm1Reduced
CONSTANT Scalar kUsedUp = Scalar(kDouble ? 1.0e-17 : 1.0e-8);

// exp(d / 2) (w.back - w.front) of a piece whose optical depth is d and rises by 2b more at its back than at its front:
// the integral of 2t (d + 2bt) exp(-dt + b (1/4 - t^2)) for t from -1/2 to 1/2, by its series. Only even powers of d
// are there. |b| <= d <= kStepDepth: what is left out is below 2e-8 d.
CONSTANT Scalar kTilt[17] = {
    0.3333333333333333333,     0.03333333333333333333,   0.002380952380952380952,   0.0001322751322751322751,
    6.012506012506012506e-6,   2.312502312502312502e-7,  // d^0, b^1 and on
    -0.1666666666666666667,    0.008333333333333333333,  0.0005952380952380952381,  0.00003306878306878306878,
    1.503126503126503127e-6,                             // d^2, b^0 and on
    -0.004166666666666666667,  0.00007440476190476190476, 4.133597883597883598e-6, 1.878908128908128908e-7,  // d^4
    -0.00003720238095238095238, 3.444664902998236626e-7};  // d^6

FUNCTION Real tiltOfStep(Real d, Real b) {
  Real dd = d * d;
  Real p0 = Real(kTilt[5]);
  for (int i = 4; i >= 0; --i) p0 = p0 * b + Real(kTilt[i]);
  Real p2 = Real(kTilt[10]);
  for (int i = 9; i >= 6; --i) p2 = p2 * b + Real(kTilt[i]);
  Real p4 = ((Real(kTilt[14]) * b + Real(kTilt[13])) * b + Real(kTilt[12])) * b + Real(kTilt[11]);
  Real p6 = Real(kTilt[16]) * b + Real(kTilt[15]);
  return p0 * b + dd * (p2 + dd * (p4 + dd * p6));
}

// The weights of a piece at most kStepDepth deep. Neither of both is much smaller than the other, so half the sum and
// half the difference give them to their last digits.
FUNCTION SegmentWeights weightsOfStep(Real opticalFront, Real opticalBack) {
  Real depth = Real(0.5) * (opticalFront + opticalBack);
  Real lost = expm1Reduced(Real(-0.5) * depth);
  Real alpha = (Real(0.0) - lost) * (Real(2.0) + lost);
  Real tilt = (Real(1.0) + lost) * tiltOfStep(depth, Real(0.5) * (opticalBack - opticalFront));
  SegmentWeights w;
  w.front = Real(0.5) * (alpha - tilt);
  w.back = Real(0.5) * (alpha + tilt);
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
    Rgba far = back;
    Real stepFront = opticalFront;
    Real stepBack = opticalBack;
    goesOn = Real(0.5) * (opticalFront + opticalBack) > Real(kStepDepth);
    WHERE_ANY(goesOn) {
      Real part = reachOfDepth(opticalFront, opticalBack, Real(kStepDepth));
      Real rest = Real(1.0) - part;
      Real opticalFar = rest * opticalFront + part * opticalBack;
      far = mixed(near, back, part);
      stepFront = part * opticalFront;
      stepBack = part * opticalFar;
      opticalFront = rest * opticalFar;
      opticalBack = rest * opticalBack;
    }
    addUnder(light, weightedColor(near, far, weightsOfStep(stepFront, stepBack)));
    near = far;
    goesOn = goesOn && transparencyOf(light) > Real(kUsedUp);
    opticalFront = select(goesOn, opticalFront, Real(0.0));  // a lane that is done adds nothing
    opticalBack = select(goesOn, opticalBack, Real(0.0));
  } while (anyLane(goesOn));
}

TABLE_FUNCTION Rgba exactSegment(TABLES Real scalarFront, Real scalarBack, Real length) {
  Mask rises = scalarBack > scalarFront;
  Real direction = select(rises, Real(1.0), Real(-1.0));
  Real borderShare = select(rises, Real(1.0), Real(0.0));
  Real whole = absolute(scalarBack - scalarFront);

  Piece piece = findPiece(WITH_TABLES scalarFront);
  Real perExtent = Real(1.0) / extentOf(piece);
  Real share = shareOf(piece, scalarFront, perExtent);
  Real toBorder = select(rises, beforeHigh(piece, scalarFront), pastLow(piece, scalarFront));
  Real toBack = whole;
  LongSum light;
  light.sum = Rgba(Real(0.0), Real(0.0), Real(0.0), Real(0.0));
  light.rest = light.sum;
  Mask goesOn = length >= Real(0.0);
  do {
    Mask crosses = toBorder < toBack;
    Real farShare = select(crosses, borderShare, shareOf(piece, scalarBack, perExtent));
    Rgba low = TABLE(pieceLow)(piece.number);
    Rgba high = TABLE(pieceHigh)(piece.number);
    Real stretch = atMost(toBorder, toBack);
    Mask isPart = stretch < whole;
    Real part = Real(1.0);
    WHERE_ANY(isPart) { part = select(isPart, stretch / whole, Real(1.0)); }
    addPiece(light, mixed(low, high, share), mixed(low, high, farShare), select(goesOn, part * length, Real(0.0)));
    goesOn = goesOn && crosses && transparencyOf(light) > Real(kUsedUp);

    WHERE_ANY(goesOn) {
      piece.number = select(goesOn, piece.number + direction, piece.number);
      piece.place = TABLE(piecePlace)(piece.number);
      share = Real(1.0) - borderShare;
      toBorder = extentOf(piece);
      perExtent = Real(1.0) / toBorder;
      toBack = select(rises, pastLow(piece, scalarBack), beforeHigh(piece, scalarBack));
    }
  } while (anyLane(goesOn));
  return Rgba(light.sum.r + light.rest.r, light.sum.g + light.rest.g, light.sum.b + light.rest.b,
              light.sum.a + light.rest.a);
}
