#include "problem.h"
namespace vbgpd::accuracy {
std::span<const Problem> element_problems() { return {}; }
}
