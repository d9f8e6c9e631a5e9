#pragma once
// Front-to-back compositing of premultiplied colours.

FUNCTION Rgba compositeUnder(Rgba front, Rgba back) {
  Real through = Real(1.0) - front.a;
  return Rgba(front.r + through * back.r, front.g + through * back.g, front.b + through * back.b,
              front.a + through * back.a);
}

FUNCTION Rgba selectColor(Mask condition, Rgba yes, Rgba no) {
  return Rgba(select(condition, yes.r, no.r), select(condition, yes.g, no.g), select(condition, yes.b, no.b),
              select(condition, yes.a, no.a));
}
