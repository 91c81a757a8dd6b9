#pragma once

#include <span>
#include <string>
#include <utility>
#include <vector>

#include "model/base/progress.h"
#include "model/base/result.h"
#include "model/board/document.h"

namespace model {

/// Numbers per net, row n for NetId n; 28 bytes a net.
struct NetStatistics {
    std::vector<std::uint32_t> pins;      ///< of components
    std::vector<std::uint32_t> vias;      ///< plated holes that are there to join layers
    std::vector<double> lengthNm;         ///< of all tracks on copper layers that are no pads
    std::vector<double> areaNm2;          ///< of what is drawn on copper layers; where two elements overlap, twice
    std::vector<std::uint32_t> nameRank;  ///< place among all names in the order people count: NET2 before NET10
};

/// Over all cores, same result with any number of threads. Errors: Cancelled.
[[nodiscard]] base::Result<NetStatistics> measureNets(const Document& document, base::Progress& progress);

/// Routed length of a net per copper layer, layers without any left out; nm.
[[nodiscard]] std::vector<std::pair<LayerId, double>> routedLengths(const Document& document, NetId net);

/// Pins of components by net.
[[nodiscard]] std::vector<std::uint32_t> pinCounts(const Document& document);
/// Plated holes that are there to join layers, by net.
[[nodiscard]] std::vector<std::uint32_t> viaCounts(const Document& document);

/// The place of each name among all in the order of isNamedBefore.
[[nodiscard]] std::vector<std::uint32_t> ranksOf(std::span<const std::string> names);

/// Whether `a` comes before `b`: case does not matter, runs of digits count as numbers; equal ones by their bytes.
[[nodiscard]] bool isNamedBefore(std::string_view a, std::string_view b);

}  // namespace model
