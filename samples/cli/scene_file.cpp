#include "scene_file.h"

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <nlohmann/json.hpp>
#include <tuple>

#include "bad_input.h"
#include "exchange/scene_text.h"
#include "format.h"

namespace cli {

namespace {

constexpr std::uintmax_t kLargestFile = 64u
                                        << 20;  // a scene is a few kB; this keeps a wrong file from filling the memory

std::string read_text_file(const std::string& file) {
  namespace fs = std::filesystem;
  std::error_code unknown;
  const fs::file_status status = fs::status(file, unknown);
  if (status.type() == fs::file_type::not_found) throw BadInput(file, "there is no such file");
  if (status.type() == fs::file_type::directory)
    throw BadInput(file, "this is a directory; the name of a scene file is needed");
  errno = 0;
  std::ifstream stream(file, std::ios::binary);
  if (!stream) throw BadInput(file, std::string("the file cannot be read: ") + std::strerror(errno));
  const std::uintmax_t size = fs::is_regular_file(status) ? fs::file_size(file, unknown) : 0;
  if (!unknown && size > kLargestFile)
    throw BadInput(file, format("the file has %.0f MB; a scene file has at most %.0f MB",
                                static_cast<double>(size >> 20), static_cast<double>(kLargestFile >> 20)));
  std::string text{std::istreambuf_iterator<char>(stream), {}};
  if (stream.bad()) throw BadInput(file, std::string("the file cannot be read: ") + std::strerror(errno));
  return text;
}

/// Of a text that has already been accepted as a scene.
std::vector<std::string> boundary_kinds(const std::string& text) {
  std::vector<std::string> kinds;
  const auto scene = nlohmann::json::parse(text, nullptr, false, true);
  if (!scene.is_object() || !scene.contains("boundaries")) return kinds;
  for (const auto& boundary : scene["boundaries"]) kinds.push_back(boundary.value("kind", "fixed"));
  return kinds;
}

Profile profile_of(vbgpd_context* context, const std::vector<std::uint8_t>& bytes, const std::string& file) {
  vbgpd_profile* profile = nullptr;
  const auto size = static_cast<std::int64_t>(bytes.size());
  if (vbgpd_profile_create_from_flatbuffer(context, bytes.data(), size, &profile) < 0)
    throw BadInput(file, errors_of(error_text(context)));
  return Profile(profile);
}

std::vector<Issue> with_positions(std::vector<Issue> issues, const std::string& text) {
  for (Issue& issue : issues) {
    const vbgpd::TextPosition at = vbgpd::issue_position(issue.text, text);
    issue.line = at.line, issue.column = at.column;
  }
  return issues;
}

/// Errors first, then in the order of the file.
std::vector<Issue> in_order(std::vector<Issue> issues) {
  std::stable_sort(issues.begin(), issues.end(), [](const Issue& a, const Issue& b) {
    return a.error != b.error ? a.error : std::tie(a.line, a.column) < std::tie(b.line, b.column);
  });
  return issues;
}

/// The faults of a text, and the errors of what is left of the scene without them, as far as they are not only there
/// because something is missing.
std::vector<Issue> all_errors(vbgpd_context* context, const vbgpd::SceneText& scene, const std::string& text,
                              const std::string& file) {
  std::vector<Issue> errors;
  for (const vbgpd::SceneFault& fault : scene.faults)
    errors.push_back({true, fault.text, fault.position.line, fault.position.column});
  if (scene.bytes.empty()) return errors;
  std::vector<Issue> others;
  try {
    others = with_positions(validate(profile_of(context, scene.bytes, file).get()), text);
  } catch (const BadInput& unreadable) {
    others = unreadable.issues();
  }
  for (Issue& issue : others) {
    const auto explains = [&](const vbgpd::SceneFault& fault) { return vbgpd::may_follow_from(issue.text, fault); };
    if (issue.error && std::none_of(scene.faults.begin(), scene.faults.end(), explains))
      errors.push_back(std::move(issue));
  }
  return in_order(std::move(errors));
}

}  // namespace

Scene read_scene(vbgpd_context* context, const std::string& file) {
  std::string text = read_text_file(file);
  vbgpd::SceneText scene;
  try {
    scene = vbgpd::read_scene_text(text, file);
  } catch (const std::bad_alloc&) {
    throw;
  } catch (const std::exception& fault) {
    throw BadInput(file, errors_of(fault.what()));
  }
  if (!scene.faults.empty()) throw BadInput(file, all_errors(context, scene, text, file));
  return {profile_of(context, scene.bytes, file), boundary_kinds(text), std::move(text)};
}

std::vector<Issue> validate(const Scene& scene) {
  return in_order(with_positions(validate(scene.profile.get()), scene.text));
}

Model create_model(vbgpd_context* context, const vbgpd_profile* profile, const std::string& file) {
  vbgpd_model* model = nullptr;
  if (vbgpd_model_create(context, profile, &model) < 0) throw BadInput(file, errors_of(error_text(context)));
  return Model(model);
}

std::vector<Issue> errors_of(const std::string& text) {
  std::vector<Issue> issues;
  for (std::size_t begin = 0; begin < text.size();) {
    const std::size_t end = std::min(text.find('\n', begin), text.size());
    if (end > begin) issues.push_back({true, text.substr(begin, end - begin)});
    begin = end + 1;
  }
  return issues;
}

std::vector<std::string> lines(const std::vector<Issue>& issues, const std::string& file) {
  std::vector<std::string> result;
  for (const Issue& issue : issues) {
    const bool names_file =
        issue.text.compare(0, file.size(), file) == 0;  // the parser's messages begin with file:line:column
    const std::string place = file + (issue.line == 0 ? "" : format(":%zu:%zu", issue.line, issue.column));
    result.push_back(names_file ? issue.text : place + (issue.error ? ": error: " : ": warning: ") + issue.text);
  }
  return result;
}

void print_issues(const std::vector<Issue>& issues, const std::string& file) {
  for (const std::string& line : lines(issues, file)) std::fprintf(stderr, "%s\n", line.c_str());
}

bool has_error(const std::vector<Issue>& issues) {
  return std::any_of(issues.begin(), issues.end(), [](const Issue& issue) { return issue.error; });
}

}  // namespace cli
