#pragma once
// Gradient lighting (Blinn 1977 in the form of Phong 1975): the gradient of the scalar is the normal of the isosurface
// that a point lies on. Two-sided: a surface is lit from behind as from before. What vanishes with the gradient is left
// out, so that nothing is divided by 0.

struct Direction {
  Real x;
  Real y;
  Real z;
};

// A point of the volume as light meets it. `toEye` has length 1.
struct LitPoint {
  Direction normal;
  Direction toEye;
  Real facing;     // cosine between the normal and the direction to the eye
  Mask hasNormal;  // the gradient does not vanish
};

CONSTANT Scalar kLeastGradientSquared = Scalar(1.0e-12);  // of the largest of the mesh

FUNCTION Real along(Direction a, Direction b) { return (a.x * b.x + a.y * b.y) + a.z * b.z; }

FUNCTION Direction scaled(Direction d, Real factor) {
  Direction s;
  s.x = d.x * factor;
  s.y = d.y * factor;
  s.z = d.z * factor;
  return s;
}

// `gradient`: as a fraction of the largest.
FUNCTION LitPoint litPoint(Direction gradient, Direction toEye) {
  LitPoint p;
  Real squared = along(gradient, gradient);
  p.hasNormal = squared > Real(kLeastGradientSquared);
  p.normal = scaled(gradient, Real(1.0) / squareRoot(select(p.hasNormal, squared, Real(1.0))));
  p.toEye = toEye;
  p.facing = along(p.normal, toEye);
  return p;
}

FUNCTION Real powerOf(Real base, int exponent) {
  Real result = Real(1.0);
  Real square = base;
  for (int rest = exponent; rest > 0; rest = rest / 2) {
    if (rest % 2 == 1) result = result * square;
    square = square * square;
  }
  return result;
}

// What a light of intensity 1 in the direction `toLight` (length 1) adds: diffuse |n.l| + specular (r.v)^shininess, r
// the reflected ray.
FUNCTION Real lightFrom(LitPoint p, Direction toLight, Scalar diffuse, Scalar specular, int shininess) {
  Real onSurface = along(p.normal, toLight);
  Real reflected = Real(2.0) * onSurface * p.facing - along(toLight, p.toEye);
  Real shine = select(reflected > Real(0.0), powerOf(reflected, shininess), Real(0.0));
  Real light = Real(diffuse) * absolute(onSurface) + Real(specular) * shine;
  return select(p.hasNormal, light, Real(0.0));
}

// Darkens where the surface is seen edge on: 1 - strength (1 - |n.v|)^2.
FUNCTION Real silhouetteAt(LitPoint p, Scalar strength) {
  Real edge = Real(1.0) - absolute(p.facing);
  return select(p.hasNormal, Real(1.0) - Real(strength) * edge * edge, Real(1.0));
}

// What part of a segment's light comes from its front, where colour and extinction do not change along it:
// 1 / alpha + 1 / ln(1 - alpha), within 0.025, from 1/2 of a clear segment to 1 of an opaque one.
FUNCTION Real frontShare(Real alpha) {
  Real clear = select(alpha < Real(1.0), Real(1.0) - alpha, Real(0.0));
  Real y = squareRoot(squareRoot(clear));
  return Real(0.5) + (Real(1.0) - y) * (Real(0.449773) - y * (Real(0.0756045) + y * Real(0.0187332)));
}
