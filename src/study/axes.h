#pragma once
// The table of axes: what a study varies. A new kind of setting is one row here.
#include <span>
#include <string>
#include <vector>

#include "scene/scene.h"

namespace havs {

/// One row of the table (`--axis`).
struct StudyAxis {
  std::string name;      ///< as on the command line; in JSON with '_' for '-'
  std::string title;     ///< for people
  bool ordered = false;  ///< values are numbers
  /// Another axis whose values change what this one means: the axis is swept for each of them, where it applies. Empty:
  /// none.
  std::string across;
  bool changesPicture = false;  ///< pictures of different values cannot be compared: each needs a reference of its own
  /// What is swept when nothing else is asked for; those of a table of methods are its rows. `quick`: fewer.
  std::vector<std::string> (*values)(bool quick) = nullptr;
  /// Makes the scene one with this value. Throws Error{input} for a text that is no value.
  void (*apply)(Scene& scene, const std::string& value) = nullptr;
  /// What the scene has, also where that is a default of its other settings (a table's size). Only where it applies.
  std::string (*valueOf)(const Scene& scene) = nullptr;
  /// Whether the setting has any effect on this scene (k only where the method knows one, ...).
  bool (*applies)(const Scene& scene) = nullptr;
};
std::span<const StudyAxis> axes();
/// Throws Error{input}, naming the nearest.
const StudyAxis& axis(const std::string& name);

/// An axis and the values to be swept.
struct AxisChoice {
  const StudyAxis* axis = nullptr;
  std::vector<std::string> values;
};

/// The axes of `--axis NAME` and `--axis NAME=VALUE,VALUE,...`, each once, values each once; all rows with their own
/// values for an empty list. Throws Error{input}: unknown axis (names the nearest), a text that is no value.
std::vector<AxisChoice> chooseAxes(std::span<const std::string> texts, bool quick);

/// Two scenes have one key if and only if they are drawn in the same way: settings without effect are left out.
std::string settingsKey(const Scene& scene);

/// The settings in a few words: "kbuffer k 6, topological, 3d-normalised 64^3 rgba32f".
std::string settingsLabel(const Scene& scene);

}  // namespace havs
