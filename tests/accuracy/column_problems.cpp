#include "problem.h"
namespace vbgpd::accuracy {
std::span<const Problem> column_problems() { return {}; }
}
