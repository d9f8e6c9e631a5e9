#pragma once
// The volume rendering integral over a piece of a ray on which colour and extinction are linear (docs/02-method.md,
// Integration). With x(s) the optical depth from the front to the fraction s of the way, the front's colour and the
// back's arrive with the weights
//   front = integral 0..1 of (1 - s) x'(s) exp(-x(s)) ds = 1 - Psi
//   back = integral 0..1 of s x'(s) exp(-x(s)) ds = Psi - zeta.
// Every term is positive, so a fixed Gauss-Legendre rule gives both to the last digits, where 1 - Psi of the closed
// forms with erf cancels. Of a deep piece only the part that light leaves is integrated.
#include "core/limits.glsl"

struct SegmentWeights {
  Real front;
  Real back;
  Real alpha;  // front + back = 1 - zeta: a colour of at most 1 stays at most alpha
};

// Three Gauss-Legendre rules on [0, 1], one behind the other. The two longer ones go through s = expm1(u) / expm1(1),
// which sets the nodes closer at the front, where the light comes from: 22 nodes do what takes 29.
CONSTANT int kShallowNodes = 7;  // 1e-15 up to kShallowDepth
CONSTANT int kMiddleNodes = 12;  // 1e-14 up to kMiddleDepth, 1e-7 at any depth
CONSTANT int kDeepNodes = 22;    // 1e-14 at any depth
CONSTANT Scalar kShallowDepth = Scalar(0.1);
CONSTANT Scalar kMiddleDepth = Scalar(1.0);
CONSTANT int kFirstMiddleNode = 7;
CONSTANT int kFirstDeepNode = 19;
CONSTANT Scalar kNode[41] = {
    // shallow
    0.02544604382862073776, 0.12923440720030278007, 0.29707742431130141654, 0.50000000000000000000,
    0.70292257568869858346, 0.87076559279969721996, 0.97455395617137926222,
    // middle
    0.00539045162273031513, 0.02858037915706099773, 0.07095927484011562306, 0.13337294533729340063,
    0.21634740871564545727, 0.31930126071689560294, 0.43954343155535417406, 0.57128119456982636169,
    0.70504928296349904002, 0.82807515119704998161, 0.92594714706495105888, 0.98548170631712184278,
    // deep
    0.00166257947490972179, 0.00877758162762538937, 0.02164762557124527656, 0.04038667383815298521,
    0.06513699841144616680, 0.09605007793819158431, 0.13325762266517377313, 0.17683411924651099705,
    0.22675118876515080654, 0.28282497490896378871, 0.34465925955454451127, 0.41158886533796770754,
    0.48262991174248384433, 0.55644525084673517821, 0.63133438796637837134, 0.70525679995493250360,
    0.77589530473440133641, 0.84076181140749841676, 0.89734168291319101404, 0.94326597260538626370,
    0.97649457659820413708, 0.99549351446318690677};
CONSTANT Scalar kNodeWeight[41] = {
    // shallow
    0.06474248308443484649, 0.13985269574463833395, 0.19091502525255947241, 0.20897959183673469387,
    0.19091502525255947241, 0.13985269574463833395, 0.06474248308443484649,
    // middle
    0.01385462164212619184, 0.03264628163066376198, 0.05226045029892818320, 0.07266787402302956281,
    0.09320136136383691735, 0.11227537154040750485, 0.12725436236370372586, 0.13463855634496388533,
    0.13074087924002097677, 0.11285937229935260198, 0.08062818029599731634, 0.03697268895696937151,
    // deep
    0.00426873636826521445, 0.00997633397739572813, 0.01578276476131476507, 0.02171938302506370505,
    0.02780699561845388942, 0.03404173975290214116, 0.04038652753497806620, 0.04676261893416270784,
    0.05304183624471998819, 0.05904065870108077581, 0.06451789688995627617, 0.06917793336737168550,
    0.07268149142717064804, 0.07466539906008236119, 0.07477173812453283128, 0.07268511775873400489,
    0.06817477815406102855, 0.06113621674380064820, 0.05162559964113398508, 0.03988001331347391943,
    0.02631860711093742396, 0.01153761349040820631};

CONSTANT Scalar kDeepest = Scalar(kDouble ? 37.0 : 20.0);  // what lies behind more optical depth is below the rounding
CONSTANT Scalar kDepthLimit = Scalar(1.0e15);              // its square is finite; more extinction changes nothing

// Fraction of the way, at most 1, at which the optical depth reaches `deepest`: the root in a form that does not cancel.
FUNCTION Real reachOfDepth(Real opticalFront, Real opticalBack, Real deepest) {
  Real depth = Real(0.5) * (opticalFront + opticalBack);
  Real radicand = opticalFront * opticalFront + Real(2.0) * (opticalBack - opticalFront) * deepest;
  Real root = squareRoot(select(radicand > Real(0.0), radicand, Real(0.0)));
  Real deep = select(depth > deepest, opticalFront + root, Real(2.0) * deepest);
  return atMost(Real(2.0) * deepest / deep, Real(1.0));
}

// The weights by the `count` nodes from `first`. opticalFront, opticalBack >= 0: extinction at the front and at the
// back times the length.
FUNCTION SegmentWeights weightsByRule(Real opticalFront, Real opticalBack, int first, int count) {
  Real atFront = atMost(opticalFront, Real(kDepthLimit));
  Real atBack = atMost(opticalBack, Real(kDepthLimit));
  Real reach = reachOfDepth(atFront, atBack, Real(kDeepest));
  Real front = Real(0.0);
  Real back = Real(0.0);
  for (int i = first; i < first + count; ++i) {
    Real s = reach * Real(kNode[i]);
    Real slope = atFront * (Real(1.0) - s) + atBack * s;
    Real depth = Real(0.5) * s * (atFront + slope);
    Real light = Real(kNodeWeight[i]) * slope * expOfNegative(Real(0.0) - depth);
    front = front + (Real(1.0) - s) * light;
    back = back + s * light;
  }
  SegmentWeights w;
  w.back = reach * back;
  w.front = atMost(reach * front, Real(1.0) - w.back);
  w.alpha = w.front + w.back;
  return w;
}

// The weights at any optical depth.
FUNCTION SegmentWeights segmentWeights(Real opticalFront, Real opticalBack) {
  return weightsByRule(opticalFront, opticalBack, kDouble ? kFirstDeepNode : kFirstMiddleNode,
                       kDouble ? kDeepNodes : kMiddleNodes);
}

FUNCTION Rgba weightedColor(Rgba front, Rgba back, SegmentWeights w) {
  return Rgba(front.r * w.front + back.r * w.back, front.g * w.front + back.g * w.back,
              front.b * w.front + back.b * w.back, w.alpha);
}

// The exact colour, premultiplied, of a piece on which (r, g, b, kappa) goes linearly from `front` to `back`.
FUNCTION Rgba linearPiece(Rgba front, Rgba back, Real length) {
  return weightedColor(front, back, segmentWeights(front.a * length, back.a * length));
}

// `color`, not premultiplied, seen with the opacity of an optical depth.
FUNCTION Rgba layerOfDepth(Rgba color, Real depth) {
  Real alpha = Real(0.0) - expm1OfNegative(Real(0.0) - depth);
  return Rgba(color.r * alpha, color.g * alpha, color.b * alpha, alpha);
}

// The colour of a segment known at its ends only (lookup `post`): extinction by the trapezoidal rule, the ends' colours
// in proportion to their extinction. `front` and `back` are (r, g, b, kappa).
FUNCTION Rgba trapezoidSegment(Rgba front, Rgba back, Real length) {
  Real sum = front.a + back.a;
  Real alpha = Real(0.0) - expm1OfNegative(Real(-0.5) * length * sum);
  Real share = alpha / select(sum > Real(0.0), sum, Real(1.0));
  return Rgba(share * (front.r * front.a + back.r * back.a), share * (front.g * front.a + back.g * back.a),
              share * (front.b * front.a + back.b * back.a), alpha);
}
