#include "mesh/tetgen_run.h"

#define TETLIBRARY
#include <tetgen.h>

#include <algorithm>
#include <new>
#include <string_view>

#include "core/error.h"
#include "core/isolated.h"

namespace havs {
namespace {

// What the child says first: how TetGen ended. The numbers are those that TetGen throws.
constexpr int kDone = 0, kOutOfMemory = 1, kSelfIntersection = 3, kSmallFeature = 4, kCloseFacets = 5, kInputError = 10;
constexpr int kCrash = -1;  // our own: TetGen 1.5 often crashes while it frees what it has, on its way to throw

// TetGen frees what it is given with delete[], so it is made with new[].
template <class T>
T* newArray(std::size_t count) {
  return new T[count]();
}

void copyPositions(const std::vector<Vec3>& from, double* to) {
  for (const Vec3& p : from)
    for (int axis = 0; axis < 3; ++axis) *to++ = p[axis];
}

void setPoints(const Surface& surface, tetgenio& in) {
  in.numberofpoints = static_cast<int>(surface.points.size());
  in.pointlist = newArray<double>(3 * surface.points.size());
  copyPositions(surface.points, in.pointlist);
  const std::size_t fields = surface.pointFields.size();
  if (fields == 0) return;
  in.numberofpointattributes = static_cast<int>(fields);
  in.pointattributelist = newArray<double>(fields * surface.points.size());
  for (std::size_t i = 0; i < surface.points.size(); ++i)
    for (std::size_t f = 0; f < fields; ++f) in.pointattributelist[i * fields + f] = surface.pointFields[f].values[i];
}

void setFacet(const Facet& facet, tetgenio::facet& to) {
  to.numberofpolygons = static_cast<int>(facet.polygons.size());
  to.polygonlist = newArray<tetgenio::polygon>(facet.polygons.size());
  for (std::size_t i = 0; i < facet.polygons.size(); ++i) {
    to.polygonlist[i].numberofvertices = static_cast<int>(facet.polygons[i].size());
    to.polygonlist[i].vertexlist = newArray<int>(facet.polygons[i].size());
    std::ranges::copy(facet.polygons[i], to.polygonlist[i].vertexlist);
  }
  to.numberofholes = static_cast<int>(facet.holes.size());
  to.holelist = facet.holes.empty() ? nullptr : newArray<double>(3 * facet.holes.size());
  copyPositions(facet.holes, to.holelist);
}

void setFacets(const Surface& surface, tetgenio& in) {
  in.numberoffacets = static_cast<int>(surface.facets.size());
  in.facetlist = newArray<tetgenio::facet>(surface.facets.size());
  in.facetmarkerlist = newArray<int>(surface.facets.size());
  for (std::size_t i = 0; i < surface.facets.size(); ++i) {
    setFacet(surface.facets[i], in.facetlist[i]);
    in.facetmarkerlist[i] = surface.facets[i].marker;
  }
}

void setHolesAndRegions(const Surface& surface, tetgenio& in) {
  if (!surface.holes.empty()) {
    in.numberofholes = static_cast<int>(surface.holes.size());
    in.holelist = newArray<double>(3 * surface.holes.size());
    copyPositions(surface.holes, in.holelist);
  }
  if (!surface.regions.empty()) {
    in.numberofregions = static_cast<int>(surface.regions.size());
    in.regionlist = newArray<double>(5 * surface.regions.size());
    double* to = in.regionlist;
    for (const Region& region : surface.regions)
      for (const double value : {region.seed.x, region.seed.y, region.seed.z, region.attribute, region.maxVolume})
        *to++ = value;
  }
}

/// The child: TetGen's arrays go to the parent as they are.
void fill(const Surface& surface, std::string command, ByteWriter& reply) {
  tetgenio in, out;
  setPoints(surface, in);
  setFacets(surface, in);
  setHolesAndRegions(surface, in);
  int code = kDone;
  try {
    ::tetrahedralize(command.data(), &in, &out);
  } catch (int thrown) {
    code = thrown == kDone ? kInputError : thrown;
  } catch (const std::bad_alloc&) {
    code = kOutOfMemory;
  }
  reply.put(code);
  if (code != kDone) return;
  const auto putArray = [&](const auto* values, int count, int each) {
    using T = std::decay_t<decltype(*values)>;
    const std::size_t total = values ? static_cast<std::size_t>(count) * static_cast<std::size_t>(each) : 0;
    reply.put(std::vector<T>(values, values + total));
  };
  reply.put(out.numberofcorners);
  reply.put(out.numberofpointattributes);
  reply.put(out.numberoftetrahedronattributes);
  putArray(out.pointlist, out.numberofpoints, 3);
  putArray(out.tetrahedronlist, out.numberoftetrahedra, out.numberofcorners);
  putArray(out.pointattributelist, out.numberofpoints, out.numberofpointattributes);
  putArray(out.tetrahedronattributelist, out.numberoftetrahedra, out.numberoftetrahedronattributes);
}

/// Column `column` of rows of `columns` values.
Field columnField(const std::string& name, const std::vector<double>& values, std::size_t columns, std::size_t column) {
  Field field{name, 1, {}};
  field.values.reserve(values.size() / columns);
  for (std::size_t i = column; i < values.size(); i += columns) field.values.push_back(values[i]);
  return field;
}

TetMesh receiveMesh(ByteReader& reply, const Surface& surface) {
  const auto corners = static_cast<std::size_t>(reply.get<int>());
  const auto pointAttributes = static_cast<std::size_t>(reply.get<int>());
  const auto regionAttributes = static_cast<std::size_t>(reply.get<int>());
  TetMesh mesh;
  const std::vector<double> positions = reply.getVector<double>();
  mesh.points.resize(positions.size() / 3);
  for (std::size_t i = 0; i < mesh.points.size(); ++i)
    mesh.points[i] = {positions[3 * i], positions[3 * i + 1], positions[3 * i + 2]};
  const std::vector<int> numbers = reply.getVector<int>();
  mesh.tetrahedra.resize(numbers.size() / corners);
  for (std::size_t i = 0; i < mesh.tetrahedra.size(); ++i)
    for (std::size_t c = 0; c < 4; ++c) mesh.tetrahedra[i][c] = static_cast<Index>(numbers[i * corners + c]);
  mesh.sourceCells = mesh.tetrahedra.size();

  const std::vector<double> pointValues = reply.getVector<double>();
  for (std::size_t f = 0; f < std::min(pointAttributes, surface.pointFields.size()); ++f)
    mesh.pointFields.push_back(columnField(surface.pointFields[f].name, pointValues, pointAttributes, f));
  const std::vector<double> regionValues = reply.getVector<double>();
  if (regionAttributes > 0)
    mesh.cellFields.push_back(columnField("region", regionValues, regionAttributes, regionAttributes - 1));
  mesh.notes = surface.notes;
  return mesh;
}

/// The first line of what TetGen printed that names a fault of the surface; empty: none.
std::string faultIn(const std::string& printed) {
  for (const std::string_view sign : {"intersects", "duplicated"}) {
    const std::size_t at = printed.find(sign);
    if (at == std::string::npos) continue;
    const std::size_t begin = printed.find_first_not_of(" \n", printed.rfind('\n', at));
    return printed.substr(begin, printed.find_first_of("\n.:", at) - begin);
  }
  return {};
}

/// "Facet #1 intersects facet #6 at triangles", facets counted from 1: found by TetGen's own search for faults.
std::string searchFault(const Surface& surface) {
  return faultIn(runIsolated([&](ByteWriter& reply) { fill(surface, "pd", reply); }).printed);
}

[[noreturn]] void failWith(int code, std::string fault, const Surface& surface, const std::string& where) {
  if (code == kOutOfMemory) failRunning("TetGen runs out of memory", where, "allow larger tetrahedra (switch a)");
  if (fault.empty()) fault = searchFault(surface);
  if (!fault.empty())
    failInput("the surface intersects itself (TetGen: " + fault + ")", where, "mend it there; facets count from 1");
  switch (code) {
    case kSelfIntersection:
      failInput("the surface intersects itself", where, "mend it where its facets cross");
    case kSmallFeature:
      failInput("the surface has a feature too small for TetGen", where, "try a smaller tolerance, switch T1e-12");
    case kCloseFacets:
      failInput("two facets of the surface are too close to each other", where, "try switch Y, or mend the surface");
    case kInputError:
      failInput("TetGen cannot use the surface", where, "is it closed, and are its facets flat?");
    case kCrash:
      failInput("TetGen breaks down on it", where, "is the surface closed, are its facets flat and far enough apart?");
    default:
      failInput("TetGen fails on it with code " + std::to_string(code), where, "try other switches, Y or T1e-12");
  }
}

}  // namespace

TetMesh runTetgen(const Surface& surface, const std::string& command, const std::string& where) {
  IsolatedRun run = runIsolated([&](ByteWriter& reply) { fill(surface, command, reply); });
  const int code = run.death.empty() ? run.reply.get<int>() : kCrash;
  if (code != kDone) failWith(code, faultIn(run.printed), surface, where);
  TetMesh mesh = receiveMesh(run.reply, surface);
  if (mesh.tetrahedra.empty())
    failInput("the surface encloses nothing, TetGen makes no tetrahedra", where,
              "is it closed, and no hole point too many?");
  return mesh;
}

}  // namespace havs
