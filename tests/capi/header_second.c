/* Second translation unit of header_first.c. */
#include "vbgpd/vbgpd.h"

int second_abi(void);
int second_abi(void) { return VBGPD_ABI_VERSION; }
