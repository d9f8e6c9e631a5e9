#pragma once
// A stretch of the ray between two successive fragments; drawn where `visible` holds.
struct Segment {
  Payload front;  // what its ends carry; their scalars, where they carry one, are
  Payload back;
  Real scalarFront;
  Real scalarBack;
  Real length;
  Real middle;  // its distance along the ray
  Mask visible;
};
