// Manufactured solutions: of a smooth field under a smooth transfer function the picture is known without a mesh, by
// quadrature along rays. As a mesh is refined by halving, errors must fall with the order that theory gives.
#include <algorithm>
#include <stdexcept>

#include "hard/orders.h"
#include "render/lookups.h"
#include "support/lookup_names.h"

namespace havs::test {
namespace {

const std::vector<int> kMeshes{4, 8, 16, 32};

TetMesh smoothBox(int n) { return withSmooth(box(n)); }

/// What is expected of a lookup: its order in the width of cells, and why.
struct Expected {
  std::string name;  ///< of the row, without its number
  double order;
  std::string trouble, remedy;
};
const Expected& expectedOf(const std::string& lookup) {
  static const std::vector<Expected> rows{
      {"exact", 2, "segments are integrated exactly; what is left is the field, linear in each cell",
       "interpolation is off by h^2 / 8 times second derivatives: order 2, the best that a mesh of linear cells gives"},
      {"3d", 2, "a table of fixed size has an error of its own, N^-2, that no mesh refines away",
       "with as many entries as cells, twice over, along each axis both errors are of order 2"},
      {"3d-normalised", 2, "mean colours come from a table whose steps stay when cells shrink",
       "opacity is exact; with the table refined as the mesh is, order 2"},
      {"2d", 2,
       "colours of the table's one length are weighted by that length's attenuation, not the segment's: an order is "
       "lost",
       "the table's length is the mean one of the mesh: it shrinks with the cells, and the order is won back: 2"},
      {"integral", 1,
       "light is not attenuated inside its own segment: c (kappa h)^2 / 2 is left out of each of 1/h segments",
       "as theory says of neglected self-attenuation: order 1"},
      {"post", 2, "the trapezoid of extinction and light over a segment is off by h^3 of it",
       "1/h segments: order 2, as the field's own"},
      {"riemann", 2, "the midpoint of a segment stands for all of it, off by h^3 of it",
       "1/h segments: order 2, with one sample each"},
      {"riemann-linear", 1, "1 - exp(-D) is taken as D: D^2 / 2 is too much of each segment",
       "as theory says of opacity that is linear in length: order 1"},
      {"pre", 2, "colours and extinctions of the vertices are interpolated, not scalars",
       "both are smooth in space, so linear interpolation of them is of order 2 as well"},
  };
  const auto row = std::find_if(rows.begin(), rows.end(),
                                [&](const Expected& e) { return e.name == lookup.substr(0, lookup.find(':')); });
  if (row == rows.end()) throw std::invalid_argument("no order is known of the lookup " + lookup);
  return *row;
}

class ConvergenceOfLookup : public Convergence, public testing::WithParamInterface<std::string> {};

TEST_P(ConvergenceOfLookup, InTheWidthOfCells) {
  const Expected& expected = expectedOf(GetParam());
  // One sample a segment: with more, the field's error would hide the sampling's on these meshes.
  const Lookup row = lookup(GetParam());
  const std::string name = row.parameter.empty() ? row.name : row.name.substr(0, row.name.find(':')) + ":1";
  tell({"Convergence", expected.trouble, expected.remedy});
  Scene scene = smoothScene(16);
  const auto draw = [&](const HardPicture& picture, int n) {
    Scene asked = picture.scene;
    asked.lookup = name;
    asked.tableSize = 2 * n;
    return drawIn(kNative, asked, picture.prepared, picture.view).image;
  };
  const auto norms = errorsOn(kMeshes, smoothBox, scene, boxRay, smoothVolume, draw);
  expectOrders({name, expected.order}, widths(kMeshes), norms);
}

INSTANTIATE_TEST_SUITE_P(Lookups, ConvergenceOfLookup, testing::ValuesIn(lookupNames()),
                         [](const auto& row) { return testName(row.param); });

TEST_F(Convergence, QuadratureItself) {
  tell({"Convergence", "errors measured against a wrong truth fall to its own error and no further",
        "the quadrature agrees with itself at twice the panels, and with closed forms of a constant and of a linear "
        "field"});
  const HardPicture picture(smoothScene(16), smoothBox(1));
  double most = 0;
  for (int y = 0; y < 16; ++y)
    for (int x = 0; x < 16; ++x) {
      const BodyRay ray = boxRay(picture, x, y);
      const Along smooth = [&](double t) { return smoothTransfer(smoothScalar(ray.at(t))); };
      const RayColor a = quadrature(smooth, ray.first, ray.last), b = quadrature(smooth, ray.first, ray.last, 8);
      for (std::size_t c = 0; c < 4; ++c) most = std::max(most, std::abs(a[c] - b[c]));
    }
  expectAtMost("4 panels against 8", most, 1e-13);
  const RayColor plain = quadrature([](double) { return std::array{0.3, 0.6, 0.9, 2.0}; }, 0, 1.5);
  expectAtMost("constant, against closed form", std::abs(plain[1] - 0.6 * -std::expm1(-3.0)), 1e-15);
  // Extinction 2t: light of a colour that is 1 is 1 - exp(-t^2).
  const RayColor ramp = quadrature([](double t) { return std::array{1.0, 1.0, 1.0, 2 * t}; }, 0, 1.5);
  expectAtMost("linear, against closed form", std::abs(ramp[0] - -std::expm1(-2.25)), 1e-14);
}

TEST_F(Convergence, OfTheReference) {
  tell({"Convergence", "the ground truth is that of the mesh's field, not of the field that was sampled on it",
        "its distance from the smooth field's picture is that of linear interpolation: order 2, in every norm"});
  const auto draw = [](const HardPicture& picture, int) { return picture.truth; };
  expectOrders({"reference", 2, true}, widths(kMeshes),
               errorsOn(kMeshes, smoothBox, smoothScene(16), boxRay, smoothVolume, draw));
}

TEST_F(Convergence, OnIrregularCells) {
  tell({"Convergence",
        "on a regular mesh errors of neighbouring cells may cancel, so that an order is seen that is not there",
        "points moved by up to a quarter of an edge: the order stays 2"});
  const auto make = [](int n) { return withSmooth(box(n, Cut::six, 0.25, 5)); };
  const auto draw = [](const HardPicture& picture, int) {
    return drawIn(kNative, picture.scene, picture.prepared, picture.view).image;
  };
  expectOrders({"exact, moved points"}, widths(kMeshes),
               errorsOn(kMeshes, make, smoothScene(16), boxRay, smoothVolume, draw));
}

TEST_F(Convergence, OnACurvedBody) {
  tell({"Convergence",
        "flat faces cut off a ball's rim: the body itself is off by h^2, and chords near the silhouette by h",
        "order 2 in the mean; the maximum, at the silhouette, falls with no such order and is not bounded"});
  const std::vector<int> meshes{4, 8, 16};
  const auto make = [](int n) { return withSmooth(ball(n)); };
  const auto draw = [](const HardPicture& picture, int) {
    return drawIn(kNative, picture.scene, picture.prepared, picture.view).image;
  };
  expectOrders({"exact, ball", 2, true, false, false}, widths(meshes),
               errorsOn(meshes, make, smoothScene(32), ballRay, smoothVolume, draw));
}

TEST_F(Convergence, OnOpenGl) {
  tell({"Convergence",
        "OpenGL's pictures carry the rasteriser's grid, which no mesh refines away, and may hide an order",
        "outside the edge mask it is far below these errors: the orders are those of the native device"});
  const std::vector<int> meshes{4, 8, 16};
  for (const std::string lookup : {"exact", "post", "integral", "pre"}) {
    std::vector<Norms> norms;
    for (const int n : meshes) {
      const HardPicture picture(smoothScene(24), smoothBox(n));
      Scene asked = picture.scene;
      asked.lookup = lookup;
      norms.push_back(normsOf(drawIn(kOpenGl, asked, picture.prepared, picture.view).image,
                              seen(picture, boxRay, smoothVolume),
                              boundaryEdgeMask(picture.prepared.points, picture.prepared.faces, picture.view)));
    }
    expectOrders({lookup, expectedOf(lookup).order, false, true, false}, widths(meshes), norms);
  }
}

}  // namespace
}  // namespace havs::test
