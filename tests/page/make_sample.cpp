// make_study_sample DIR: a made study and its page, to look at while the page's files are changed.
#include <cstdio>

#include "page/study_fixture.h"
#include "study/page.h"

int main(int argc, char** argv) {
  if (argc != 2) return std::fputs("make_study_sample DIR\n", stderr), 2;
  havs::writeStudyPage(havs::test::writeStudyFixture(argv[1]), argv[1]);
}
