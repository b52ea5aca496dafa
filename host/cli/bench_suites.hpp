// SPDX-License-Identifier: Apache-2.0
// The suites of `cdsm bench`. Each measures in one process and returns its tables.
#pragma once

#include <vector>

#include "bench_subject.hpp"

namespace cdsm::cli {

/// What shadows cost in a frame, what a map costs, what shadow rays would cost.
std::vector<Table> benchDemo(const BenchOptions& options);

/// [Knecht 2011, Tables 5.1 to 5.4]: times against the size of the maps, with and without clusters.
std::vector<Table> benchMapSize(const BenchOptions& options);

/// [Knecht 2011, Tables 5.5 to 5.7]: times and nodes against the resolution of a volume.
std::vector<Table> benchVolumeSize(const BenchOptions& options);

/// [Knecht 2011, Tables 5.8 to 5.10]: times and nodes against the tolerance of the compression.
std::vector<Table> benchTolerance(const BenchOptions& options);

/// [Knecht 2011, Figure 5.13]: times against the number of objects.
std::vector<Table> benchObjects(const BenchOptions& options);

/// [Knecht 2011, Table 5.11]: memory that chunks take and waste.
std::vector<Table> benchChunks(const BenchOptions& options);

/// [Knecht 2011, Figure 5.14]: frame rates while the camera moves.
std::vector<Table> benchGallery(const BenchOptions& options);

/// [Weidner & Linsen 2018, Tables 3 and 4]: stochastic shadows against shadow maps and deep shadow maps.
std::vector<Table> benchStochastic(const BenchOptions& options);

/// [Krone 2017, Fig. 8]: molecules by local lighting, implicit sphere shadow maps and ambient occlusion.
std::vector<Table> benchSpheres(const BenchOptions& options);

/// What clusters are for: the error of shadows, and what they cost.
std::vector<Table> benchClustering(const BenchOptions& options);

/// Memory strategies and formats of nodes side by side, on scenes and sizes of maps.
std::vector<Table> benchMemory(const BenchOptions& options);

/// [Ropinski 2008, Tables 1 and 2]: techniques with and without a shadow volume, camera or light moving.
std::vector<Table> benchTechniques(const BenchOptions& options);

/// Transmittances at points in arrays of the host, and what the call costs beside the kernel.
std::vector<Table> benchQuery(const BenchOptions& options);

}  // namespace cdsm::cli
