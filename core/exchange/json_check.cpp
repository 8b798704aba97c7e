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

/// The values a field marked one_of may have.
std::vector<std::string_view> choices(const fb::FieldDef& field) {
  std::vector<std::string_view> names;
  const auto* one_of = field.attributes.Lookup("one_of");
  if (one_of == nullptr) return names;
  for (std::string_view left = one_of->constant; !left.empty();) {
    const std::size_t end = std::min(left.find(' '), left.size());
    names.push_back(left.substr(0, end));
    left.remove_prefix(std::min(end + 1, left.size()));
  }
  return names;
}

/// "what the docstring of a field says", or nothing
std::string doc_of(const fb::FieldDef& field) {
  std::string doc = field.doc_comment.empty() ? "" : field.doc_comment.front();
  return doc.erase(0, doc.find_first_not_of(' '));
}

/// Walks the text along the schema. Every function returns false where the text stops being JSON.
class Walk {
 public:
  /// `wanted` is a path whose place is looked for.
  explicit Walk(std::string_view json, std::string_view wanted = {}) : json_(json), wanted_(wanted) {}

  std::vector<TextProblem> problems;
  std::size_t place = 0;  ///< of what is wanted

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
      else if (!is_null && !seen.insert(std::string(key)).second) {
        const std::string twice = join(path, key);
        problem(key_at, twice, twice + " is written a second time: keep the value that is meant");
        mend(key_at, key_at + key.size() + 2, "\"\"");  // a field nobody knows
      }
      if (!(field ? value(field->value.type, join(path, key), field) : skip_value())) return false;
    }
    missing(table, seen, meant, path, start);
    return take('}');
  }

  std::size_t here() const { return here_; }

  /// The text without what is at fault.
  std::string mended() {
    std::sort(mends_.begin(), mends_.end(), [](const Mend& a, const Mend& b) { return a.end < b.end; });
    std::string text;
    std::size_t done = 0;
    for (const Mend& m : mends_) text.append(json_.substr(done, m.begin - done)).append(m.by), done = m.end;
    return text.append(json_.substr(done));
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
  /// `field` is the field whose value this is, null in a list.
  bool value(const fb::Type& type, const std::string& path, const fb::FieldDef* field) {
    const std::size_t start = here_, faults = faults_;
    note_place(path, start);
    const char c = peek();
    if (c == '{' && type.base_type == fb::BASE_TYPE_STRUCT) return object(*type.struct_def, path);
    if (c == '[' && type.base_type == fb::BASE_TYPE_VECTOR) return list(type.VectorType(), path);
    if (!(c == '"' ? text(type, path, field) : c == '{' || c == '[' ? wrong_kind(type, path) : word(type, path)))
      return false;
    if (faults_ > faults)
      mend(start, here_, field != nullptr ? substitute(*field) : type.struct_def ? blank(*type.struct_def) : "null");
    return true;
  }

  bool wrong_kind(const fb::Type& type, const std::string& path) {
    problem(here_, path,
            path + ": expected " + expected_text(type) + ", found " + (peek() == '{' ? "an object" : "a list"));
    return skip_value();
  }

  bool list(const fb::Type& element, const std::string& path) {
    if (!take('[')) return false;
    for (std::size_t i = 0; skip_blank(), peek() != ']'; ++i) {
      if (i > 0 && !take(',')) return false;
      skip_blank();
      if (!value(element, path + "[" + std::to_string(i) + "]", nullptr)) return false;
      skip_blank();
    }
    return take(']');
  }

  bool text(const fb::Type& type, const std::string& path, const fb::FieldDef* field) {
    const std::size_t start = here_;
    std::string_view found;
    if (!string(found)) return false;
    const std::string said(found.substr(0, 64));
    const std::vector<std::string_view> known = field == nullptr ? std::vector<std::string_view>() : choices(*field);
    if (type.base_type != fb::BASE_TYPE_STRING)
      problem(start, path,
              path + ": expected " + expected_text(type) + ", found the text \"" + said.substr(0, 40) + "\"");
    else if (!known.empty() && std::find(known.begin(), known.end(), found) == known.end())
      problem(start, path,
              path + " \"" + said + "\" is not known: write " + doc_of(*field) + suggestion_text(found, known));
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
      problem(start, path, path + ": expected " + expected_text(type) + ", found " + said);
    else if (!is_finite_number(found))
      problem(start, path, path + ": " + said + " is not a finite number; leave the field out if there is no value");
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
    const std::string_view nearest = nearest_name(key, names);
    problem(where, join(path, nearest.empty() ? key : nearest),
            prefix + "unknown field \"" + std::string(key.substr(0, 64)) + "\"" + suggestion_text(key, names) +
                " (known here: " + list_text(names) + ")");
    return std::string(nearest);
  }

  /// What is neither there nor meant by a misspelt name. `start` is the brace that opens the object.
  void missing(const fb::StructDef& table, const std::set<std::string>& seen, const std::set<std::string>& meant,
               const std::string& path, std::size_t start) {
    std::string added;
    for (const auto* field : table.fields.vec) {
      if (!field->attributes.Lookup("needed") || seen.contains(field->name)) continue;
      if (!choices(*field).empty()) added += "\"" + field->name + "\":" + substitute(*field) + ",";
      if (meant.contains(field->name)) continue;
      const std::string doc = doc_of(*field);
      problem(start, join(path, field->name),
              join(path, field->name) + " is required" + (doc.empty() ? "" : ": " + doc));
    }
    if (seen.empty() && meant.empty() && !added.empty()) added.pop_back();
    if (!added.empty()) mend(start + 1, start + 1, added);
  }

  /// What stands for a value at fault: nothing, or one of the choices where there must be one.
  static std::string substitute(const fb::FieldDef& field) {
    const std::vector<std::string_view> known = choices(field);
    return known.empty() ? "null" : "\"" + std::string(known.front()) + "\"";
  }

  /// What stands for an object of a list.
  static std::string blank(const fb::StructDef& table) {
    std::string fields;
    for (const auto* field : table.fields.vec)
      if (!choices(*field).empty())
        fields += (fields.empty() ? "\"" : ",\"") + field->name + "\":" + substitute(*field);
    return "{" + fields + "}";
  }

  void problem(std::size_t where, std::string path, std::string text) {
    ++faults_;
    if (problems.size() < kMaxProblems) problems.push_back({where, std::move(path), std::move(text)});
  }
  void mend(std::size_t begin, std::size_t end, std::string by) { mends_.push_back({begin, end, std::move(by)}); }

  /// Paths are met from the outside inwards: the last one that leads to what is wanted is the nearest.
  void note_place(const std::string& path, std::size_t here) {
    if (!wanted_.starts_with(path)) return;
    const std::string_view rest = wanted_.substr(path.size());
    if (rest.empty() || rest.front() == '.' || rest.front() == '[') place = here;
  }

  static std::string join(const std::string& path, std::string_view name) {
    return path.empty() ? std::string(name) : path + "." + std::string(name);
  }

  char peek() const { return here_ < json_.size() ? json_[here_] : '\0'; }
  bool starts(std::string_view what) const { return json_.substr(here_).starts_with(what); }
  bool take(char c) { return peek() == c && (++here_, true); }

  struct Mend {
    std::size_t begin, end;
    std::string by;
  };

  std::string_view json_, wanted_;
  std::size_t here_ = 0, faults_ = 0;
  std::vector<Mend> mends_;
};

}  // namespace

TextCheck check_json(std::string_view json, const fb::StructDef& table) {
  Walk walk(json);
  walk.skip_blank();
  walk.object(table, "");
  std::stable_sort(walk.problems.begin(), walk.problems.end(),
                   [](const TextProblem& a, const TextProblem& b) { return a.offset < b.offset; });
  return {std::move(walk.problems), walk.mended()};
}

std::size_t place_of(std::string_view path, std::string_view json, const fb::StructDef& table) {
  Walk walk(json, path);
  walk.skip_blank();
  walk.place = walk.here();
  walk.object(table, "");
  return walk.place;
}

TextPosition position(std::string_view text, std::size_t offset) {
  const std::string_view before = text.substr(0, offset);
  const auto line = 1 + std::count(before.begin(), before.end(), '\n');
  const std::size_t line_start = before.rfind('\n') + 1;  // npos + 1 = 0
  const auto is_first_byte = [](char c) { return (static_cast<unsigned char>(c) & 0xC0) != 0x80; };
  const auto column =
      1 + std::count_if(before.begin() + static_cast<std::ptrdiff_t>(line_start), before.end(), is_first_byte);
  return {static_cast<std::size_t>(line), static_cast<std::size_t>(column)};
}

}  // namespace vbgpd
