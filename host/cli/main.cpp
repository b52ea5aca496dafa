// SPDX-License-Identifier: Apache-2.0
// The tool `cdsm`: a command line in; exit status 0, 1 (input or device at fault) or 2 (command line wrong) out.
// What goes wrong becomes one line on stderr that begins with "error: ".
#include <exception>
#include <iostream>
#include <new>
#include <string>

#include <CLI/CLI.hpp>

#include <cdsm/error.hpp>

#include "commands.hpp"

namespace {

using namespace cdsm::cli;

constexpr void (*kCommands[])(CLI::App&) = {addDevicesCommand,   addRenderCommand,  addTransmittanceCommand,
                                            addExportMapCommand, addCompareCommand, addBenchCommand};

int fail(int status, std::string message) {
  for (char& c : message) {
    if (c == '\n' || c == '\r') c = ' ';
  }
  std::cerr << "error: " << message << '\n';
  return status;
}

/// CLI11 would say of a misspelt command only that one is missing.
void checkCommand(const CLI::App& app, int argc, char** argv) {
  const std::string name = argc > 1 ? argv[1] : "";
  const auto isNamed = [&name](const CLI::App* command) { return command->get_name() == name; };
  if (name.empty() || name[0] == '-' || !app.get_subcommands(isNamed).empty()) return;
  throw UsageError("unknown command '" + name + "'; see 'cdsm --help'");
}

int run(CLI::App& app, int argc, char** argv) {
  try {
    checkCommand(app, argc, argv);
    app.parse(argc, argv);
    return 0;
  } catch (const CLI::Success& help) {
    return app.exit(help);
  } catch (const CLI::ParseError& error) {
    return fail(2, std::string(error.what()) + "; see 'cdsm --help' or 'cdsm COMMAND --help'");
  } catch (const UsageError& error) {
    return fail(2, error.what());
  } catch (const std::bad_alloc&) {
    return fail(1, "the machine's memory is full, the input must be smaller");
  } catch (const std::exception& error) {
    return fail(1, error.what());
  }
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app(
      "Clustered deep shadow maps: images of transparent surfaces and volumes, and the light that reaches a point.",
      "cdsm");
  app.require_subcommand(1);
  for (const auto addCommand : kCommands) addCommand(app);
  return run(app, argc, argv);
}
