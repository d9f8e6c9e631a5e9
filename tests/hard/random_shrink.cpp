// Delta debugging (Zeller, Hildebrandt 2002) of a case's three parts, each change kept if the case still fails.
//
// RapidCheck (librapidcheck-dev) was looked at. It shrinks what a generator drew: with a smaller grid the mesh is made
// anew and the coordinates that failed are gone. Candidates for values have to be written either way, and they are
// nearly all of this file; what it would add is the walk among them (findLocalMin) and chunks (removeChunks). What the
// runs need besides it has in no public header: to run for a time, to go on after a failure, to bound the tries, and a
// case as files.
#include "hard/random_shrink.h"

#include <algorithm>
#include <cmath>

#include "mesh/weld.h"

namespace havs::test {
namespace {

using Json = nlohmann::ordered_json;

double rounded(double value, int digits) {
  if (value == 0 || !std::isfinite(value)) return value;
  const double unit = std::pow(10, std::floor(std::log10(std::abs(value))) - digits + 1);
  return std::round(value / unit) * unit;
}

/// Simpler numbers than `value`, the simplest first.
std::vector<double> simpler(double value) {
  std::vector<double> numbers;
  for (const double candidate :
       {0.0, 1.0, 0.5, std::round(value), rounded(value, 1), rounded(value, 2), rounded(value, 3)}) {
    if (candidate == value) break;
    numbers.push_back(candidate);
  }
  return numbers;
}

class Shrinker {
 public:
  Shrinker(RandomCase c, const Fails& fails, int mostTries) : case_(std::move(c)), fails_(fails), left_(mostTries) {}

  RandomCase run() {
    bool smaller = true;
    while (smaller && left_ > 0) {
      smaller = dropCells();
      smaller = dropEntries(case_.scene) || smaller;
      smaller = dropEntries(case_.transfer["points"]) || smaller;
      smaller = shrinkPicture() || smaller;
      smaller = simplifyNumbers(case_.scene) || smaller;
      smaller = simplifyNumbers(case_.transfer) || smaller;
      smaller = simplifyMesh() || smaller;
    }
    return case_;
  }

 private:
  /// Keeps `next` if it fails, too.
  bool keep(const RandomCase& next) {
    if (left_ <= 0) return false;
    --left_;
    if (!fails_(next)) return false;
    case_ = next;
    return true;
  }

  bool dropCells() {
    bool any = false;
    for (std::size_t chunk = case_.mesh.tetrahedra.size() / 2; chunk > 0; chunk /= 2)
      for (std::size_t first = 0; first < case_.mesh.tetrahedra.size();)
        if (dropCells(first, std::min(first + chunk, case_.mesh.tetrahedra.size())))
          any = true;
        else
          first += chunk;
    return dropPoints() || any;
  }

  bool dropCells(std::size_t first, std::size_t last) {
    RandomCase next = case_;
    if (last - first == next.mesh.tetrahedra.size()) return false;
    const auto erase = [&](auto& values) {
      values.erase(values.begin() + static_cast<std::ptrdiff_t>(first),
                   values.begin() + static_cast<std::ptrdiff_t>(last));
    };
    erase(next.mesh.tetrahedra);
    for (Field& field : next.mesh.cellFields) erase(field.values);
    next.mesh.sourceCells = next.mesh.tetrahedra.size();
    return keep(next);
  }

  bool dropPoints() {
    RandomCase next = case_;
    std::vector<char> used(next.mesh.points.size());
    for (const Tetrahedron& cell : next.mesh.tetrahedra)
      for (const Index i : cell) used[i] = 1;
    if (std::count(used.begin(), used.end(), 0) == 0) return false;
    const std::vector<Index> numbers = keepPoints(used, next.mesh.points, next.mesh.pointFields);
    for (Tetrahedron& cell : next.mesh.tetrahedra)
      for (Index& i : cell) i = numbers[i];
    return keep(next);
  }

  /// Entries of a list or an object of the case, and within them.
  bool dropEntries(Json& entries) {
    bool any = false;
    for (std::size_t i = entries.size(); i-- > 0;) {
      Json& at = nth(entries, i);
      if (at.is_object() || (at.is_array() && !at.empty() && at[0].is_object())) any = dropEntries(at) || any;
      const Json before = entries;
      if (entries.is_array())
        entries.erase(i);
      else
        entries.erase(keyOf(entries, i));
      any = stays(entries, before) || any;
    }
    return any;
  }

  static Json& nth(Json& entries, std::size_t i) {
    auto at = entries.begin();
    std::advance(at, i);
    return *at;
  }
  static std::string keyOf(const Json& entries, std::size_t i) {
    auto at = entries.begin();
    std::advance(at, i);
    return at.key();
  }

  /// After a change of a part of the case in place: keeps it, or puts back what it was.
  bool stays(Json& part, const Json& before) {
    if (left_ > 0) {
      --left_;
      if (fails_(case_)) return true;
    }
    part = before;
    return false;
  }

  bool shrinkPicture() {
    for (const int side : {1, 2, 4, 8, 12, 16}) {
      if (case_.scene.contains("size") && case_.scene["size"][0] <= side && case_.scene["size"][1] <= side)
        return false;
      RandomCase next = case_;
      next.scene["size"] = {side, side};
      if (keep(next)) return true;
    }
    return false;
  }

  bool simplifyNumbers(Json& json) {
    bool any = false;
    if (json.is_structured()) {
      for (auto& [key, value] : json.items())
        if (key != "size" && key != "version") any = simplifyNumbers(value) || any;
      return any;
    }
    if (!json.is_number_float()) return false;
    for (const double number : simpler(json.get<double>())) {
      const Json before = json;
      json = number;
      if (stays(json, before)) return true;
    }
    return false;
  }

  bool simplifyMesh() {
    bool any = false;
    for (const int digits : {1, 2, 3, 5}) {
      RandomCase next = case_;
      for (Vec3& p : next.mesh.points)
        for (int axis = 0; axis < 3; ++axis) p[axis] = rounded(p[axis], digits);
      if (next.mesh.points != case_.mesh.points && keep(next)) any = true;
    }
    for (std::size_t i = 0; i < case_.mesh.points.size(); ++i)
      for (int axis = 0; axis < 3; ++axis)
        any = simplify([&](RandomCase& c) -> double& { return c.mesh.points[i][axis]; }) || any;
    for (auto fields : {&TetMesh::pointFields, &TetMesh::cellFields})
      for (std::size_t i = 0; !(case_.mesh.*fields).empty() && i < (case_.mesh.*fields)[0].values.size(); ++i)
        any = simplify([&](RandomCase& c) -> double& { return (c.mesh.*fields)[0].values[i]; }) || any;
    return any;
  }

  template <class NumberOf>
  bool simplify(const NumberOf& numberOf) {
    for (const double number : simpler(numberOf(case_))) {
      RandomCase next = case_;
      numberOf(next) = number;
      if (keep(next)) return true;
    }
    return false;
  }

  RandomCase case_;
  const Fails& fails_;
  int left_;
};

}  // namespace

RandomCase shrunk(RandomCase c, const Fails& fails, int mostTries) {
  return Shrinker(std::move(c), fails, mostTries).run();
}

}  // namespace havs::test
