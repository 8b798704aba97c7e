// Versions and the names of the status codes: constants only.
#include "guard.h"

int32_t vbgpd_version_number(void) { return VBGPD_VERSION_NUMBER; }
int32_t vbgpd_abi_version(void) { return VBGPD_ABI_VERSION; }
const char* vbgpd_version_string(void) { return VBGPD_VERSION_STRING; }

const char* vbgpd_status_name(vbgpd_status s) {
  switch (s) {
    case VBGPD_OK:
      return "VBGPD_OK";
    case VBGPD_CANCELLED:
      return "VBGPD_CANCELLED";
    case VBGPD_LIMIT_REACHED:
      return "VBGPD_LIMIT_REACHED";
    case VBGPD_NOT_CONVERGED:
      return "VBGPD_NOT_CONVERGED";
    case VBGPD_UNSTABLE:
      return "VBGPD_UNSTABLE";
    case VBGPD_END_OF_DATA:
      return "VBGPD_END_OF_DATA";
    case VBGPD_E_ARGUMENT:
      return "VBGPD_E_ARGUMENT";
    case VBGPD_E_HANDLE:
      return "VBGPD_E_HANDLE";
    case VBGPD_E_MEMORY:
      return "VBGPD_E_MEMORY";
    case VBGPD_E_LIMIT:
      return "VBGPD_E_LIMIT";
    case VBGPD_E_BUSY:
      return "VBGPD_E_BUSY";
    case VBGPD_E_LEASED:
      return "VBGPD_E_LEASED";
    case VBGPD_E_REENTRANT:
      return "VBGPD_E_REENTRANT";
    case VBGPD_E_STATE:
      return "VBGPD_E_STATE";
    case VBGPD_E_GEOMETRY:
      return "VBGPD_E_GEOMETRY";
    case VBGPD_E_UNKNOWN_NAME:
      return "VBGPD_E_UNKNOWN_NAME";
    case VBGPD_E_RANGE:
      return "VBGPD_E_RANGE";
    case VBGPD_E_BUFFER:
      return "VBGPD_E_BUFFER";
    case VBGPD_E_FORMAT:
      return "VBGPD_E_FORMAT";
    case VBGPD_E_VERSION:
      return "VBGPD_E_VERSION";
    case VBGPD_E_DIVERGED:
      return "VBGPD_E_DIVERGED";
    case VBGPD_E_UNSUPPORTED:
      return "VBGPD_E_UNSUPPORTED";
    case VBGPD_E_INTERNAL:
      return "VBGPD_E_INTERNAL";
    default:
      return "unknown status";
  }
}
