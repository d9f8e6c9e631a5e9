// Fragments at one distance: whichever comes first, one picture.
#include <algorithm>
#include <numeric>

#include "core/arithmetic.h"
#include "hard/like_plain.h"

namespace havs::test {
namespace {

constexpr const char* kGroup = "Ties";

using Ties = HardPictureTest;

/// A fragment as tests write it.
struct Given {
  double distance, scalar, kind;
};
bool operator<(const Given& a, const Given& b) {
  return std::tie(a.distance, a.kind, a.scalar) < std::tie(b.distance, b.kind, b.scalar);
}

/// What a k-buffer makes of fragments in the order given: the visible segments longer than `kept`, each as
/// front scalar, back scalar, length.
template <class Lane, int K>
std::vector<std::array<double, 3>> segmentsOf(const std::vector<Given>& fragments, double kept) {
  using A = Arithmetic<Lane, K>;
  using Real = typename Lane::Real;
  typename A::KBuffer buffer;
  for (auto& entry : buffer.entry) entry = A::emptyFragment();
  typename A::PixelState state{0, 0};
  std::vector<std::array<double, 3>> segments;
  const auto leave = [&](const typename A::Fragment& front) {
    const auto segment = A::leaveBefore(state, front, buffer);
    if (segment.visible && segment.length > kept)
      segments.push_back({double{segment.scalarFront}, double{segment.scalarBack}, double{segment.length}});
  };
  for (const Given& f : fragments) {
    typename A::Fragment front;
    A::insertFragment(
        buffer, A::makeFragment(static_cast<Real>(f.scalar), static_cast<Real>(f.distance), static_cast<Real>(f.kind)),
        Real(0), front);
    leave(front);
  }
  for (int i = 0; i + 1 < K; ++i) leave(A::takeNearest(buffer));
  return segments;
}

/// The largest difference of any number of two lists of segments; 1 for lists of different length.
double difference(const std::vector<std::array<double, 3>>& a, const std::vector<std::array<double, 3>>& b) {
  if (a.size() != b.size()) return 1;
  double most = 0;
  for (std::size_t i = 0; i < a.size(); ++i)
    for (std::size_t j = 0; j < 3; ++j) most = std::max(most, std::abs(a[i][j] - b[i][j]));
  return most;
}

/// Over every order in which the fragments may come, the largest difference from `truth`.
template <class Lane, int K>
double worstOfAllOrders(std::vector<Given> fragments, const std::vector<std::array<double, 3>>& truth, double kept) {
  std::sort(fragments.begin(), fragments.end());
  double worst = 0;
  do {
    worst = std::max(worst, difference(segmentsOf<Lane, K>(fragments, kept), truth));
  } while (std::next_permutation(fragments.begin(), fragments.end()));
  return worst;
}

/// Two parts that touch at distance 0, give or take `gap`.
std::vector<Given> touchingParts(double gap) {
  return {{-1, 0.125, 1}, {-0.5, 0.1875, 0}, {0, 0.25, -1}, {gap, 0.75, 1}, {0.5, 0.8125, 0}, {1, 0.875, -1}};
}
const std::vector<std::array<double, 3>> kSegmentsOfTouching{
    {0.125, 0.1875, 0.5}, {0.1875, 0.25, 0.5}, {0.75, 0.8125, 0.5}, {0.8125, 0.875, 0.5}};

TEST_F(Ties, ExitAndEntryAtOnePlaceInEveryOrder) {
  tell({kGroup,
        "of equal distances the earlier comer left first: an entry before the exit that it touches gave the segment "
        "behind them the scalar of the part before",
        "within a part an exit goes before an entry at its place: the same segments in all 720 orders"});
  expectAtMost("segments, in float", worstOfAllOrders<FloatLane, 6>(touchingParts(0), kSegmentsOfTouching, 0), 0);
  expectAtMost("segments, in double", worstOfAllOrders<DoubleLane, 6>(touchingParts(0), kSegmentsOfTouching, 0), 0);
}

TEST_F(Ties, ExitAndEntryARoundingApartInEveryOrder) {
  tell({kGroup, "two faces at one place have distances some roundings apart, with the entry before the exit",
        "an entry up to 1e-6 of the radius before the exit counts as at its place"});
  // What is lost or gained is the overlap, at either end.
  for (const double gap : {-8e-7, -1.2e-7, 6e-8, 8e-7})
    expectAtMost("segments, in float", worstOfAllOrders<FloatLane, 6>(touchingParts(gap), kSegmentsOfTouching, 1e-6),
                 1e-6);
}

TEST_F(Ties, AnExitThatComesTooLateIsCounted) {
  tell({kGroup, "where the exit comes when what lies before is drawn already, a distance 1e-7 behind the entry hid it",
        "it is late, as the certificate says, and what lies behind begins at its own scalar"});
  using A = Arithmetic<FloatLane, 2>;
  typename A::KBuffer buffer{{A::emptyFragment(), A::emptyFragment()}};
  typename A::PixelState state{0, 0};
  double late = 0;
  for (const Given& f : {Given{-1, 0.125, 1}, Given{0, 0.75, 1}, Given{0.5, 0.8125, 0}, Given{1e-7, 0.25, -1}}) {
    const auto fragment =
        A::makeFragment(static_cast<float>(f.scalar), static_cast<float>(f.distance), static_cast<float>(f.kind));
    if (A::isLate(buffer, state, fragment)) {
      ++late;
      state.inside += A::kindOf(fragment.payload);
      continue;
    }
    typename A::Fragment front;
    A::insertFragment(buffer, fragment, 0, front);
    A::leaveBefore(state, front, buffer);
  }
  const typename A::Fragment nearest = A::takeNearest(buffer);
  const auto behind = A::leaveBefore(state, nearest, buffer);
  expectAtMost("late fragments not counted", 1 - late, 0);
  expectAtMost("scalar behind the touch", std::abs(double{behind.scalarFront} - 0.75), 0);
  EXPECT_TRUE(behind.visible);
}

TEST_F(Ties, AThinLayersExitBeforeItsEntryAtEveryK) {
  tell(
      {kGroup,
       "at a silhouette rounding puts the exit before its entry: an opaque layer was not met, and with k = 1 still not "
       "when it was mended for other k",
       "outside of all parts the entry goes first; a single entry of the k-buffer changes places with what leaves"});
  const double thin = 0x1p-21;
  const std::vector<Given> turned{{0, 0.75, -1}, {thin, 0.25, 1}};
  const std::vector<std::array<double, 3>> layer{{0.25, 0.75, thin}};
  expectAtMost("k = 1", difference(segmentsOf<FloatLane, 1>(turned, 0), layer), 0);
  expectAtMost("k = 2", worstOfAllOrders<FloatLane, 2>(turned, layer, 0), 0);
  expectAtMost("k = 6", worstOfAllOrders<FloatLane, 6>(turned, layer, 0), 0);
}

TEST_F(Ties, ThinLayersStayLayers) {
  tell({kGroup, "a layer thinner than the distance that counts as one place must not be taken for a touch",
        "only within a part does an exit change places with an entry"});
  const double thin = 0x1p-21;  // 4.8e-7
  const std::vector<Given> alone{{0, 0.25, 1}, {thin, 0.75, -1}};
  expectAtMost("a layer alone", worstOfAllOrders<FloatLane, 2>(alone, {{0.25, 0.75, thin}}, 0), 0);
  const std::vector<Given> between{{-1, 0.125, 1},    {0, 0.25, -1},   {0, 0.5, 1},
                                   {thin, 0.625, -1}, {thin, 0.75, 1}, {1, 0.875, -1}};
  expectAtMost(
      "a layer between two parts",
      worstOfAllOrders<FloatLane, 6>(
          between, {{0.125, 0.25, 1}, {0.5, 0.625, thin}, {0.75, 0.875, double{static_cast<float>(1 - thin)}}}, 0),
      0);
}

TEST_F(Ties, InnerFacesAtOnePlaceInEveryOrder) {
  tell({kGroup, "a ray through a vertex meets many faces at one distance",
        "they have one scalar there, and what lies between them has no length: the same segments in all 5040 orders"});
  const std::vector<Given> fan{{-1, 0.125, 1}, {0, 0.5, 0}, {0, 0.5, 0},   {0, 0.5, 0},
                               {0, 0.5, 0},    {0, 0.5, 0}, {1, 0.875, -1}};
  expectAtMost("segments, in float", worstOfAllOrders<FloatLane, 7>(fan, {{0.125, 0.5, 1}, {0.5, 0.875, 1}}, 0), 0);
}

/// A field that jumps where the two boxes of twoBoxes(n, 0) touch.
TetMesh touchingBoxes(int n) {
  TetMesh mesh = twoBoxes(n, 0);
  const std::size_t half = mesh.points.size() / 2;  // the second box's come behind
  std::vector<double> values(mesh.points.size());
  for (std::size_t i = 0; i < values.size(); ++i)
    values[i] = (i < half ? 0.25 : 0.7) + 0.2 * mesh.points[i].x - 0.1 * mesh.points[i].y;
  mesh.pointFields = {Field{"s", 1, values}};
  return mesh;
}

TEST_F(Ties, TouchingBoxesOfDifferentScalars) {
  tell({kGroup,
        "the exit from one box and the entry into the other lie at one distance, in either order by rounding: with the "
        "entry first, what lies behind began at the scalar of the box before; off by 0.13 before this was mended",
        "within a part an exit goes before an entry that is nearer by no more than 1e-6 of the radius"});
  for (const Projection projection : {Projection::perspective, Projection::orthographic}) {
    Scene scene = plainScene();
    scene.camera.projection = projection;
    expectEveryWay(scene, touchingBoxes(4));
    scene.camera.azimuth = -70;
    expectEveryWay(scene, touchingBoxes(3));
  }
}

TEST_F(Ties, TouchingBoxesOfCellData) {
  tell({kGroup, "the scalar behind an exit is that of no cell: taken for the next segment's, it showed 0",
        "the entry leaves last, and its cell's scalar is what follows"});
  expectEveryWay(plainScene(), withCellMeans(touchingBoxes(3)));
}

/// The second box of touchingBoxes by a finer grid: no face of one is a face of the other.
TEST_F(Ties, TouchingBoxesThatDoNotMatch) {
  tell({kGroup, "faces of different grids lie in one plane: their distances agree up to rounding only",
        "1e-6 of the radius is more than what distances are rounded by"});
  TetMesh left = twoBoxes(3, 0), right = twoBoxes(4, 0);
  const auto keep = [](TetMesh& mesh, bool second) {
    const std::size_t half = mesh.points.size() / 2;
    std::erase_if(mesh.tetrahedra, [&](const Tetrahedron& t) { return (t[0] >= half) != second; });
    mesh.pointFields = {Field{"s", 1, pointValues(mesh.points, [&](const Vec3& p) {
                                return (second ? 0.7 : 0.25) + 0.2 * p.x - 0.1 * p.y;
                              })}};
  };
  keep(left, false);
  keep(right, true);
  const std::vector<double> behind = right.pointFields[0].values;
  TetMesh both = merged(left, right);
  std::vector<double> values = left.pointFields[0].values;
  values.insert(values.end(), behind.begin(), behind.end());
  both.pointFields = {Field{"s", 1, values}};
  expectEveryWay(plainScene(), both);
}

/// The mesh `copies` times at one place, each on points of its own.
TetMesh copiesOf(const TetMesh& one, int copies) {
  TetMesh all = one;
  for (int copy = 1; copy < copies; ++copy) {
    all = merged(all, one);
    std::vector<double>& values = all.pointFields.at(0).values;
    values.insert(values.end(), one.pointFields[0].values.begin(), one.pointFields[0].values.end());
  }
  return all;
}

TEST_F(Ties, ThreeCopiesOfACell) {
  tell({kGroup,
        "cells that lie three times at one place, on points of their own, give three fragments at each distance",
        "what lies between them has no length, and the inside-count goes to 3: the picture is that of one copy"});
  TetMesh one = singleTetrahedron();
  one.pointFields = {Field{"s", 1, {0.1, 0.4, 0.9, 0.6}}};
  const HardPicture single = expectEveryWay(plainScene(), one), triple = expectEveryWay(plainScene(), copiesOf(one, 3));
  expectSame("reference, three copies against one", single.truth, triple.truth, 0);
}

TEST_F(Ties, ThreeCopiesOfAMesh) {
  tell({kGroup, "an order draws one copy after the other, and k = 6 does not reach from one to the next",
        "the a-buffer is exact; the k-buffers' certificates say in which pixels they are not"});
  const TetMesh one = plainMesh(3);
  HardBounds bounds;
  bounds.late = ~std::size_t{0};
  const HardPicture single = expectEveryWay(plainScene(), one),
                    triple = expectEveryWay(plainScene(), copiesOf(one, 3), bounds);
  expectSame("reference, three copies against one", single.truth, triple.truth, 0);
  expectSame("a-buffer, three copies against one", single.by("a-buffer").image, triple.by("a-buffer").image,
             kSameInAnyUnit);
}

}  // namespace
}  // namespace havs::test
