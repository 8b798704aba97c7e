/* A host program: the library it meets at run time is the one of its header. */
#include <vbgpd/vbgpd.h>

int main(void) {
  vbgpd_context* context = 0;
  if (vbgpd_version_number() != VBGPD_VERSION_NUMBER) return 1;
  if (vbgpd_context_create(0, &context) != VBGPD_OK) return 2;
  return vbgpd_context_destroy(context) == VBGPD_OK ? 0 : 3;
}
