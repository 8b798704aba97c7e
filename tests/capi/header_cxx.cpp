// The header in C++11, and one call through it.
#include "vbgpd/vbgpd.h"

int main() {
  vbgpd_context* context = nullptr;
  if (vbgpd_context_create(nullptr, &context) != VBGPD_OK) return 1;
  return vbgpd_context_destroy(context) == VBGPD_OK ? 0 : 1;
}
