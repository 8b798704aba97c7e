#include "exchange/json_check.h"

#include <flatbuffers/idl.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <optional>
#include <set>
#include <utility>

#include "scene/wording.h"

namespace vbgpd {
namespace {

namespace fb = flatbuffers;

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

/// What is meant by the raw text between quotes: ~" by \u007e\".
std::string unescaped(std::string_view raw) {
  constexpr std::string_view kLetters = "bfnrt", kMeanings = "\b\f\n\r\t";
  std::string text;
  for (std::size_t i = 0; i < raw.size(); ++i) {
    const std::string_view rest = raw.substr(i);
    if (rest.front() != '\\' || rest.size() < 2) {
      text += rest.front();
      continue;
    }
    const std::size_t letter = kLetters.find(rest[1]);
    unsigned code = 0;
    if (rest.size() >= 6 && rest[1] == 'u' &&
        std::from_chars(rest.data() + 2, rest.data() + 6, code, 16).ptr == rest.data() + 6 && code < 0x80)
      text += static_cast<char>(code), i += 5;
    else if (rest[1] == 'u') text += rest.substr(0, 2), ++i;  // no name has such letters
    else text += letter == kLetters.npos ? rest[1] : kMeanings[letter], ++i;
  }
  return text;
}

/// -12.5e3, and nothing that JSON writes otherwise (+1, .5, 010).
bool is_json_number(std::string_view token) {
  const auto digits = [&] {
    std::size_t n = 0;
    while (n < token.size() && token[n] >= '0' && token[n] <= '9') ++n;
    const bool leading_zero = n > 1 && token.front() == '0';
    token.remove_prefix(n);
    return std::pair{n > 0, leading_zero};
  };
  const auto take = [&](std::string_view any) {
    const bool there = !token.empty() && any.find(token.front()) != any.npos;
    if (there) token.remove_prefix(1);
    return there;
  };
  take("-");
  if (const auto [some, leading_zero] = digits(); !some || leading_zero) return false;
  if (take(".") && !digits().first) return false;
  if (take("eE") && (take("+-"), !digits().first)) return false;
  return token.empty();
}

/// What is too small for a double is 0, what is too large nothing.
bool is_finite_number(std::string_view token) {
  double number = 0;
  const auto fault = std::from_chars(token.data(), token.data() + token.size(), number).ec;
  if (fault == std::errc()) return std::isfinite(number);
  const std::size_t exponent = token.find_first_of("eE");
  if (exponent != token.npos) return token.substr(exponent + 1).starts_with('-');
  return token.starts_with("0.") || token.starts_with("-0.");
}

/// nan, inf, -Infinity.
bool is_no_number(std::string_view token) {
  double number = 0;
  const auto [end, fault] = std::from_chars(token.data(), token.data() + token.size(), number);
  return fault == std::errc() && end == token.data() + token.size() && !std::isfinite(number);
}

/// Walks the text along the schema. Every function returns false where the text stops being JSON.
class Walk {
 public:
  using Places = std::map<std::string, std::size_t>;
  /// `places`: where to note the places of all values, if anywhere.
  explicit Walk(std::string_view json, Places* places = nullptr) : json_(json), places_(places) {}

  std::vector<TextProblem> problems;

  /// The whole text.
  bool document(const fb::StructDef& table) {
    skip_blank();
    note_place("", here_);
    if (!object(table, "")) return false;
    skip_blank();
    return here_ == json_.size() || stop("end of file");
  }

  /// The text without what is at fault.
  std::string mended() {
    std::sort(mends_.begin(), mends_.end(), [](const Mend& a, const Mend& b) { return a.end < b.end; });
    std::string text;
    std::size_t done = 0;
    for (const Mend& m : mends_) text.append(json_.substr(done, m.begin - done)).append(m.by), done = m.end;
    return text.append(json_.substr(done));
  }

 private:
  void skip_blank() {
    while (here_ < json_.size()) {
      if (std::string_view(" \t\r\n").find(peek()) != std::string_view::npos) ++here_;
      else if (starts("//")) here_ = std::min(json_.find('\n', here_), json_.size());
      else if (starts("/*")) here_ = std::min(json_.find("*/", here_ + 2), json_.size() - 2) + 2;
      else return;
    }
  }

  /// The names in the object that begins at `start`, without a word about their values.
  std::set<std::string> names_of(std::size_t start) {
    const std::size_t here = here_, told = problems.size(), faults = faults_;
    std::set<std::string> names;
    here_ = start;
    for (bool first = true, goes_on = take('{'); goes_on; first = false) {
      std::string_view written;
      if (skip_blank(), peek() == '}') break;
      if (!first) goes_on = take(','), skip_blank();
      goes_on = goes_on && string(written, "") && (skip_blank(), take(':')) && (skip_blank(), skip_value());
      if (goes_on) names.insert(unescaped(written));
    }
    here_ = here, faults_ = faults;
    problems.resize(told);
    return names;
  }

  bool object(const fb::StructDef& table, const std::string& path) {
    const std::size_t start = here_;
    std::optional<std::set<std::string>> all;  // found where a name is unknown
    std::set<std::string> written, with_value;
    bool first = true;
    if (!take('{')) return false;
    for (; skip_blank(), peek() != '}'; first = false) {
      if (!first && !take(',', ", or }")) return false;
      skip_blank();
      const std::size_t key_at = here_;
      std::string_view raw;
      constexpr const char* kName = "a name in quotes";
      if (!first && peek() == '}') return stop(kName, ": the comma before it is one too many");
      if (!first && peek() >= '0' && peek() <= '9') return stop(kName, ": decimals are written with a point");
      if (!string(raw, kName)) return false;
      if (skip_blank(); !take(':')) return false;
      skip_blank();
      const auto rename = [&](const std::string& name) { mend(key_at, key_at + raw.size() + 2, "\"" + name + "\""); };
      std::string key = unescaped(raw);
      if (table.fields.Lookup(key) == nullptr) {
        const std::string meant = unknown(key, table, path, key_at);
        if (!all) all = names_of(start);
        if (!meant.empty() && !all->contains(meant) && !written.contains(meant))
          key = meant, rename(key);  // read as what it is meant to be
      }
      const auto* field = table.fields.Lookup(key);
      if (field != nullptr) {
        if (!starts("null")) with_value.insert(key);
        if (!written.insert(key).second) {
          const std::string twice = join(path, key);
          problem(key_at, twice, twice + " is written a second time: keep the value that is meant");
          rename("");  // a field nobody knows
        }
      }
      if (!(field ? value(field->value.type, join(path, key), field) : skip_value())) return false;
    }
    missing(table, with_value, first, path, start);
    return take('}');
  }

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
      if (i > 0 && !take(',', ", or ]")) return false;
      skip_blank();
      if (!value(element, path + "[" + std::to_string(i) + "]", nullptr)) return false;
      skip_blank();
    }
    return take(']');
  }

  bool text(const fb::Type& type, const std::string& path, const fb::FieldDef* field) {
    const std::size_t start = here_;
    std::string_view written;
    if (!string(written, "text in quotes")) return false;
    const std::string found = unescaped(written), said = found.substr(0, 64);
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
    if (found.empty()) return stop(expected_text(type));
    if (found == "null") return true;
    const std::string said(found.substr(0, 40));
    const bool no_number = is_no_number(found);
    if (type.base_type != fb::BASE_TYPE_DOUBLE || !(is_json_number(found) || no_number))
      problem(start, path, path + ": expected " + expected_text(type) + ", found " + said);
    else if (no_number || !is_finite_number(found))
      problem(start, path, path + ": " + said + " is not a finite number; leave the field out if there is no value");
    return true;
  }

  /// Over a value of an unknown field, without recursion, so that deep nesting costs nothing.
  bool skip_value() {
    int depth = 0;
    do {
      skip_blank();
      const char c = peek();
      std::string_view ignored;
      if (here_ >= json_.size()) return stop("a value");
      if (c == '"') {
        if (!string(ignored, "text in quotes")) return false;
      } else {
        depth += (c == '{' || c == '[') - (c == '}' || c == ']');
        if (depth < 0) return stop("a value");
        ++here_;
        if (depth == 0 && c != '}' && c != ']')
          while (here_ < json_.size() && std::string_view(",]} \t\r\n").find(peek()) == std::string_view::npos) ++here_;
      }
    } while (depth > 0);
    return true;
  }

  /// The raw characters between quotes; escapes are left as written.
  bool string(std::string_view& found, const char* expected) {
    if (!take('"', expected)) return false;
    const std::size_t start = here_;
    for (; here_ < json_.size() && peek() != '"'; ++here_) {
      if (peek() != '\\') continue;
      const std::string escape(json_.substr(here_, 2));
      if (escape.size() < 2 || std::string_view("\"\\/bfnrtu").find(escape[1]) == std::string_view::npos)
        problem(here_, "", "JSON has no " + escape + ": a \\ itself is written \\\\", kHarmless);
      ++here_;
    }
    here_ = std::min(here_, json_.size());
    found = json_.substr(start, here_ - start);
    return take('"', "\" at the end of a text");
  }

  /// Returns the field that was probably meant, or "".
  std::string unknown(std::string_view key, const fb::StructDef& table, const std::string& path, std::size_t where) {
    std::vector<std::string_view> names;
    for (const auto* field : table.fields.vec) names.push_back(field->name);
    const std::string prefix = path.empty() ? "" : path + ": ";
    const std::string_view nearest = nearest_name(key, names);
    problem(where, join(path, nearest.empty() ? key : nearest),
            prefix + "unknown field \"" + std::string(key.substr(0, 64)) + "\"" + suggestion_text(key, names) +
                " (known here: " + list_text(names) + ")",
            kHarmless);
    return std::string(nearest);
  }

  /// What has no value, though it needs one. `start` is the brace that opens the object, `empty` one without names.
  void missing(const fb::StructDef& table, const std::set<std::string>& with_value, bool empty, const std::string& path,
               std::size_t start) {
    std::string added;
    for (const auto* field : table.fields.vec) {
      if (!field->attributes.Lookup("needed") || with_value.contains(field->name)) continue;
      if (!choices(*field).empty()) added += "\"" + field->name + "\":" + substitute(*field) + ",";
      const std::string doc = doc_of(*field);
      problem(start, join(path, field->name),
              join(path, field->name) + " is required" + (doc.empty() ? "" : ": " + doc));
    }
    if (empty && !added.empty()) added.pop_back();
    if (!added.empty()) mend(start + 1, start + 1, added);
  }

  /// What stands for a value at fault: nothing, or one of the choices where there must be one.
  static std::string substitute(const fb::FieldDef& field) {
    const std::vector<std::string_view> known = choices(field);
    return known.empty() ? "null" : std::string("\"").append(known.front()).append("\"");
  }

  /// What stands for an object of a list.
  static std::string blank(const fb::StructDef& table) {
    std::string fields;
    for (const auto* field : table.fields.vec)
      if (!choices(*field).empty())
        fields += (fields.empty() ? "\"" : ",\"") + field->name + "\":" + substitute(*field);
    return "{" + fields + "}";
  }

  static constexpr bool kHarmless = true;
  void problem(std::size_t where, std::string path, std::string text, bool harmless = false) {
    faults_ += harmless ? 0 : 1;
    problems.push_back({where, std::move(path), std::move(text), harmless});
  }
  void mend(std::size_t begin, std::size_t end, std::string by) { mends_.push_back({begin, end, std::move(by)}); }

  void note_place(const std::string& path, std::size_t here) {
    if (places_ != nullptr) places_->emplace(path, here);
  }

  static std::string join(const std::string& path, std::string_view name) {
    return path.empty() ? std::string(name) : path + "." + std::string(name);
  }

  char peek() const { return here_ < json_.size() ? json_[here_] : '\0'; }
  bool starts(std::string_view what) const { return json_.substr(here_).starts_with(what); }
  bool take(char c, const char* expected = nullptr) {
    if (here_ < json_.size() && peek() == c) return ++here_, true;
    return stop(expected != nullptr ? expected : std::string(1, c));
  }
  /// The text is no JSON from here on.
  bool stop(const std::string& expected, const char* hint = "") {
    const bool cut = here_ >= json_.size();
    problem(std::min(here_, json_.size()), "",
            "expected " + expected + ", found " + (cut ? "end of file" : whole_character()) + hint, kHarmless);
    return false;
  }
  /// With the bytes that UTF-8 has behind its first one.
  std::string whole_character() const {
    std::size_t end = here_ + 1;
    while (end < json_.size() && (static_cast<unsigned char>(json_[end]) & 0xC0) == 0x80) ++end;
    return std::string(json_.substr(here_, end - here_));
  }

  struct Mend {
    std::size_t begin, end;
    std::string by;
  };

  std::string_view json_;
  Places* places_;
  std::size_t here_ = 0, faults_ = 0;
  std::vector<Mend> mends_;
};

}  // namespace

TextCheck check_json(std::string_view json, const fb::StructDef& table) {
  Walk walk(json);
  const bool is_json = walk.document(table);
  std::stable_sort(walk.problems.begin(), walk.problems.end(),
                   [](const TextProblem& a, const TextProblem& b) { return a.offset < b.offset; });
  return {std::move(walk.problems), is_json, is_json ? walk.mended() : ""};
}

std::map<std::string, std::size_t> places_in(std::string_view json, const fb::StructDef& table) {
  Walk::Places places;
  Walk(json, &places).document(table);
  return places;
}

}  // namespace vbgpd
