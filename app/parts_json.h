#pragma once

#include <nlohmann/json.hpp>

#include "model/connectivity/net_check.h"
#include "model/document.h"

namespace app {

/// `nets{count, list[{name, elements, pins, vias}]}` of `info --json`.
[[nodiscard]] nlohmann::ordered_json netsJson(const model::Document& document);
/// `components{count, list[…]}`.
[[nodiscard]] nlohmann::ordered_json componentsJson(const model::Document& document);

/// What `info --check-nets` found in one step.
struct StepCheck {
    const model::Document* step = nullptr;
    std::size_t islandCount = 0;
    model::NetReport report;
};

/// Does a net fall apart where it matters: are there several islands with pads or holes? Else the rest is loose copper.
[[nodiscard]] bool hasSeveralPadIslands(const model::NetReport& report, const model::OpenNet& open);

/// `connectivity{islands, opens[], loose[], shorts[]}`.
[[nodiscard]] nlohmann::ordered_json connectivityJson(const std::vector<StepCheck>& checks);
void printConnectivity(const std::vector<StepCheck>& checks);

}  // namespace app
