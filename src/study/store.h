#pragma once
#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "study/records.h"

namespace havs {

/// Everything that a study has measured so far.
struct StudyRecords {
  std::vector<SubjectRecord> subjects;
  std::vector<ReferenceRecord> references;
  std::vector<VisitRecord> visits;
  DeviceRecord device;
  std::string created;  ///< when the study was begun, UTC, ISO 8601
};

/// What a study is: a stored one goes on only with the same.
using StudyIdentity = std::map<std::string, std::string>;

/// FOLDER/runs.jsonl: one JSON object a line, appended and flushed to disk one after the other, so that an interruption
/// loses at most what was being measured. Held by one process at a time.
class StudyStore {
 public:
  /// Makes the folder, and images/ in it, where they are not there, opens the file and reads what it holds; a last line
  /// that is not whole is dropped. `restart`: begins anew. Throws Error{input}: the folder cannot be written, another
  /// process holds it, its study has another identity (says in what), a line that is damaged.
  StudyStore(const std::filesystem::path& folder, const StudyIdentity& identity, bool restart);
  ~StudyStore();
  StudyStore(const StudyStore&) = delete;
  StudyStore& operator=(const StudyStore&) = delete;

  const StudyRecords& records() const { return records_; }

  /// Each keeps the record and appends it. Throws Error{running} (disk full, ...).
  void add(const SubjectRecord& record);
  void add(const ReferenceRecord& record);
  /// Nothing where there is one of its subject and size.
  void addIfNew(const ReferenceRecord& record);
  void add(const VisitRecord& record);
  void add(const DeviceRecord& record);

 private:
  void begin(const StudyIdentity& identity);
  void append(const std::string& line);
  /// To who interrupts the study.
  void tellKept() const;

  std::filesystem::path file_;
  int descriptor_ = -1;
  StudyRecords records_;
};

}  // namespace havs
