/* Assertions for the C tests: a failed one names its place and ends the test. */
#ifndef VBGPD_TESTS_CHECK_H
#define VBGPD_TESTS_CHECK_H
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "vbgpd/vbgpd.h"

#define CHECK(condition)                                                        \
  do {                                                                          \
    if (!(condition)) {                                                         \
      fprintf(stderr, "%s:%d: not true: %s\n", __FILE__, __LINE__, #condition); \
      exit(1);                                                                  \
    }                                                                           \
  } while (0)

#define CHECK_STATUS(expected, call)                                                              \
  do {                                                                                            \
    const vbgpd_status is_ = (call), should_ = (expected);                                        \
    if (is_ != should_) {                                                                         \
      fprintf(stderr, "%s:%d: %s, expected %s: %s\n", __FILE__, __LINE__, vbgpd_status_name(is_), \
              vbgpd_status_name(should_), #call);                                                 \
      exit(1);                                                                                    \
    }                                                                                             \
  } while (0)

#define CHECK_OK(call) CHECK_STATUS(VBGPD_OK, call)

/* The text holds a part. */
#define CHECK_CONTAINS(text, part)                                                             \
  do {                                                                                         \
    if (strstr((text), (part)) == NULL) {                                                      \
      fprintf(stderr, "%s:%d: \"%s\" is not in \"%s\"\n", __FILE__, __LINE__, (part), (text)); \
      exit(1);                                                                                 \
    }                                                                                          \
  } while (0)

#endif
