#include "picture_file.h"

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <cstring>
#include <filesystem>
#include <fstream>

#include "bad_input.h"
#include "format.h"
#include "material_text.h"
#include "outline.h"

namespace cli {

namespace {

namespace fs = std::filesystem;

picture::Format format_of(const std::string& file) {
  std::string ending = fs::path(file).extension().string();
  std::transform(ending.begin(), ending.end(), ending.begin(), [](unsigned char c) { return std::tolower(c); });
  if (ending == ".svg") return picture::Format::kSvg;
  if (ending == ".png") return picture::Format::kPng;
  if (ending == ".pdf") return picture::Format::kPdf;
  throw BadInput(file,
                 (ending.empty() ? "the picture's name has no ending" : "a picture cannot end in '" + ending + "'") +
                     std::string("; it must end in .svg, .png or .pdf"));
}

picture::Polyline polyline(const std::vector<Point>& points) {
  picture::Polyline line;
  for (const Point& p : points) line.push_back({p.x, p.y});
  return line;
}

std::vector<picture::Material> materials(const vbgpd_profile* profile) {
  std::vector<picture::Material> list;
  for (std::int64_t i = 0; i < count(profile, VBGPD_OBJECT_MATERIAL); ++i)
    list.push_back({text(profile, VBGPD_OBJECT_MATERIAL, i, "name"), material_text(profile, i)});
  return list;
}

std::vector<picture::Layer> layers(const vbgpd_profile* profile, const std::vector<picture::Material>& materials) {
  std::vector<picture::Layer> list;
  for (std::int64_t i = 0; i < count(profile, VBGPD_OBJECT_LAYER); ++i) {
    const std::string name = text(profile, VBGPD_OBJECT_LAYER, i, "material");
    const auto found = std::find_if(materials.begin(), materials.end(), [&](const auto& m) { return m.name == name; });
    if (found == materials.end()) continue;
    list.push_back({static_cast<int>(found - materials.begin()), polyline(polygon(profile, VBGPD_OBJECT_LAYER, i))});
  }
  return list;
}

std::vector<picture::Load> loads(const vbgpd_profile* profile) {
  std::vector<picture::Load> list;
  for (std::int64_t i = 0; i < count(profile, VBGPD_OBJECT_LOAD); ++i) {
    const auto value = [&](const char* name) { return number(profile, VBGPD_OBJECT_LOAD, i, name); };
    const double begin = value("pressure"), end = value("pressure_end");
    list.push_back({value("x0"), value("x1"), begin / 1000, (std::isfinite(end) ? end : begin) / 1000});
  }
  return list;
}

std::vector<picture::Support> supports(const vbgpd_profile* profile, const picture::Polyline& exterior) {
  using picture::Hold;
  const std::int64_t boundaries = count(profile, VBGPD_OBJECT_BOUNDARY);
  if (boundaries == 0)  // the engine's own choice, see vbgpd_profile_add_boundary
    return {{Hold::kFixed, side_of(exterior, "base")},
            {Hold::kRoller, side_of(exterior, "left")},
            {Hold::kRoller, side_of(exterior, "right")}};
  std::vector<picture::Support> list;
  for (std::int64_t id = 0; id < boundaries; ++id) {
    const auto word = [&](const char* name) { return text(profile, VBGPD_OBJECT_BOUNDARY, id, name); };
    const std::string kind = word("kind"), side = word("side");
    if (kind == "free") continue;
    list.push_back({kind == "fixed"    ? Hold::kFixed
                    : kind == "roller" ? Hold::kRoller
                                       : Hold::kMoving,
                    side.empty() ? polyline(polygon(profile, VBGPD_OBJECT_BOUNDARY, id)) : side_of(exterior, side)});
  }
  return list;
}

/// Where the scene comes from, unless that only repeats its name.
std::string source_text(const vbgpd_profile* profile, const std::string& name) {
  const std::string source = text(profile, VBGPD_OBJECT_PROFILE, 0, "source");
  if (name.empty() || source.compare(0, name.size(), name) != 0) return source;
  const std::size_t rest = source.find_first_not_of(" :.,;-", name.size());
  return rest == std::string::npos ? "" : source.substr(rest);
}

/// The soil particles where they were before the slope moved.
std::vector<picture::Cell> cells(const vbgpd_model* model) {
  const std::vector<double> place = field(model, "reference_position"), strain = field(model, "plastic_strain");
  const std::vector<double> boundary = field(model, "boundary");
  std::vector<picture::Cell> list;
  for (std::size_t i = 0; i < strain.size(); ++i)
    if (boundary[i] < 0) list.push_back({place[2 * i], place[2 * i + 1], strain[i]});
  return list;
}

std::string footer(const vbgpd_model* model, const FosResult& result) {
  const auto particles = static_cast<std::int64_t>(number(model, "particles"));
  std::string line = "Method: " + result.scheme + "; strength reduction";
  if (!result.reduced.empty()) line += " of " + result.reduced;
  if (!result.flow_rule.empty()) line += "; flow rule " + result.flow_rule;
  line += ". Spacing " + plain_number(number(model, "spacing_x"), 3) + " m, " + counted(particles, "particle");
  return line + ". vbgpd " + vbgpd_version_string() + ", state " + result.hash;
}

}  // namespace

void require_writable_picture(const std::string& file) {
  format_of(file);
  std::error_code unknown;
  const bool existed = fs::exists(file, unknown);
  if (existed && fs::is_directory(file, unknown))
    throw BadInput(file, "this is a directory; a picture needs the name of a file");
  errno = 0;
  if (!std::ofstream(file, std::ios::binary | std::ios::app))
    throw BadInput(file, std::string("the picture cannot be written there: ") + std::strerror(errno));
  if (!existed) fs::remove(file, unknown);
}

picture::Sheet section_sheet(const Scene& scene) {
  const vbgpd_profile* profile = scene.profile.get();
  picture::Sheet sheet;
  sheet.title = text(profile, VBGPD_OBJECT_PROFILE, 0, "name");
  sheet.subtitle = source_text(profile, sheet.title);
  sheet.exterior = polyline(polygon(profile, VBGPD_OBJECT_PROFILE, 0));
  sheet.materials = materials(profile);
  sheet.layers = layers(profile, sheet.materials);
  sheet.supports = supports(scene.profile.get(), sheet.exterior);
  sheet.loads = loads(profile);
  sheet.water = polyline(water_table(profile));
  sheet.kh = number(profile, VBGPD_OBJECT_PROFILE, 0, "kh");
  sheet.kv = number(profile, VBGPD_OBJECT_PROFILE, 0, "kv");
  return sheet;
}

picture::Sheet picture_sheet(const Scene& scene, const vbgpd_model* model, const FosResult& result) {
  picture::Sheet sheet = section_sheet(scene);
  sheet.result = factor_of_safety_label(result);
  if (result.status == "OK") {  // the first clause says how the value came about, the others what to beware of
    const std::size_t end = result.reason.find("; ");
    sheet.note = result.reason.substr(0, end);
    if (end != std::string::npos) sheet.remark = result.reason.substr(end + 2);
  } else {
    sheet.remark = result.status + ": " + result.reason;
  }
  sheet.cells = cells(model);
  sheet.spacing_x = number(model, "spacing_x");
  sheet.spacing_y = number(model, "spacing_y");
  if (std::isfinite(result.factor_of_safety)) sheet.slip = polyline(result.slip_surface);
  sheet.footer = footer(model, result);
  return sheet;
}

void write_picture(const picture::Sheet& sheet, const std::string& file) {
  const std::string bytes = picture::draw(sheet, format_of(file));
  errno = 0;
  std::ofstream stream(file, std::ios::binary);
  stream.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  stream.close();
  if (!stream) throw BadInput(file, std::string("the picture could not be written: ") + std::strerror(errno));
}

}  // namespace cli
