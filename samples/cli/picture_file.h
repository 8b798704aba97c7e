// From the engine's fields to a picture file.
#pragma once

#include <string>

#include "engine.h"
#include "fos_result.h"
#include "picture/sheet.h"
#include "scene_file.h"

namespace cli {

/// Throws BadInput unless the name ends in .svg, .png or .pdf and such a file can be written there. Leaves no file
/// behind.
void require_writable_picture(const std::string& file);

/// Everything that is drawn, gathered from the scene, the model in its failing state and the result.
picture::Sheet picture_sheet(const Scene& scene, const vbgpd_model* model, const FosResult& result);

/// The section of a scene alone: outline, soils, supports, loads.
picture::Sheet section_sheet(const Scene& scene);

/// Throws BadInput when the file cannot be written after all.
void write_picture(const picture::Sheet& sheet, const std::string& file);

}  // namespace cli
