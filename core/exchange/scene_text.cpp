#include "exchange/scene_text.h"

#include <flatbuffers/idl.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cstdio>
#include <utility>

#include "base/error.h"
#include "exchange/json_check.h"
#include "scene/limits.h"
#include "schema_text.h"

namespace vbgpd {
namespace {

namespace fb = flatbuffers;

[[noreturn]] void refuse(const std::string& source, const std::string& text) {
  throw Error(Status::kFormat, source + ": " + text);
}

/// Everything that can be said about a file before looking for JSON in it. Returns the text without its byte order
/// mark.
std::string_view plain_text(std::string_view json, const std::string& source) {
  if (json.size() > kMaxSceneBytes)
    refuse(source, "the file has " + std::to_string(json.size()) + " bytes: at most " + std::to_string(kMaxSceneBytes) +
                       " are accepted");
  if (json.size() >= 8 && json.substr(4, 4) == "VBGP")
    refuse(source, "is not text: it looks like a scene in flatbuffer form, which is read by another call");
  if (json.starts_with("\xEF\xBB\xBF")) json.remove_prefix(3);
  if (json.find_first_not_of(" \t\r\n") == json.npos)
    refuse(source, "the file is empty: a scene is a JSON object { ... }");
  const auto control = std::find_if(json.begin(), json.end(), [](char c) {
    const auto byte = static_cast<unsigned char>(c);
    return (byte < ' ' && c != '\t' && c != '\r' && c != '\n') || byte == 0x7F;
  });
  if (control != json.end())
    refuse(source, "is not text: byte " + std::to_string(control - json.begin()) + " has the value " +
                       std::to_string(static_cast<unsigned char>(*control)) + "; a scene is JSON in UTF-8");
  return json;
}

fb::IDLOptions strict_options() {
  fb::IDLOptions options;
  options.strict_json = true;
  options.skip_unexpected_fields_in_json = false;
  options.allow_non_utf8 = false;
  options.no_warnings = true;
  return options;
}

/// The parser says "3: 17: error: illegal UTF-8 sequence", or a sentence without a place.
SceneFault parser_fault(std::string said) {
  if (const auto tail = said.find(", originally at:"); tail != said.npos) said.resize(tail);
  SceneFault fault;
  const std::size_t error = said.find(": error: ");
  if (error == said.npos || std::sscanf(said.c_str(), "%zu: %zu", &fault.position.line, &fault.position.column) != 2)
    fault.text = said;
  else fault.text = said.substr(error + std::string_view(": error: ").size());
  return fault;
}

/// Parses the schema, so that its description of a scene can be looked at.
class Schema {
 public:
  Schema() : parser_(strict_options()) {
    if (!parser_.Parse(kSchemaText))
      throw Error(Status::kInternal, "the scene schema does not parse: " + parser_.error_);
  }
  const fb::StructDef& scene() const { return *parser_.root_struct_def_; }
  fb::Parser& parser() { return parser_; }

 private:
  fb::Parser parser_;
};

/// Nothing where the parser refuses the text.
std::vector<std::uint8_t> parsed(fb::Parser& parser, const std::string& text) {
  if (!parser.ParseJson(text.c_str())) return {};
  const std::uint8_t* bytes = parser.builder_.GetBufferPointer();
  return {bytes, bytes + parser.builder_.GetSize()};
}

/// What is left when everything at fault is taken out; nothing where that is no scene either.
std::vector<std::uint8_t> remainder(Schema& schema, const TextCheck& check) {
  // every number depends on the units
  const auto misleads = [](const TextProblem& p) { return p.path == "units" && !p.harmless; };
  if (!check.is_json || std::any_of(check.problems.begin(), check.problems.end(), misleads)) return {};
  schema.parser().opts.skip_unexpected_fields_in_json = true;
  return parsed(schema.parser(), check.mended);
}

/// "materials[1]" of "materials[1].cohesion", "seismic" of "seismic.kh".
std::string_view object_of(std::string_view path) { return path.substr(0, path.find('.')); }

std::string_view field_of(std::string_view path) { return path.substr(path.find_last_of('.') + 1); }

/// "materials[1]" holds "materials[1]" and "materials[1].cohesion".
bool holds(std::string_view outer, std::string_view path) {
  if (!path.starts_with(outer)) return false;
  const std::string_view rest = path.substr(outer.size());
  return rest.empty() || rest.front() == '.' || rest.front() == '[';
}

/// Whether a word, with nothing of a longer one around it, is in a sentence.
bool names(std::string_view sentence, std::string_view word) {
  const auto goes_on = [](char c) { return c == '_' || std::isalnum(static_cast<unsigned char>(c)) != 0; };
  for (std::size_t at = 0; !word.empty() && (at = sentence.find(word, at)) != sentence.npos; ++at) {
    const std::size_t end = at + word.size();
    if ((at == 0 || !goes_on(sentence[at - 1])) && (end == sentence.size() || !goes_on(sentence[end]))) return true;
  }
  return false;
}

/// "[3]" of "vertex 3 lies on edge 5", "vertices 3 and 4 are", "edges 3 and 7 cross", else nothing.
std::string corner_of(std::string_view sentence) {
  for (const std::string_view word : {"vertex ", "vertices ", "edges "})
    if (sentence.starts_with(word)) {
      sentence.remove_prefix(word.size());
      return std::string("[").append(sentence.substr(0, sentence.find_first_not_of("0123456789"))).append("]");
    }
  return {};
}

/// Where a file has what the engine calls by these names.
constexpr std::array<std::pair<std::string_view, std::string_view>, 10> kScenePaths{{
    {"kh", "seismic.kh"},
    {"kv", "seismic.kv"},
    {"srf_min", "strength_reduction.srf_min"},
    {"srf_max", "strength_reduction.srf_max"},
    {"srf_tolerance", "strength_reduction.tolerance"},
    {"water_unit_weight", "water.unit_weight"},
    {"bond", "numerics.bond"},
    {"kernel", "numerics.kernel"},
    {"smoothing_ratio", "numerics.smoothing_ratio"},
    {"jitter", "numerics.jitter"},
}};

/// "materials[1].cohesion" of "materials[1] 'sand': cohesion = -1 Pa: must be >= 0".
std::string path_of(std::string_view issue) {
  std::size_t end = std::min(issue.find(": "), issue.size());
  std::string path(issue.substr(0, std::min(issue.find(" '"), end)));
  if (path.size() < end) end = std::min(issue.find("': "), issue.size() - 1) + 1;
  issue.remove_prefix(std::min(end + 2, issue.size()));
  const std::string_view word = issue.substr(0, issue.find_first_of(" :,"));
  if (const std::string corner = corner_of(issue); !corner.empty())
    return path + (path.starts_with("layers[") ? ".polygon" : "") + corner;
  if (path != "scene") return path.append(".").append(word);
  const auto named = std::find_if(kScenePaths.begin(), kScenePaths.end(), [&](auto& p) { return p.first == word; });
  return std::string(named == kScenePaths.end() ? word : named->second);
}

/// Whether what is said about a value can only be said with a sound outline.
bool needs_outline(std::string_view path) {
  if (path.starts_with("layers")) return field_of(path) != "material";
  if (path.starts_with("boundaries[")) return field_of(path) == "point";
  if (path.starts_with("loads[")) return field_of(path) == "from";
  return path.starts_with("water");
}

/// Line and column of bytes asked for in order.
class Positions {
 public:
  explicit Positions(std::string_view text) : text_(text) {}
  TextPosition of(std::size_t offset) {
    for (; done_ < std::min(offset, text_.size()); ++done_) {
      const bool first_byte = (static_cast<unsigned char>(text_[done_]) & 0xC0) != 0x80;
      if (text_[done_] == '\n') ++at_.line, at_.column = 1;
      else if (first_byte) ++at_.column;
    }
    return at_;
  }

 private:
  std::string_view text_;
  std::size_t done_ = 0;
  TextPosition at_{1, 1};
};

/// The innermost thing in `places` that holds a value; nowhere when that is the scene itself.
std::size_t nearest_place(std::string path, const std::map<std::string, std::size_t>& places) {
  for (;;) {
    if (const auto found = places.find(path); found != places.end() && !path.empty()) return found->second;
    const std::size_t end = path.find_last_of(".[");
    if (end == path.npos) return path.npos;
    path.resize(end);
  }
}

}  // namespace

SceneText read_scene_text(std::string_view json, const std::string& source_name) {
  const std::string text(plain_text(json, source_name));
  Schema schema;
  const TextCheck check = check_json(text, schema.scene());
  SceneText scene;
  Positions positions(text);
  for (const TextProblem& p : check.problems)
    scene.faults.push_back({positions.of(p.offset), p.path, p.text, p.harmless});
  if (!scene.faults.empty()) {
    scene.bytes = remainder(schema, check);
  } else if (scene.bytes = parsed(schema.parser(), text); scene.bytes.empty()) {
    scene.faults.push_back(parser_fault(schema.parser().error_));
  }
  return scene;
}

std::vector<std::uint8_t> scene_text_to_flatbuffer(std::string_view json, const std::string& source_name) {
  constexpr std::size_t kMost = 20;
  SceneText scene = read_scene_text(json, source_name);
  const std::size_t count = scene.faults.size();
  std::string lines;
  for (std::size_t i = 0; i < std::min(count, kMost); ++i) {
    const SceneFault& fault = scene.faults[i];
    lines.append(i == 0 ? "" : "\n").append(source_name);
    if (fault.position.line > 0) lines.append(":").append(fault.position.text());
    lines.append(": ").append(fault.text);
  }
  if (count > kMost) lines += "\n" + source_name + ": and " + std::to_string(count - kMost) + " more";
  if (count > 0) throw Error(Status::kFormat, lines);
  return std::move(scene.bytes);
}

std::vector<TextPosition> issue_positions(std::span<const std::string> issues, std::string_view json) {
  if (issues.empty()) return {};
  const std::string text(plain_text(json, ""));
  const auto places = places_in(text, Schema().scene());
  std::vector<std::pair<std::size_t, std::size_t>> found;  // place, issue
  for (std::size_t i = 0; i < issues.size(); ++i)
    if (const std::size_t place = nearest_place(path_of(issues[i]), places); place != std::string::npos)
      found.emplace_back(place, i);
  std::sort(found.begin(), found.end());
  std::vector<TextPosition> result(issues.size());
  Positions positions(text);
  for (const auto& [place, i] : found) result[i] = positions.of(place);
  return result;
}

bool may_follow_from(std::string_view issue, const SceneFault& fault) {
  if (fault.harmless) return false;
  const std::string path = path_of(issue);
  if (holds(path, fault.path) || holds(fault.path, path)) return true;
  const std::string_view said = issue.substr(std::min(issue.find(": "), issue.size()));
  if (object_of(path) == object_of(fault.path) && names(said, field_of(fault.path))) return true;
  if (fault.path.starts_with("profile") && needs_outline(path)) return true;
  const bool other_end = field_of(path) == "pressure_end" && field_of(fault.path) == "pressure";  // its default
  if (other_end && object_of(path) == object_of(fault.path)) return true;
  const bool soil_unknown = fault.path.starts_with("materials") &&
                            (field_of(fault.path) == "name" || fault.path.find('.') == fault.path.npos);
  return soil_unknown && path.starts_with("layers[") && field_of(path) == "material";
}

}  // namespace vbgpd
