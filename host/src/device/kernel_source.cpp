// SPDX-License-Identifier: Apache-2.0
// Joins kernel files. In: a ProgramSource and the embedded (or CDSM_KERNELS') files; out: one text with #line marks.
#include "device/kernel_source.hpp"

#include <cstdlib>
#include <cstring>
#include <fstream>
#include <iterator>
#include <optional>
#include <set>
#include <sstream>

#include <cdsm/error.hpp>

#include "device/embedded_file.hpp"

namespace cdsm::device {
namespace {

std::optional<std::string> readEmbedded(const std::string& path) {
  for (std::size_t i = 0; i < embeddedFileCount(); ++i) {
    if (path == embeddedFiles()[i].path) return std::string(embeddedFiles()[i].text);
  }
  return std::nullopt;
}

std::optional<std::string> readFromDisk(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  if (!file) return std::nullopt;
  return std::string(std::istreambuf_iterator<char>(file), {});
}

std::optional<std::string> readKernelFile(const ProgramSource& source, const std::string& path) {
  const auto generated = source.generated.find(path);
  if (generated != source.generated.end()) return generated->second;
  if (!path.empty() && path.front() == '/') return readFromDisk(path);
  const char* folder = std::getenv("CDSM_KERNELS");
  return folder && *folder ? readFromDisk(std::string(folder) + "/" + path) : readEmbedded(path);
}

bool isQuoted(const std::string& value) { return value.size() >= 2 && value.front() == '"' && value.back() == '"'; }

/// What follows the directive on the line without the blanks around it; nullopt if the line is another one.
std::optional<std::string> afterDirective(const std::string& line, const char* directive) {
  const std::size_t length = std::strlen(directive);
  if (line.compare(0, length, directive) != 0) return std::nullopt;
  const std::size_t first = line.find_first_not_of(" \t", length);
  if (first == std::string::npos) return std::string();
  return line.substr(first, line.find_last_not_of(" \t\r") + 1 - first);
}

class Joiner {
 public:
  explicit Joiner(const ProgramSource& source) : source_(source) {}

  std::string join() {
    for (const auto& [name, value] : source_.defines) {
      if (!isQuoted(value)) out_ << "#define " << name << ' ' << (value.empty() ? "1" : value) << '\n';
    }
    append(source_.entry, std::nullopt);
    return out_.str();
  }

 private:
  void append(const std::string& path, const std::optional<Location>& from) {
    if (!seen_.insert(path).second) return;
    const std::optional<std::string> text = readKernelFile(source_, path);
    if (!text) fail("kernel file '" + path + "' does not exist; paths count from the kernels folder", from);
    mark(path, 1);
    std::istringstream lines(*text);
    std::string line;
    for (int number = 1; std::getline(lines, line); ++number) appendLine(path, number, line);
  }

  void appendLine(const std::string& path, int number, const std::string& line) {
    if (afterDirective(line, "#pragma once")) {
      out_ << '\n';
      return;
    }
    const std::optional<std::string> target = afterDirective(line, "#include");
    if (!target || (!target->empty() && target->front() == '<')) {
      out_ << line << '\n';
      return;
    }
    const Location here{"kernels/" + path, number, 1};
    append(resolve(*target, here), here);
    mark(path, number + 1);
  }

  /// The path that `#include TARGET` means: in quotes (a comment may follow), or the name of a define that is.
  std::string resolve(const std::string& target, const Location& here) const {
    const std::size_t close = target.size() > 1 && target.front() == '"' ? target.find('"', 1) : std::string::npos;
    if (close != std::string::npos) return target.substr(1, close - 1);
    const std::string name = target.substr(0, target.find_first_of(" \t"));
    for (const auto& [defined, value] : source_.defines) {
      if (defined == name && isQuoted(value)) return value.substr(1, value.size() - 2);
    }
    fail("#include needs a path in quotes or a name that the program defines as one, not '" + target + "'", here);
  }

  void mark(const std::string& path, int nextLine) { out_ << "#line " << nextLine << " \"kernels/" << path << "\"\n"; }

  [[noreturn]] static void fail(const std::string& message, const std::optional<Location>& where) {
    if (where) throw Error(*where, message);
    throw Error(message);
  }

  const ProgramSource& source_;
  std::set<std::string> seen_;
  std::ostringstream out_;
};

}  // namespace

std::string joinSource(const ProgramSource& source) { return Joiner(source).join(); }

}  // namespace cdsm::device
