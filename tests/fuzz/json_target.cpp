// A scene as text: refused with a place, or a flatbuffer that is read as a scene.
#include "exchange/scene_buffer.h"
#include "exchange/scene_text.h"
#include "target.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  try {
    const auto bytes = vbgpd::scene_text_to_flatbuffer({reinterpret_cast<const char*>(data), size}, "fuzz");
    vbgpd::scene_from_flatbuffer(bytes);
  } catch (const vbgpd::Error&) {
  }
  return 0;
}
