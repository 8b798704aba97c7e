// Where "base", "left" and "right" are on the outline of a section.
#pragma once

#include <string>

#include "picture/sheet.h"

namespace cli {

/// The line of that side: base from the lowest left to the lowest right corner along the underside, left and right the
/// vertical edges at the ends of the section. Empty when the outline has no such side.
picture::Polyline side_of(const picture::Polyline& exterior, const std::string& side);

}  // namespace cli
