#include "model/formats/drawing/layer_outlines.h"

#include <algorithm>

#include "model/formats/drawing/layer_rows.h"
#include "model/formats/steps/zone_outlines.h"

namespace model::formats {

namespace {

bool hasOwnOutline(const DrawnLayer& layer, const DrawnStep& step) {
    return !layer.outline.isEmpty() && step.copies.empty();
}

/// Which zones with a shape have the layer, one letter for each; empty if all or none have it.
std::string zonesWith(const DrawnStep& step, std::size_t row) {
    std::string key;
    for (const DrawnZone& zone : step.zones) {
        if (!zone.shape.isEmpty()) {
            key += std::ranges::find(zone.layers, static_cast<std::int32_t>(row)) != zone.layers.end() ? '1' : '0';
        }
    }
    const bool isMixed = key.find('0') != std::string::npos && key.find('1') != std::string::npos;
    return isMixed ? key : "";
}

std::string outlineKey(const DrawnJob& job, const DrawnStep& step, std::size_t row) {
    if (hasOwnOutline(job.layers[row], step)) {
        return "row " + std::to_string(row);
    }
    return isPhysical(job.layers[row]) ? zonesWith(step, row) : "";
}

Zone zoneFrom(DocumentBuilder& builder, const LayerRows& layers, const DrawnZone& from) {
    Zone zone;
    zone.name = from.name;
    for (const std::int32_t row : from.layers) {
        if (row >= 0 && static_cast<std::size_t>(row) < layers.order().size()) {
            zone.layers.push_back(layers.id(static_cast<std::size_t>(row)));
        } else {
            builder.diagnostics().report(Severity::Warning, "", 0, "a zone names a layer that is not there");
        }
    }
    std::ranges::sort(zone.layers);
    zone.layers.erase(std::unique(zone.layers.begin(), zone.layers.end()), zone.layers.end());
    if (from.shape.isEmpty()) {
        builder.diagnostics().report(Severity::Warning, "", 0, "a zone without an outline bounds no layers");
    } else {
        zone.shape = builder.addShape(from.shape);
    }
    return zone;
}

}  // namespace

std::vector<std::uint32_t> outlineGroups(const DrawnJob& job) {
    std::vector<std::string> keys(job.layers.size());
    for (const DrawnStep& step : job.steps) {
        for (std::size_t row = 0; row < keys.size(); ++row) {
            keys[row] += outlineKey(job, step, row) + "|";
        }
    }
    std::ranges::replace(keys, std::string(job.steps.size(), '|'), std::string());
    return outlineGroups(keys);
}

void addOutlines(DocumentBuilder& builder, const DrawnJob& job, const LayerRows& layers, const DrawnStep& step) {
    for (const DrawnZone& zone : step.zones) {
        builder.addZone(zoneFrom(builder, layers, zone));
    }
    ZoneOutlines zones(builder);
    for (const std::size_t row : layers.order()) {
        const DrawnLayer& from = job.layers[row];
        if (hasOwnOutline(from, step)) {
            builder.layer(layers.id(row)).profile = builder.addShape(from.outline);
        } else if (isPhysical(from)) {
            builder.layer(layers.id(row)).profile = zones.of(layers.id(row));
        }
    }
}

}  // namespace model::formats
