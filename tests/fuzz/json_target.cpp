// A scene as text: refused with a place, or a flatbuffer that is read as a scene.
#include "exchange/scene_buffer.h"
#include "exchange/scene_text.h"
#include "target.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  try {
    const std::string_view text{reinterpret_cast<const char*>(data), size};
    const auto scene = vbgpd::read_scene_text(text, "fuzz");
    std::vector<std::string> issues;
    for (const auto& fault : scene.faults) issues.push_back("scene: " + fault.path);
    vbgpd::issue_positions(issues, text);
    if (!scene.bytes.empty()) vbgpd::scene_from_flatbuffer(scene.bytes);
  } catch (const vbgpd::Error&) {
  }
  return 0;
}
