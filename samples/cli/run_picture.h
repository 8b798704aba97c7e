// A picture of soil in motion.
#pragma once

#include "picture/sheet.h"
#include "run_result.h"
#include "scene_file.h"

namespace cli {

picture::Sheet run_sheet(const Scene& scene, const vbgpd_model* model, const RunResult& result);

}  // namespace cli
