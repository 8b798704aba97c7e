#include "exchange/json_check.h"

#include <flatbuffers/idl.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <set>

#include "scene/wording.h"

namespace vbgpd {
namespace {

namespace fb = flatbuffers;

constexpr std::size_t kMaxProblems = 20;  // of one file; more help nobody

std::string expected_text(const fb::Type& type) {
  switch (type.base_type) {
    case fb::BASE_TYPE_STRING:
      return "text in quotes";
    case fb::BASE_TYPE_STRUCT:
      return "an object { ... }";
    case fb::BASE_TYPE_VECTOR:
      return "a list [ ... ]";
    default:
      return "a number";
  }
}

/// Walks the text along the schema. Every function returns false where the text stops being JSON.
class Walk {
 public:
  explicit Walk(std::string_view json) : json_(json) {}

  std::vector<TextProblem> problems;

  bool object(const fb::StructDef& table, const std::string& path) {
    const std::size_t start = here_;
    std::set<std::string> seen, meant;  // field names as written, and as guessed from misspelt ones
    if (!take('{')) return false;
    for (bool first = true; skip_blank(), peek() != '}'; first = false) {
      if (!first && !take(',')) return false;
      skip_blank();
      const std::size_t key_at = here_;
      std::string_view key;
      if (!string(key)) return false;
      if (skip_blank(); !take(':')) return false;
      skip_blank();
      const auto* field = table.fields.Lookup(std::string(key));
      const bool is_null = starts("null");
      if (!field) meant.insert(unknown(key, table, path, key_at));
      else if (!is_null && !seen.insert(std::string(key)).second)
        problem(key_at, join(path, key) + " is written a second time: keep the value that is meant");
      if (!(field ? value(field->value.type, join(path, key)) : skip_value())) return false;
    }
    seen.merge(meant);
    missing(table, seen, path, start);
    return take('}');
  }

  void skip_blank() {
    while (here_ < json_.size()) {
      if (std::string_view(" \t\r\n").find(peek()) != std::string_view::npos) ++here_;
      else if (starts("//")) here_ = std::min(json_.find('\n', here_), json_.size());
      else if (starts("/*")) here_ = std::min(json_.find("*/", here_ + 2), json_.size() - 2) + 2;
      else return;
    }
  }

 private:
  bool value(const fb::Type& type, const std::string& path) {
    const std::size_t start = here_;
    const char c = peek();
    if (c == '"') return text(type, path);
    if (c == '{' && type.base_type == fb::BASE_TYPE_STRUCT) return object(*type.struct_def, path);
    if (c == '[' && type.base_type == fb::BASE_TYPE_VECTOR) return list(type.VectorType(), path);
    if (c == '{' || c == '[') {
      problem(start, path + ": expected " + expected_text(type) + ", found " + (c == '{' ? "an object" : "a list"));
      return skip_value();
    }
    return word(type, path);
  }

  bool list(const fb::Type& element, const std::string& path) {
    if (!take('[')) return false;
    for (std::size_t i = 0; skip_blank(), peek() != ']'; ++i) {
      if (i > 0 && !take(',')) return false;
      skip_blank();
      if (!value(element, path + "[" + std::to_string(i) + "]")) return false;
      skip_blank();
    }
    return take(']');
  }

  bool text(const fb::Type& type, const std::string& path) {
    const std::size_t start = here_;
    std::string_view found;
    if (!string(found)) return false;
    if (type.base_type != fb::BASE_TYPE_STRING)
      problem(start, path + ": expected " + expected_text(type) + ", found the text \"" +
                         std::string(found.substr(0, 40)) + "\"");
    return true;
  }

  /// A number, true, false, null or something that is none of these.
  bool word(const fb::Type& type, const std::string& path) {
    const std::size_t start = here_;
    while (here_ < json_.size() && std::string_view(" \t\r\n,:[]{}\"/").find(peek()) == std::string_view::npos) ++here_;
    const std::string_view found = json_.substr(start, here_ - start);
    if (found.empty()) return false;
    if (found == "null") return true;
    const std::string said(found.substr(0, 40));
    if (type.base_type != fb::BASE_TYPE_DOUBLE)
      problem(start, path + ": expected " + expected_text(type) + ", found " + said);
    else if (!is_finite_number(found))
      problem(start, path + ": " + said + " is not a finite number; leave the field out if there is no value");
    return true;
  }

  static bool is_finite_number(std::string_view token) {
    double number = 0;
    const auto [end, fault] = std::from_chars(token.data(), token.data() + token.size(), number);
    return fault == std::errc() && end == token.data() + token.size() && std::isfinite(number);
  }

  /// Over a value of an unknown field, without recursion, so that deep nesting costs nothing.
  bool skip_value() {
    int depth = 0;
    do {
      skip_blank();
      const char c = peek();
      std::string_view ignored;
      if (here_ >= json_.size()) return false;
      if (c == '"') {
        if (!string(ignored)) return false;
      } else {
        depth += (c == '{' || c == '[') - (c == '}' || c == ']');
        if (depth < 0) return false;
        ++here_;
        if (depth == 0 && c != '}' && c != ']')
          while (here_ < json_.size() && std::string_view(",]} \t\r\n").find(peek()) == std::string_view::npos) ++here_;
      }
    } while (depth > 0);
    return true;
  }

  /// The raw characters between quotes; escapes are left as written.
  bool string(std::string_view& found) {
    if (!take('"')) return false;
    const std::size_t start = here_;
    while (here_ < json_.size() && peek() != '"') here_ += peek() == '\\' ? 2 : 1;
    if (here_ >= json_.size()) return false;
    found = json_.substr(start, here_ - start);
    return take('"');
  }

  /// Returns the field that was probably meant, so that it is not reported as missing too.
  std::string unknown(std::string_view key, const fb::StructDef& table, const std::string& path, std::size_t where) {
    std::vector<std::string_view> names;
    for (const auto* field : table.fields.vec) names.push_back(field->name);
    const std::string prefix = path.empty() ? "" : path + ": ";
    problem(where, prefix + "unknown field \"" + std::string(key.substr(0, 64)) + "\"" + suggestion_text(key, names) +
                       " (known here: " + list_text(names) + ")");
    return std::string(nearest_name(key, names));
  }

  void missing(const fb::StructDef& table, const std::set<std::string>& seen, const std::string& path,
               std::size_t where) {
    for (const auto* field : table.fields.vec) {
      if (!field->attributes.Lookup("needed") || seen.contains(field->name)) continue;
      std::string doc = field->doc_comment.empty() ? "" : field->doc_comment.front();
      doc.erase(0, doc.find_first_not_of(' '));
      problem(where, join(path, field->name) + " is required" + (doc.empty() ? "" : ": " + doc));
    }
  }

  void problem(std::size_t where, std::string text) {
    if (problems.size() < kMaxProblems) problems.push_back({where, std::move(text)});
  }

  static std::string join(const std::string& path, std::string_view name) {
    return path.empty() ? std::string(name) : path + "." + std::string(name);
  }

  char peek() const { return here_ < json_.size() ? json_[here_] : '\0'; }
  bool starts(std::string_view what) const { return json_.substr(here_).starts_with(what); }
  bool take(char c) { return peek() == c && (++here_, true); }

  std::string_view json_;
  std::size_t here_ = 0;
};

}  // namespace

std::vector<TextProblem> check_json(std::string_view json, const fb::StructDef& table) {
  Walk walk(json);
  walk.skip_blank();
  walk.object(table, "");
  std::stable_sort(walk.problems.begin(), walk.problems.end(),
                   [](const TextProblem& a, const TextProblem& b) { return a.offset < b.offset; });
  return std::move(walk.problems);
}

std::string position_text(std::string_view text, std::size_t offset) {
  const std::string_view before = text.substr(0, offset);
  const auto line = 1 + std::count(before.begin(), before.end(), '\n');
  const std::size_t line_start = before.rfind('\n') + 1;  // npos + 1 = 0
  const auto is_first_byte = [](char c) { return (static_cast<unsigned char>(c) & 0xC0) != 0x80; };
  const auto column =
      1 + std::count_if(before.begin() + static_cast<std::ptrdiff_t>(line_start), before.end(), is_first_byte);
  return std::to_string(line) + ":" + std::to_string(column);
}

}  // namespace vbgpd
