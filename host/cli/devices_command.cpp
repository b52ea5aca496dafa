// SPDX-License-Identifier: Apache-2.0
// `cdsm devices`: the OpenCL devices, what each can do and how the engine would use it.
#include <algorithm>
#include <iomanip>
#include <iostream>
#include <memory>
#include <sstream>
#include <string>
#include <vector>

#include <cdsm/cdsm.hpp>

#include "commands.hpp"
#include "engine/stats_json.hpp"

namespace cdsm::cli {
namespace {

using Row = std::vector<std::string>;

std::string gibibytes(std::uint64_t bytes) {
  std::ostringstream text;
  text << std::fixed << std::setprecision(1) << static_cast<double>(bytes) / (1024.0 * 1024.0 * 1024.0) << " GiB";
  return text.str();
}

Row rowOf(const DeviceDescription& device) {
  const std::string use = device.unusable.empty() ? device.fetch : "unusable: " + device.unusable;
  return {device.id, device.name, device.platform, device.type, gibibytes(device.memoryBytes), use};
}

/// Columns as wide as their widest entry, the last one ragged.
void printTable(const std::vector<Row>& rows) {
  std::vector<std::size_t> widths(rows.front().size(), 0);
  for (const Row& row : rows) {
    for (std::size_t i = 0; i < row.size(); ++i) widths[i] = std::max(widths[i], row[i].size());
  }
  for (const Row& row : rows) {
    for (std::size_t i = 0; i + 1 < row.size(); ++i) {
      std::cout << std::left << std::setw(static_cast<int>(widths[i]) + 2) << row[i];
    }
    std::cout << row.back() << '\n';
  }
}

void printDevices(bool asJson) {
  const std::vector<DeviceDescription> devices = listDevices();
  if (asJson) {
    std::cout << engine::devicesJson(devices);
  } else if (devices.empty()) {
    std::cout << "No OpenCL device found. A driver such as PoCL (package pocl-opencl-icd) makes the CPU one.\n";
  } else {
    std::vector<Row> rows{{"id", "name", "platform", "type", "memory", "fetch"}};
    for (const DeviceDescription& device : devices) rows.push_back(rowOf(device));
    printTable(rows);
  }
  if (!std::cout.flush()) throw Error("the list cannot be written to standard output");
}

}  // namespace

void addDevicesCommand(CLI::App& app) {
  CLI::App* command = app.add_subcommand("devices", "List the OpenCL devices and what the engine would use of them");
  auto asJson = std::make_shared<bool>(false);
  command->add_flag("--json", *asJson, "For programs: every property, as JSON");
  command->final_callback([asJson] { printDevices(*asJson); });
}

}  // namespace cdsm::cli
