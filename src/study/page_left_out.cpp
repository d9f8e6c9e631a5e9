// In place of the page where the build leaves it out.
#include "core/error.h"
#include "study/page.h"

namespace havs {

bool hasStudyPage() { return false; }

StudyPage writeStudyPage(const nlohmann::json&, const std::filesystem::path& folder, std::uintmax_t) {
  failRunning("this build of havs has no page for a study", folder.string(), "configure with -DHAVS_WITH_REPORT=ON");
}

StudyPage rewriteStudyPage(const std::filesystem::path& folder) { return writeStudyPage({}, folder, 0); }

}  // namespace havs
