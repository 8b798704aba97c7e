/* A host program: the library it meets at run time is the one of its header. */
#include <vbgpd/vbgpd.h>

int main(void) {
  vbgpd_context* context = 0;
  if (vbgpd_version_number() != VBGPD_VERSION_NUMBER) return 1;
  if (vbgpd_context_create(0, &context) != VBGPD_OK) return 2;
  if (vbgpd_model_create(context, 0, 0) >= 0) return 4; /* refused, but linked with all it would need */
  return vbgpd_context_destroy(context) == VBGPD_OK ? 0 : 3;
}
