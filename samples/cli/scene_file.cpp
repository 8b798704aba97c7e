#include "scene_file.h"

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <tuple>

#include "bad_input.h"
#include "exchange/scene_text.h"
#include "format.h"

namespace cli {

namespace {

constexpr std::uintmax_t kLargestFile = 64u
                                        << 20;  // a scene is a few kB; this keeps a wrong file from filling the memory

constexpr std::size_t kMostLines = 100;  // of one file; more help nobody

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

Profile profile_of(vbgpd_context* context, const std::vector<std::uint8_t>& bytes, const std::string& file) {
  vbgpd_profile* profile = nullptr;
  const auto size = static_cast<std::int64_t>(bytes.size());
  if (vbgpd_profile_create_from_flatbuffer(context, bytes.data(), size, &profile) < 0)
    throw BadInput(file, errors_of(error_text(context)));
  return Profile(profile);
}

std::vector<Issue> with_positions(std::vector<Issue> issues, const std::string& text) {
  std::vector<std::string> texts;
  for (const Issue& issue : issues) texts.push_back(issue.text);
  const std::vector<vbgpd::TextPosition> at = vbgpd::issue_positions(texts, text);
  for (std::size_t i = 0; i < issues.size(); ++i) issues[i].line = at[i].line, issues[i].column = at[i].column;
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

/// After the engine was given a value of the command line.
void note_option(Scene& scene, const char* option, const char* name, vbgpd_status status) {
  if (status < 0) throw BadInput(option, errors_of(error_text(scene.profile.get())));
  scene.options[name] = option;
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
    const std::string said = fault.what(), subject = file + ": ";
    throw BadInput(file, errors_of(said.compare(0, subject.size(), subject) == 0 ? said.substr(subject.size()) : said));
  }
  if (!scene.faults.empty()) throw BadInput(file, all_errors(context, scene, text, file));
  return {profile_of(context, scene.bytes, file), std::move(text), {}};
}

void set_number(Scene& scene, const char* option, const char* name, double value) {
  note_option(scene, option, name,
              vbgpd_profile_set_f64(scene.profile.get(), VBGPD_OBJECT_PROFILE, -1, name, VBGPD_STRLEN, value));
}

void set_text(Scene& scene, const char* option, const char* name, const std::string& value) {
  note_option(scene, option, name,
              vbgpd_profile_set_text(scene.profile.get(), VBGPD_OBJECT_PROFILE, -1, name, VBGPD_STRLEN, value.c_str(),
                                     VBGPD_STRLEN));
}

std::vector<Issue> validate(const Scene& scene) {
  std::vector<Issue> issues = with_positions(validate(scene.profile.get()), scene.text);
  for (Issue& issue : issues)
    for (const auto& [name, option] : scene.options) {
      const std::string subject = "scene: " + name + " ";
      if (issue.text.compare(0, subject.size(), subject) != 0) continue;
      issue.text.replace(0, 5, option);  // nothing of it is in the file
      issue.line = issue.column = 0;
    }
  return in_order(std::move(issues));
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
    if (result.size() == kMostLines) {
      result.push_back(file + format(": and %zu more", issues.size() - kMostLines));
      break;
    }
    const std::string place = file + (issue.line == 0 ? "" : format(":%zu:%zu", issue.line, issue.column));
    result.push_back(place + (issue.error ? ": error: " : ": warning: ") + issue.text);
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
