// A study's runs.jsonl: opened, it goes on where whole lines of it end.
#include "fuzz/fuzz.h"
#include "study/records_json.h"
#include "study/store.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace havs;
  const auto file = fuzz::asFile("runs.jsonl", fuzz::textOf(data, size));
  fuzz::readOrRefuse([&] {
    const StudyStore store(file.parent_path(), {{"mesh", "m"}}, false);
    for (const VisitRecord& visit : store.records().visits) textOf(toJson(visit));
    for (const SubjectRecord& subject : store.records().subjects) textOf(toJson(subject));
    for (const ReferenceRecord& reference : store.records().references) textOf(toJson(reference));
  });
  fuzz::readOrRefuse([&] { const StudyStore again(file.parent_path(), {{"mesh", "m"}}, false); });
  return 0;
}
