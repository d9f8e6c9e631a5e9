#pragma once
#include <functional>
#include <string>
#include <vector>

#include "light/light_plan.h"
#include "render/lookups.h"
#include "render/modes.h"
#include "render/plan_item.h"
#include "render/target_formats.h"
#include "render/visibility.h"
#include "scene/scene.h"
#include "scene/shown_scalars.h"

namespace havs {

/// What the machine can do, as far as plans depend on it.
struct Capabilities {
  bool native = false;  ///< the native device: no OpenGL, nothing below matters
  std::function<bool(const std::string&)> hasExtension;
  int maximumDrawBuffers = 8;
  int maximumTextureSize = 16384;
  int maximum3dTextureSize = 512;
  std::size_t maximumBufferTexels = std::size_t{1} << 16;  ///< of a buffer texture
  std::size_t maximumStorageBlock = std::size_t{1} << 24;  ///< bytes of a storage buffer that a shader sees
};

/// A name and value that a shader is compiled with.
struct ShaderDefine {
  std::string name;
  std::string value;
};

/// What has to run to draw a scene, and nothing else. The renderer has no other source of decisions; the device, which
/// is not its own, is chosen by its name in the scene.
struct RenderPlan {
  /// All that is run, built and kept, with its reason.
  std::vector<PlanItem> items;
  std::vector<PlannedProgram> programs;  ///< the only ones that are compiled

  bool native = false;         ///< drawn by the native device
  std::string instructionSet;  ///< of the native device: row of instructionSets()
  std::string mode;            ///< row of modes()
  Gathering gathering = Gathering::composite;
  std::array<float, 4> start{0, 0, 0, 0};                                ///< Mode::start
  void (*finish)(const ExtinctionCurve& curve, float* pixel) = nullptr;  ///< Mode::finish
  DrawingWay way;                                                        ///< what draws
  WhatShows shows;                                                       ///< of the scene
  bool leavesOutCells = false;                                           ///< those that show nothing of that
  VisibilityMethod visibility;                                           ///< of Gathering::composite
  std::string ordering;  ///< the extension that keeps a pixel's reads and writes in order; empty: none is needed
  std::string sort;      ///< row of sortMethods(); empty: faces need no order
  Lookup lookup;
  std::vector<LookupResource> resources;  ///< all that shaders read besides the segment
  TableFormat tableFormat;
  int tableSize = 0;
  int k = 0;
  std::vector<ShaderDefine> defines;
  TargetFormat targetFormat;      ///< of the k-buffer's targets
  int entryTargets = 0;           ///< k-buffer entries, beside the colour target
  int bytesPerPixel = 0;          ///< of all targets
  std::size_t mostFragments = 0;  ///< a-buffer: stored at once
  int tileWidth = 0;              ///< the picture is drawn in tiles of at most this size
  int tileHeight = 0;
  double earlyTermination = 0;
  LightPlan light;
  bool cellData = false;
  bool opaqueSurfaces = false;
  bool isosurfaces = false;
  bool opaqueIsosurfaces = false;  ///< some of them: nothing is seen behind
  Overlays overlays;
  bool layers = false;        ///< some of these are RayLayers, which the renderer composites
  bool opaqueLayers = false;  ///< of which some are opaque all over: nothing is seen behind
  bool certificate = false;
  bool marksDonePixels = false;  ///< k-buffer: a stencil spares pixels that take no more fragments
  bool flagsLate = false;  ///< k-buffer: whether any fragment is late is looked at, as a better order might be had
  bool compositeLate = false;
  bool speculate = true;  ///< native device: believes the order first, pixel by pixel proven; off: to test that
};

/// Adds an item to a plan; for the parts of plans. `of` and `count`: see PlanItem; bytes = count * bytesEach.
void addItem(RenderPlan& plan, PlanKind kind, const std::string& name, const std::string& stage,
             const std::string& reason, std::size_t bytesEach = 0, const std::string& of = "", std::size_t count = 1);
/// Adds a row of lookupResources() that the plan has not got yet, and its item; where it has a table, the table's size
/// and format. Throws Error{running} for a table larger than the machine's textures.
void addResource(RenderPlan& plan, const std::string& name, const std::string& reason, const Scene& scene,
                 const Capabilities& capabilities);
/// Adds a program, and its item. `options`: what it is compiled with besides the plan's defines.
void addProgram(RenderPlan& plan, const std::string& role, const std::string& vertex, const std::string& fragment,
                const std::string& reason, const ShaderOptions& options);
/// Throws Error{running} for a role that the plan has not: a renderer compiles nothing else.
const PlannedProgram& programOf(const RenderPlan& plan, const std::string& role);

/// A pure function: the plan for a scene on a machine. Throws Error{input} for values that no method takes (k, table
/// size, picture size), Error{running} when the machine lacks what the method needs.
RenderPlan plan(const Scene& scene, const SceneFacts& facts, const Capabilities& capabilities);

/// The part of plan's checks that needs neither mesh nor machine: names and ranges. Throws Error{input}.
void checkScene(const Scene& scene);

/// What Scene::lookup `auto` stands for: `exact`, which needs no table and is right to float's rounding, where segments
/// cross few knots (SceneFacts::knotsInCells); else `3d-normalised`, whose time does not depend on them.
std::string lookupFor(double knotsInCells);
/// Whether to go from knot to knot pays: at most two a cell.
bool fewKnots(double knotsInCells);
/// The row of the scene's lookup; of `auto` one that carries the same. Of a mode that has a lookup of its own, that.
Lookup lookupOf(const Scene& scene);

/// Entries along each axis of the table of the scene's lookup: those asked for, else the lookup's own
/// (LookupResource::ownSize); 0 for a lookup without a table. Throws Error{input} for an unknown lookup.
int tableSizeOf(const Scene& scene);

/// How many k-buffer entries share a target: two that carry a scalar alone, else one.
int entriesPerTarget(Payload carries);

/// The largest k that the scene's visibility method takes on a machine; 0 for a method without k.
int largestK(const Scene& scene, const Capabilities& capabilities);

/// Halves the longer side of the tile until `bytesPerPixel` of its targets fit into memory and the machine's limits:
/// for a method's part of the plan. `mostPixels`: a limit of the method's own;
/// by default a count of each pixel fits into a storage block of 128 MiB.
void chooseTile(RenderPlan& plan, const Scene& scene, const Capabilities& capabilities,
                std::size_t mostPixels = std::size_t{1} << 25);

/// Names of the visibility methods for which `property` holds, for messages.
std::string methodsWith(bool VisibilityMethod::*property);

/// Throws Error{input} unless least <= value <= most.
void checkRange(double value, double least, double most, const std::string& name);

}  // namespace havs
