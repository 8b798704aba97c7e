// A scene file as a profile of the engine.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "engine.h"

namespace cli {

struct Scene {
  Profile profile;
  std::string text;                            ///< of the file
  std::map<std::string, std::string> options;  ///< numbers and names that the command line gives instead, and how
};

/// Reads a scene file. Throws BadInput with all that is wrong: no such file, not readable, not text, not JSON, not a
/// scene; where the text has faults, also what the engine has to say about the rest of the scene.
Scene read_scene(vbgpd_context* context, const std::string& file);

/// A number of the command line ("--spacing") in place of the file's. Throws BadInput.
void set_number(Scene& scene, const char* option, const char* name, double value);
/// A name likewise.
void set_text(Scene& scene, const char* option, const char* name, const std::string& value);

/// What the engine has to say about a scene, with the places in its file.
std::vector<Issue> validate(const Scene& scene);

/// Particles and bonds of a profile. Throws BadInput when the scene cannot be discretised.
Model create_model(vbgpd_context* context, const vbgpd_profile* profile, const std::string& file);

/// The engine lists several faults in one text, a line each.
std::vector<Issue> errors_of(const std::string& text);

/// Issues as lines for a person, each naming the file: "slope.json:6:14: error: material 'clay' ...".
std::vector<std::string> lines(const std::vector<Issue>& issues, const std::string& file);

/// The lines on stderr.
void print_issues(const std::vector<Issue>& issues, const std::string& file);

bool has_error(const std::vector<Issue>& issues);

}  // namespace cli
