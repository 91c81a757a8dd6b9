#include "app/reports/parts_json.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "model/board/layers.h"
#include "model/clearance/clearance.h"
#include "model/index/attributes.h"
#include "model/index/pin_names.h"
#include "model/nets/net_inference.h"
#include "model/nets/net_statistics.h"

namespace app {

using model::Document;
using model::StepCheck;
using nlohmann::ordered_json;

namespace {

ordered_json locationJson(const Document& document, model::LayerId layer, model::PointD location) {
    return {{"layer", layer.isValid() ? document.layer(layer).name : ""},
            {"x_nm", std::llround(location.x)},
            {"y_nm", std::llround(location.y)}};
}

const std::string& nameOf(const Document& document, model::NetId net) {
    return document.nets[net.row()].name;
}

const std::string& refdesOf(const Document& document, model::ComponentId component) {
    return document.components[component.row()].refdes;
}

ordered_json openJson(const StepCheck& check, const model::OpenNet& open) {
    ordered_json islands = ordered_json::array();
    for (const model::NetIsland& island : check.report.islandsOf(open)) {
        ordered_json json = locationJson(*check.step, island.layer, island.location);
        json["element"] = island.element.value;
        json["pieces"] = island.pieceCount;
        json["pads"] = island.padCount;
        islands.push_back(json);
    }
    return {{"step", check.step->job.step}, {"net", nameOf(*check.step, open.net)}, {"islands", islands}};
}

ordered_json shortJson(const StepCheck& check, const model::ShortedNets& entry) {
    ordered_json json = locationJson(*check.step, entry.layer, entry.location);
    json["step"] = check.step->job.step;
    json["nets"] = {nameOf(*check.step, entry.a), nameOf(*check.step, entry.b)};
    json["elements"] = {entry.elementA.value, entry.elementB.value};
    json["through_element"] = entry.through.isValid() ? ordered_json(entry.through.value) : ordered_json();
    json["contacts"] = entry.contactCount;
    json["component"] =
        entry.component.isValid() ? ordered_json(refdesOf(*check.step, entry.component)) : ordered_json();
    return json;
}

ordered_json tieJson(const StepCheck& check, const model::NetTie& tie) {
    ordered_json json = locationJson(*check.step, tie.layer, tie.location);
    json["step"] = check.step->job.step;
    json["component"] = refdesOf(*check.step, tie.component);
    json["assumed"] = tie.isAssumed;
    json["nets"] = {nameOf(*check.step, tie.netA), nameOf(*check.step, tie.netB)};
    json["element"] = tie.element.value;
    return json;
}

ordered_json pinOnNetJson(const StepCheck& check, const model::PinOnNet& entry) {
    ordered_json json = locationJson(*check.step, entry.layer, entry.location);
    json["step"] = check.step->job.step;
    json["pin"] = model::fullPinName(*check.step, entry.pin);
    json["net"] = nameOf(*check.step, entry.net);
    json["elements"] = {entry.pad.value, entry.copper.value};
    return json;
}

/// Nothing where there are none, which is usual.
std::string pinsOnNetsText(std::size_t count) {
    return count == 0 ? "" : ", " + std::to_string(count) + " pins without a net that touch one";
}

void printOpen(const StepCheck& check, const model::OpenNet& open) {
    const bool isOpen = model::hasSeveralPadIslands(check.report, open);
    std::printf("  %-8s %s: %u islands\n", isOpen ? "open" : "floating", nameOf(*check.step, open.net).c_str(),
                open.islandCount);
    constexpr std::size_t kShown = 4;
    for (const model::NetIsland& island :
         check.report.islandsOf(open).first(std::min<std::size_t>(kShown, open.islandCount))) {
        std::printf("           %u pieces, %u pads or holes, on %s at %.4f, %.4f mm\n", island.pieceCount,
                    island.padCount, check.step->layer(island.layer).name.c_str(), base::toMm(island.location.x),
                    base::toMm(island.location.y));
    }
}

void printShort(const StepCheck& check, const model::ShortedNets& entry) {
    std::printf("  short  %s and %s %s on %s at %.4f, %.4f mm\n", nameOf(*check.step, entry.a).c_str(),
                nameOf(*check.step, entry.b).c_str(), model::textOf(*check.step, entry).c_str(),
                check.step->layer(entry.layer).name.c_str(), base::toMm(entry.location.x),
                base::toMm(entry.location.y));
}

}  // namespace

ordered_json netsJson(const Document& document) {
    const std::vector<std::uint32_t> pins = model::pinCounts(document);
    const std::vector<std::uint32_t> vias = model::viaCounts(document);
    ordered_json list = ordered_json::array();
    for (std::size_t row = 0; row < document.nets.size(); ++row) {
        list.push_back({{"name", document.nets[row].name},
                        {"elements", document.elementsOf(model::NetId{row}).size()},
                        {"pins", pins[row]},
                        {"vias", vias[row]}});
    }
    return {{"count", document.nets.size()}, {"list", list}};
}

/// Nothing for a component without a body.
ordered_json bodyJson(const model::Body* body) {
    if (body == nullptr) {
        return nullptr;
    }
    return {{"element", body->element.value}, {"height_nm", body->height}, {"source", model::toString(body->source)}};
}

/// Null on the outermost layer of a side, and for a component without a body.
ordered_json mountingLayerJson(const Document& document, const model::Body* body) {
    const model::LayerId layer = body != nullptr ? model::mountingLayerOf(document, *body) : model::LayerId{};
    return layer.isValid() ? ordered_json(document.layer(layer).name) : ordered_json();
}

ordered_json componentsJson(const Document& document) {
    std::vector<const model::Body*> bodies(document.components.size());
    for (const model::Body& body : document.bodies) {
        bodies[body.component.row()] = &body;
    }
    ordered_json list = ordered_json::array();
    for (std::size_t row = 0; row < document.components.size(); ++row) {
        const model::Component& component = document.components[row];
        list.push_back({{"refdes", component.refdes},
                        {"part", component.part},
                        {"package", component.package.isValid() ? document.packages[component.package.row()].name : ""},
                        {"side", model::toString(component.side)},
                        {"mounting_layer", mountingLayerJson(document, bodies[row])},
                        {"x_nm", component.placement.origin.x},
                        {"y_nm", component.placement.origin.y},
                        {"clockwise_deg", component.placement.clockwiseDeg},
                        {"placed", component.isPlaced},
                        {"height_nm", component.height},
                        {"body", bodyJson(bodies[row])},
                        {"mount", model::toString(component.mount)},
                        {"populated", component.isPopulated},
                        {"in_bom", model::isInBom(document, component)},
                        {"pins", component.pinCount}});
    }
    return {{"count", document.components.size()}, {"list", list}};
}

ordered_json connectivityJson(const std::vector<StepCheck>& checks) {
    std::size_t islands = 0;
    ordered_json opens = ordered_json::array();
    ordered_json floating = ordered_json::array();
    ordered_json shorts = ordered_json::array();
    ordered_json ties = ordered_json::array();
    ordered_json pinsOnNets = ordered_json::array();
    ordered_json withoutNets = ordered_json::array();
    for (const StepCheck& check : checks) {
        islands += check.islandCount;
        if (model::isCopperWithoutNets(*check.step)) {
            withoutNets.push_back(check.step->job.step);
        }
        for (const model::OpenNet& open : check.report.opens) {
            (model::hasSeveralPadIslands(check.report, open) ? opens : floating).push_back(openJson(check, open));
        }
        for (const model::ShortedNets& entry : check.report.shorts) {
            shorts.push_back(shortJson(check, entry));
        }
        for (const model::NetTie& tie : check.report.ties) {
            ties.push_back(tieJson(check, tie));
        }
        for (const model::PinOnNet& entry : check.report.pinsOnNets) {
            pinsOnNets.push_back(pinOnNetJson(check, entry));
        }
    }
    return {{"islands", islands},
            {"opens", opens},
            {"floating", floating},
            {"loose", floating},
            {"shorts", shorts},
            {"net_ties", ties},
            {"pins_without_net", pinsOnNets},
            {"steps_without_nets", withoutNets}};
}

void printConnectivity(const std::vector<StepCheck>& checks) {
    std::printf("\nnets against copper\n");
    for (const StepCheck& check : checks) {
        if (model::isCopperWithoutNets(*check.step)) {
            std::printf("  %s: not compared: it has copper but no nets\n", check.step->job.step.c_str());
            continue;
        }
        for (const model::OpenNet& open : check.report.opens) {
            printOpen(check, open);
        }
        for (const model::ShortedNets& entry : check.report.shorts) {
            printShort(check, entry);
        }
        for (const model::NetTie& tie : check.report.ties) {
            std::printf("  net tie  %s at %.4f, %.4f mm\n", model::textOf(*check.step, tie).c_str(),
                        base::toMm(tie.location.x), base::toMm(tie.location.y));
        }
        for (const model::PinOnNet& entry : check.report.pinsOnNets) {
            std::printf("  no net   %s on %s at %.4f, %.4f mm\n", model::textOf(*check.step, entry).c_str(),
                        check.step->layer(entry.layer).name.c_str(), base::toMm(entry.location.x),
                        base::toMm(entry.location.y));
        }
        if (model::areNetsOfCopper(*check.step) && check.report.opens.empty() && check.report.shorts.empty()) {
            std::printf("  %s: its nets follow from its copper, so that shorts and opens are not to be found\n",
                        check.step->job.step.c_str());
        }
        std::printf("  %s: %zu islands of copper, %zu nets in several islands, %zu shorts, %zu net ties%s\n",
                    check.step->job.step.c_str(), check.islandCount, check.report.opens.size(),
                    check.report.shorts.size(), check.report.ties.size(),
                    pinsOnNetsText(check.report.pinsOnNets.size()).c_str());
    }
}

}  // namespace app
