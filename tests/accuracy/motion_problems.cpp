#include "problem.h"
namespace vbgpd::accuracy {
std::span<const Problem> motion_problems() { return {}; }
}
