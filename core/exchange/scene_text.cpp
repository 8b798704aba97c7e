#include "exchange/scene_text.h"

#include <flatbuffers/idl.h>

#include <algorithm>

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

}  // namespace

std::vector<std::uint8_t> scene_text_to_flatbuffer(std::string_view json, const std::string& source_name) {
  const std::string text(plain_text(json, source_name));
  fb::Parser parser(strict_options());
  if (!parser.Parse(kSchemaText)) throw Error(Status::kInternal, "the scene schema does not parse: " + parser.error_);

  std::string problems;
  for (const TextProblem& problem : check_json(text, *parser.root_struct_def_))
    problems +=
        (problems.empty() ? "" : "\n") + source_name + ":" + position_text(text, problem.offset) + ": " + problem.text;
  if (!problems.empty()) throw Error(Status::kFormat, problems);

  if (!parser.ParseJson(text.c_str())) throw Error(Status::kFormat, parser_message(parser.error_, source_name));
  const std::uint8_t* bytes = parser.builder_.GetBufferPointer();
  return {bytes, bytes + parser.builder_.GetSize()};
}

}  // namespace vbgpd
