#include "vtk_file.h"

#include <tinyxml2.h>

#include "format.h"

namespace cli {

namespace {

/// VTK wants three components of a vector and six of a symmetric tensor (xx yy zz xy yz xz).
int padded(int components) { return components == 2 ? 3 : (components == 4 ? 6 : components); }

std::string numbers(const std::vector<double>& values, int components) {
  std::string text;
  const int width = padded(components);
  for (std::size_t i = 0; i < values.size(); i += static_cast<std::size_t>(components)) {
    for (int c = 0; c < width; ++c)
      text += format("%.9g ", c < components ? values[i + static_cast<std::size_t>(c)] : 0.0);
    text += '\n';
  }
  return text;
}

void data_array(tinyxml2::XMLPrinter& out, const char* name, const char* type, int components,
                const std::string& text) {
  out.OpenElement("DataArray");
  out.PushAttribute("type", type);
  out.PushAttribute("Name", name);
  out.PushAttribute("NumberOfComponents", components);
  out.PushAttribute("format", "ascii");
  out.PushText(text.c_str());
  out.CloseElement();
}

std::string repeated(std::size_t n, auto&& value) {
  std::string text;
  for (std::size_t i = 0; i < n; ++i) text += std::to_string(value(i)) + (i % 16 == 15 ? '\n' : ' ');
  return text;
}

void open_file(tinyxml2::XMLPrinter& out, const char* type) {
  out.PushHeader(false, true);
  out.OpenElement("VTKFile");
  out.PushAttribute("type", type);
  out.PushAttribute("version", "0.1");
  out.PushAttribute("byte_order", "LittleEndian");
}

}  // namespace

std::string particles_vtu(const vbgpd_model* model) {
  tinyxml2::XMLPrinter out;
  const std::vector<double> position = field(model, "position");
  const std::size_t n = position.size() / 2;
  open_file(out, "UnstructuredGrid");
  out.OpenElement("UnstructuredGrid");
  out.OpenElement("Piece");
  out.PushAttribute("NumberOfPoints", static_cast<std::int64_t>(n));
  out.PushAttribute("NumberOfCells", static_cast<std::int64_t>(n));
  out.OpenElement("Points");
  data_array(out, "position", "Float64", 3, numbers(position, 2));
  out.CloseElement();
  out.OpenElement("Cells");
  data_array(out, "connectivity", "Int64", 1, repeated(n, [](std::size_t i) { return i; }));
  data_array(out, "offsets", "Int64", 1, repeated(n, [](std::size_t i) { return i + 1; }));
  data_array(out, "types", "UInt8", 1, repeated(n, [](std::size_t) { return 1; }));  // VTK_VERTEX
  out.CloseElement();
  out.OpenElement("PointData");
  std::int64_t count = 0;
  vbgpd_field_count(&count);
  for (std::int64_t i = 0; i < count; ++i) {
    vbgpd_field_info info{};
    info.struct_size = sizeof info;
    if (vbgpd_field_info_at(i, &info) != VBGPD_OK || info.location != VBGPD_AT_PARTICLE) continue;
    std::vector<double> values(n * static_cast<std::size_t>(info.components));
    const auto index = static_cast<std::int32_t>(i);
    if (vbgpd_model_read_f64(model, index, values.data(), 0, 0, static_cast<std::int64_t>(n), nullptr) != VBGPD_OK)
      continue;  // a field that a run-out does not have
    data_array(out, info.name, "Float64", padded(info.components), numbers(values, info.components));
  }
  out.CloseElement();
  for (int level = 0; level < 3; ++level) out.CloseElement();
  return out.CStr();
}

std::string collection_pvd(const std::vector<std::pair<std::string, double>>& frames) {
  tinyxml2::XMLPrinter out;
  open_file(out, "Collection");
  out.OpenElement("Collection");
  for (const auto& [file, time] : frames) {
    out.OpenElement("DataSet");
    out.PushAttribute("timestep", time);
    out.PushAttribute("group", "");
    out.PushAttribute("part", 0);
    out.PushAttribute("file", file.c_str());
    out.CloseElement();
  }
  out.CloseElement();
  out.CloseElement();
  return out.CStr();
}

}  // namespace cli
