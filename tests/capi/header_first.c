/* The header stands alone, first and twice, in C99; header_second.c includes it as well and is linked to this. */
#include "vbgpd/vbgpd.h"

int second_abi(void);

/* C99 has no static assertion; an array of negative size is one. Structs without pointers are the same everywhere. */
#define HAS_SIZE(type, size) typedef char type##_has_another_size[sizeof(type) == (size) ? 1 : -1]
HAS_SIZE(vbgpd_error_info, 56);
HAS_SIZE(vbgpd_context_desc, 56);
HAS_SIZE(vbgpd_log_line, 24);
HAS_SIZE(vbgpd_memory, 64);
HAS_SIZE(vbgpd_progress, 72);
HAS_SIZE(vbgpd_advance_result, 72);
HAS_SIZE(vbgpd_trial, 80);
HAS_SIZE(vbgpd_level, 120);

int main(void) { return vbgpd_abi_version() == second_abi() ? 0 : 1; }
