/* What a build says about itself. */
#include "slope.h"

static const char* fact(const char* key) {
  static char text[200];
  int64_t needed = -1;
  CHECK_OK(vbgpd_build_info(key, VBGPD_STRLEN, text, sizeof text, &needed));
  CHECK(needed == (int64_t)strlen(text) && needed > 0);
  return text;
}

int main(void) {
  static const char* const keys[] = {"version",
                                     "abi_version",
                                     "compiler",
                                     "build_type",
                                     "cgal",
                                     "flatbuffers",
                                     "instruction_sets",
                                     "instruction_set",
                                     "instruction_set_runout",
                                     "cores",
                                     "checkpoint_format",
                                     "snapshot_format"};
  char all[2000], line[300], text[4] = "***", used[50];
  int64_t needed = -1;
  size_t i, listed = 0;
  CHECK_OK(vbgpd_build_info(NULL, 0, all, sizeof all, &needed));
  CHECK(needed == (int64_t)strlen(all) && all[needed - 1] == '\n');
  for (i = 0; all[i]; ++i) listed += all[i] == '\n';
  CHECK(listed == sizeof keys / sizeof keys[0]); /* all are named here and documented in the header */
  for (i = 0; i < listed; ++i) {
    CHECK(sprintf(line, "%s = %s\n", keys[i], fact(keys[i])) > 0);
    CHECK_CONTAINS(all, line);
  }
  CHECK(strcmp(fact("version"), vbgpd_version_string()) == 0);
  CHECK(strcmp(fact("flatbuffers"), WITH_FLATBUFFERS ? "yes" : "no") == 0);
  CHECK(strcmp(fact("cgal"), WITH_CGAL ? "yes" : "no") == 0);
  CHECK(atoi(fact("cores")) >= 1);
  strcpy(used, fact("instruction_set"));
  CHECK_CONTAINS(fact("instruction_sets"), used);
  CHECK_STATUS(VBGPD_E_UNKNOWN_NAME, vbgpd_build_info("git", 3, text, 4, &needed));
  CHECK_STATUS(VBGPD_E_ARGUMENT, vbgpd_build_info(NULL, 3, text, 4, &needed));
  CHECK_STATUS(VBGPD_E_ARGUMENT, vbgpd_build_info("cgal", 4, NULL, 4, &needed));
  CHECK_STATUS(VBGPD_E_ARGUMENT, vbgpd_build_info("cgal", 4, text, -1, &needed));
  CHECK_STATUS(VBGPD_E_BUFFER, vbgpd_build_info("compiler", 8, text, 4, &needed));
  CHECK(needed > 4 && strcmp(text, "***") == 0);
  CHECK_OK(vbgpd_build_info("compiler", 8, NULL, 0, NULL));
  return 0;
}
