// A profile as a flatbuffer: refused, or a scene that can be checked and written again.
#include "exchange/scene_buffer.h"
#include "scene/validate.h"
#include "target.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  try {
    const vbgpd::SceneDef scene = vbgpd::scene_from_flatbuffer({data, size});
    vbgpd::validate(scene);
    // what was accepted is accepted again, and reads the same
    const auto bytes = vbgpd::scene_to_flatbuffer(scene);
    if (vbgpd::scene_to_flatbuffer(vbgpd::scene_from_flatbuffer(bytes)) != bytes) __builtin_trap();
  } catch (const vbgpd::Error&) {
  }
  return 0;
}
