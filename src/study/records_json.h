#pragma once
// Records as JSON, as runs.jsonl and study.json hold them.
#include <nlohmann/json.hpp>

#include "study/study_report.h"

namespace havs {

nlohmann::ordered_json toJson(const ErrorMeasures& error);  ///< psnr and ssim: null when not finite
nlohmann::ordered_json toJson(const VisitRecord& record);
nlohmann::ordered_json toJson(const SubjectRecord& record);
nlohmann::ordered_json toJson(const ReferenceRecord& record);
nlohmann::ordered_json toJson(const DeviceRecord& record);

/// The inverse. Each throws nlohmann::json::exception for an object that lacks something.
VisitRecord visitFrom(const nlohmann::ordered_json& json);
SubjectRecord subjectFrom(const nlohmann::ordered_json& json);
ReferenceRecord referenceFrom(const nlohmann::ordered_json& json);
DeviceRecord deviceFrom(const nlohmann::ordered_json& json);

/// The lists of study.json: an object a run, an object an effect.
nlohmann::ordered_json runsJson(const StudyReport& report);
nlohmann::ordered_json effectsJson(const StudyReport& report);

/// One line, or `indent` spaces a level; bytes that are not UTF-8 (file names may hold any) are replaced.
std::string textOf(const nlohmann::ordered_json& json, int indent = -1);

}  // namespace havs
