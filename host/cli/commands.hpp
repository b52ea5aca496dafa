// SPDX-License-Identifier: Apache-2.0
// The tool's commands. Each adds itself with its options to the app and runs when the command line names it.
#pragma once

#include <stdexcept>

#include <CLI/CLI.hpp>

namespace cdsm::cli {

/// A wrong command line that CLI11 cannot tell: exit status 2, while a cdsm::Error is 1.
class UsageError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

void addDevicesCommand(CLI::App& app);
void addRenderCommand(CLI::App& app);
void addTransmittanceCommand(CLI::App& app);
void addExportMapCommand(CLI::App& app);
void addCompareCommand(CLI::App& app);
void addBenchCommand(CLI::App& app);

}  // namespace cdsm::cli
