#include "exchange/scene_text.h"

#include <flatbuffers/idl.h>

#include <algorithm>
#include <array>

#include "base/error.h"
#include "exchange/json_check.h"
#include "exchange/limits.h"
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

/// The parser says "3: 17: error: expecting: } instead got: ]"; we say "FILE:3:17: expected }, found ]".
std::string parser_message(std::string said, const std::string& source) {
  if (const auto tail = said.find(", originally at:"); tail != said.npos) said.resize(tail);
  const auto reword = [&](std::string_view from, std::string_view to) {
    if (const auto at = said.find(from); at != said.npos) said.replace(at, from.size(), to);
  };
  reword("expecting: ", "expected ");
  reword(" instead got: ", ", found ");
  const auto line_end = said.find(": "), column_end = said.find(": error: ");
  if (column_end == said.npos || line_end >= column_end) return source + ": " + said;
  reword(": error: ", ": ");
  reword(": ", ":");
  return source + ":" + said;
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

std::vector<std::uint8_t> parsed(fb::Parser& parser, const std::string& text, const std::string& source) {
  if (!parser.ParseJson(text.c_str())) throw Error(Status::kFormat, parser_message(parser.error_, source));
  const std::uint8_t* bytes = parser.builder_.GetBufferPointer();
  return {bytes, bytes + parser.builder_.GetSize()};
}

/// What is left when everything at fault is taken out; nothing where that is no scene either.
std::vector<std::uint8_t> remainder(Schema& schema, const TextCheck& check) {
  const auto misleads = [](const TextProblem& p) { return p.path == "units"; };  // every number depends on it
  if (std::any_of(check.problems.begin(), check.problems.end(), misleads)) return {};
  schema.parser().opts.skip_unexpected_fields_in_json = true;
  try {
    return parsed(schema.parser(), check.mended, "");
  } catch (const Error&) {
    return {};
  }
}

/// "materials[1]" of "materials[1].cohesion"; a setting of the scene ("spacing", "seismic.kh") stands alone.
std::string_view object_of(std::string_view path) {
  constexpr std::array<std::string_view, 3> kSettings{"numerics", "seismic", "strength_reduction"};
  const std::string_view first = path.substr(0, path.find('.'));
  if (std::find(kSettings.begin(), kSettings.end(), first) != kSettings.end()) return path;
  return first;
}

std::string_view list_of(std::string_view object) { return object.substr(0, object.find('[')); }

/// "[3]" of "vertex 3 lies on edge 5", "vertices 3 and 4 are", "edges 3 and 7 cross", else nothing.
std::string corner_of(std::string_view sentence) {
  for (const std::string_view word : {"vertex ", "vertices ", "edges "})
    if (sentence.starts_with(word)) {
      sentence.remove_prefix(word.size());
      return "[" + std::string(sentence.substr(0, sentence.find_first_not_of("0123456789"))) + "]";
    }
  return {};
}

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
  if (word == "kh" || word == "kv") return std::string("seismic.").append(word);
  if (word.starts_with("srf_"))
    return std::string("strength_reduction.").append(word == "srf_tolerance" ? word.substr(4) : word);
  for (const std::string_view name : {"bond", "kernel", "smoothing_ratio", "jitter"})
    if (word == name) return std::string("numerics.").append(word);
  return std::string(word);
}

}  // namespace

SceneText read_scene_text(std::string_view json, const std::string& source_name) {
  const std::string text(plain_text(json, source_name));
  Schema schema;
  const TextCheck check = check_json(text, schema.scene());
  SceneText scene;
  for (const TextProblem& p : check.problems) scene.faults.push_back({position(text, p.offset), p.path, p.text});
  scene.bytes = check.problems.empty() ? parsed(schema.parser(), text, source_name) : remainder(schema, check);
  return scene;
}

std::vector<std::uint8_t> scene_text_to_flatbuffer(std::string_view json, const std::string& source_name) {
  SceneText scene = read_scene_text(json, source_name);
  std::string faults;
  for (const SceneFault& fault : scene.faults)
    faults += (faults.empty() ? "" : "\n") + source_name + ":" + fault.position.text() + ": " + fault.text;
  if (!faults.empty()) throw Error(Status::kFormat, faults);
  return std::move(scene.bytes);
}

TextPosition issue_position(std::string_view issue, std::string_view json) {
  const std::string text(plain_text(json, ""));
  return position(text, place_of(path_of(issue), text, Schema().scene()));
}

bool may_follow_from(std::string_view issue, const SceneFault& fault) {
  const std::string path = path_of(issue);
  const std::string_view object = object_of(path), faulty = object_of(fault.path);
  const std::string_view list = list_of(object), faulty_list = list_of(faulty);
  if (object == faulty) return true;
  if (list == faulty_list && (object == list || faulty == faulty_list)) return true;  // a list that is not there
  if (faulty == "profile") return list != "materials";
  const bool names_soil = fault.path == faulty || fault.path.ends_with(".name");
  return faulty_list == "materials" && names_soil && path.ends_with(".material");
}

}  // namespace vbgpd
