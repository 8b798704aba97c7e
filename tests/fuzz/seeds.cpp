// Writes the first inputs of a corpus: fuzz_seeds SCENES_DIR CORPUS_DIR.
#include <filesystem>
#include <fstream>
#include <iterator>

#include "exchange/checkpoint.h"
#include "exchange/scene_buffer.h"
#include "exchange/scene_text.h"
#include "physics/scenes.h"
#include "simulation/flow_simulation.h"

namespace fs = std::filesystem;

namespace {

void write(const fs::path& path, const void* bytes, std::size_t size) {
  fs::create_directories(path.parent_path());
  std::ofstream(path, std::ios::binary).write(static_cast<const char*>(bytes), static_cast<std::streamsize>(size));
}

void write_checkpoint(const fs::path& path, const vbgpd::SceneDef& scene, bool driven, bool runs_out = false) {
  auto s = vbgpd::Simulation::compile(scene, {});
  if (driven) {
    s->set("kh", 0.2);
    s->set("strength_reduction_factor", 3);
    std::vector<double> pressure(static_cast<std::size_t>(s->particle_count()), 1e4);
    s->write(vbgpd::find_field("pore_pressure"), pressure);
  }
  if (runs_out) s = vbgpd::make_runout(*s);
  s->step(60, nullptr);
  const vbgpd::CompileOptions& o = s->options();
  const auto bytes =
      vbgpd::checkpoint_to_bytes({s->scene(), o.spacing_factor, o.lattice_multiple, o.coarsening, s->image()});
  write(path, bytes.data(), bytes.size());
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 3) return 2;
  const fs::path corpus = argv[2];
  for (const char* name : {"gl_1", "low_3layer", "prandtl_strip", "james_bay"}) {
    std::ifstream in(fs::path(argv[1]) / (std::string(name) + ".json"));
    const std::string text{std::istreambuf_iterator<char>(in), {}};
    write(corpus / "json" / name, text.data(), text.size());
    const auto bytes = vbgpd::scene_text_to_flatbuffer(text, name);
    write(corpus / "scene" / name, bytes.data(), bytes.size());
  }
  using namespace vbgpd;
  write_checkpoint(corpus / "checkpoint" / "block", test::block(test::soil("elastic", 0, 0), 4, 4, 2), false);
  write_checkpoint(corpus / "checkpoint" / "slope", test::slope(test::soil("mohr_coulomb", 1e3, 20), 5), true);
  SceneDef sliding = test::slope(test::soil("mohr_coulomb", 1e3, 20), 5);
  sliding.boundaries[0].friction_angle = 10;
  write_checkpoint(corpus / "checkpoint" / "runout", sliding, true, true);
  return 0;
}
