#include "problem.h"
namespace vbgpd::accuracy {
std::span<const Problem> wave_problems() { return {}; }
}
