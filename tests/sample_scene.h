// A scene of samples/scenes by its name.
#pragma once

#include <fstream>
#include <sstream>
#include <string>

#include "exchange/scene_buffer.h"
#include "exchange/scene_text.h"

namespace vbgpd {

inline SceneDef sample_scene(const std::string& name) {
  std::string path = VBGPD_SCENES_DIR;
  path.append("/").append(name).append(".json");
  std::ifstream file(path);
  std::stringstream text;
  text << file.rdbuf();
  return scene_from_flatbuffer(scene_text_to_flatbuffer(text.str(), path));
}

}  // namespace vbgpd
