#pragma once
// The k-buffer (Callahan, Ikits, Comba, Silva 2005): a pixel keeps the HAVS_K nearest fragments that have come and not
// yet left. A new fragment goes in, the nearest of the HAVS_K + 1 goes out; with the next nearest it bounds a segment
// of the ray. Entries stay sorted by distance, near first, so that one chain of HAVS_K compare-exchanges finds both.
// Beyond the paper: empty entries are nearer than everything and leave first; each fragment carries its kind, and a
// running count of entries minus exits says whether a segment lies inside the mesh.

// What a fragment carries besides its distance, packed as suits the machine. Each side supplies the type Payload and
//   Payload makePayload(Real scalar, Real kind)   scalar in [0, 1]; kind +1: the ray enters the mesh, -1: it leaves,
//                                                 0: a face between two cells
//   Real scalarOf(Payload)   Real kindOf(Payload)   Payload selectPayload(Mask condition, Payload yes, Payload no)

#include "core/segment.glsl"

struct Fragment {
  Real distance;  // along the ray, local units, relative to the plane through the mesh's centre
  Payload payload;
};

struct KBuffer {
  Fragment entry[HAVS_K];
};

// What happened to a pixel besides the k-buffer. `inside`: entries minus exits of all fragments that left. `started`: 1
// once a real fragment left.
struct PixelState {
  Real inside;
  Real started;
};

CONSTANT Scalar kEmptyDistance = Scalar(-3.0e38);
CONSTANT Scalar kEmptyLimit = Scalar(-1.0e38);  // everything below is empty
CONSTANT Scalar kLateTolerance = Scalar(1.0e-6);

FUNCTION Fragment makeFragment(Real scalar, Real distance, Real kind) {
  Fragment f;
  f.distance = distance;
  f.payload = makePayload(scalar, kind);
  return f;
}

FUNCTION Fragment emptyFragment() { return makeFragment(Real(0.0), Real(kEmptyDistance), Real(0.0)); }

FUNCTION Mask isEmpty(Fragment f) { return f.distance < Real(kEmptyLimit); }

FUNCTION Fragment selectFragment(Mask condition, Fragment yes, Fragment no) {
  Fragment f;
  f.distance = select(condition, yes.distance, no.distance);
  f.payload = selectPayload(condition, yes.payload, no.payload);
  return f;
}

// `f` is late: misordered (nearer than the nearest entry by more than the tolerance) after a first fragment has left,
// so that the segment it belongs to has been drawn already. entry[0] is empty, at -3e38, as long as the buffer is not
// full.
// Late, too, is the exit from a part that should have changed places (orderBoundaries) with the nearest entry: the
// segment before that is drawn already.
FUNCTION Mask isLateBy(KBuffer kbuffer, PixelState state, Fragment f, Real tolerance) {
  Fragment nearest = kbuffer.entry[0];
  Mask ends = (state.inside > Real(0.5)) && (kindOf(f.payload) < Real(-0.5)) &&
              (kindOf(nearest.payload) > Real(0.5));
  Real reach = select(ends, tolerance, -tolerance);
  return (state.started > Real(0.5)) && (f.distance < nearest.distance + reach);
}

FUNCTION Mask isLate(KBuffer kbuffer, PixelState state, Fragment f) {
  return isLateBy(kbuffer, state, f, Real(kLateTolerance));
}

FUNCTION Real farther(Real a, Real b) { return select(a < b, b, a); }

// Inserts `f`; `front` leaves. Of equal distances the earlier comer leaves first. Of distances less than `same` apart,
// too: where the order in which fragments come can be believed, it knows more than distances that differ by their
// rounding. `f` then lies where the one before it does.
FUNCTION void insertFragment(INOUT(KBuffer) kbuffer, Fragment f, Real same, OUT(Fragment) front) {
  Mask placed = f.distance < kbuffer.entry[0].distance - same;
  front = selectFragment(placed, f, kbuffer.entry[0]);
  Fragment carried = selectFragment(placed, kbuffer.entry[0], f);
  carried.distance = farther(carried.distance, kbuffer.entry[0].distance);
  for (int i = 1; i < HAVS_K; ++i) {
    placed = placed || (f.distance < kbuffer.entry[i].distance - same);
    Fragment entry = kbuffer.entry[i];
    kbuffer.entry[i - 1] = selectFragment(placed, carried, entry);
    carried = selectFragment(placed, entry, carried);
    carried.distance = farther(carried.distance, entry.distance);
  }
  kbuffer.entry[HAVS_K - 1] = carried;
}

// `front` has left and `back` is the next nearest: brings the state up to date and gives the segment between them.
FUNCTION Segment leave(INOUT(PixelState) state, Fragment front, Fragment back) {
  Mask real = !isEmpty(front);
  state.inside = state.inside + kindOf(front.payload);
  state.started = select(real, Real(1.0), state.started);
  Segment segment;
  segment.front = front.payload;
  segment.back = back.payload;
  segment.scalarFront = scalarOf(front.payload);
  segment.scalarBack = scalarOf(back.payload);
  segment.middle = Real(0.5) * front.distance + Real(0.5) * back.distance;
  Real stretch = back.distance - front.distance;
  segment.length = select(stretch > Real(0.0), stretch, Real(0.0));
  segment.visible = real && (state.inside > Real(0.5));
  return segment;
}

// `first` and `second` come next, in a pixel whose inside-count before them is `inside`. An entry and an exit nearer to
// each other than rounding tells come in the order that the count asks for. Where two parts of the mesh touch, the ray
// leaves one and enters the other at one place: with the entry first, what lies before would end at a scalar of the part
// behind, and what lies behind begin at one of the part before. Outside, where nothing can be left, the two are a thin
// layer: with the exit first, an opaque one would not be met.
FUNCTION void orderBoundaries(INOUT(Fragment) first, INOUT(Fragment) second, Real inside) {
  Real firstKind = kindOf(first.payload);
  Real secondKind = kindOf(second.payload);
  Mask within = (inside > Real(0.5)) && (firstKind > Real(0.5)) && (secondKind < Real(-0.5));
  Mask outside = (inside < Real(0.5)) && (firstKind < Real(-0.5)) && (secondKind > Real(0.5));
  Mask turned = (within || outside) && (second.distance - first.distance < Real(kLateTolerance));
  Payload kept = first.payload;
  first.payload = selectPayload(turned, second.payload, kept);  // distances stay, and with them the order
  second.payload = selectPayload(turned, kept, second.payload);
}

// `front` has left; `rest` is what is left behind it: as above. A single entry has no other behind it to change places
// with; it does so with the front.
FUNCTION Segment leaveBefore(INOUT(PixelState) state, Fragment front, INOUT(KBuffer) rest) {
  if (HAVS_K > 1) {
    orderBoundaries(rest.entry[0], rest.entry[HAVS_K > 1 ? 1 : 0], state.inside + kindOf(front.payload));
  } else {
    orderBoundaries(front, rest.entry[0], state.inside);
  }
  return leave(state, front, rest.entry[0]);
}

// The nearest leaves without another in its place.
FUNCTION Fragment takeNearest(INOUT(KBuffer) kbuffer) {
  Fragment nearest = kbuffer.entry[0];
  for (int i = 0; i + 1 < HAVS_K; ++i) kbuffer.entry[i] = kbuffer.entry[i + 1];
  kbuffer.entry[HAVS_K - 1] = emptyFragment();
  return nearest;
}
