// The same transcript by a C++ compiler.
#include "transcript.c"
