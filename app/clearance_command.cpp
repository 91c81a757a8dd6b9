#include "app/clearance_command.h"

#include <algorithm>
#include <cstdio>
#include <fstream>
#include <iterator>
#include <nlohmann/json.hpp>

#include "app/console_progress.h"
#include "app/exit_code.h"
#include "app/json_text.h"
#include "app/rule_report.h"
#include "model/base/units.h"
#include "model/clearance/clearance.h"
#include "model/copies.h"
#include "model/export_text.h"
#include "model/session/length_text.h"

namespace app {

using model::Clearance;
using model::Document;

namespace {

/// The narrowest places of one step.
struct StepClearances {
    const Document* step = nullptr;
    std::vector<Clearance> clearances;
};

base::Error unknown(const char* kind, const std::string& name) {
    return {base::ErrorCode::BadUsage, "the board has no " + std::string(kind) + " " + name};
}

base::Result<model::ClearanceQuestion> questionFor(const Document& document, const ClearanceArguments& arguments) {
    model::ClearanceQuestion question;
    question.count = arguments.worst;
    if (!arguments.below.empty()) {
        const base::Result<base::Nm> below = model::session::parseLength(arguments.below);
        if (!below) {
            return below.error();
        }
        question.below = static_cast<double>(*below);
    }
    if (!arguments.layer.empty()) {
        question.layer = document.findLayer(arguments.layer);
        if (!question.layer.isValid() || !document.layer(question.layer).isCopper()) {
            return unknown("copper layer", arguments.layer);
        }
    }
    if (!arguments.nets.empty()) {
        const model::NetId a = document.findNet(arguments.nets.front());
        const model::NetId b = document.findNet(arguments.nets.back());
        if (!a.isValid() || !b.isValid()) {
            return unknown("net", a.isValid() ? arguments.nets.back() : arguments.nets.front());
        }
        if (a == b) {
            return base::Error{base::ErrorCode::BadUsage, "a net has no clearance to itself: --nets names two"};
        }
        question.between = {a, b};
    }
    return question;
}

std::string netName(const Document& document, model::NetId net) {
    return net.isValid() ? document.nets[net.row()].name : "(no net)";
}

double micrometres(double nm) {
    return nm / base::kNmPerUm;
}

void printText(const StepClearances& found) {
    const Document& step = *found.step;
    std::printf("step %s: %zu clearances\n", step.job.step.c_str(), found.clearances.size());
    if (!found.clearances.empty()) {
        std::printf("%10s  %-20s %11s %11s  %-32s %s\n", "gap um", "layer", "x mm", "y mm", "net", "net");
    }
    for (const Clearance& c : found.clearances) {
        std::printf("%10.3f  %-20s %11.4f %11.4f  %-32s %s\n", micrometres(c.gap.distance),
                    step.layer(c.layer).name.c_str(), base::toMm(c.gap.from.x), base::toMm(c.gap.from.y),
                    netName(step, c.netA).c_str(), netName(step, c.netB).c_str());
    }
}

void printCsv(const StepClearances& found) {
    for (const Clearance& c : found.clearances) {
        std::printf("%s,%s,%.3f,%s,%s,%.6f,%.6f,%.6f,%.6f\n", model::csvField(found.step->job.step).c_str(),
                    model::csvField(found.step->layer(c.layer).name).c_str(), micrometres(c.gap.distance),
                    model::csvField(netName(*found.step, c.netA)).c_str(),
                    model::csvField(netName(*found.step, c.netB)).c_str(), base::toMm(c.gap.from.x),
                    base::toMm(c.gap.from.y), base::toMm(c.gap.to.x), base::toMm(c.gap.to.y));
    }
}

nlohmann::ordered_json toJson(const StepClearances& found) {
    nlohmann::ordered_json list = nlohmann::ordered_json::array();
    for (const Clearance& c : found.clearances) {
        list.push_back({{"gap_um", micrometres(c.gap.distance)},
                        {"layer", found.step->layer(c.layer).name},
                        {"nets", {netName(*found.step, c.netA), netName(*found.step, c.netB)}},
                        {"elements", {c.a.value, c.b.value}},
                        {"from_mm", {base::toMm(c.gap.from.x), base::toMm(c.gap.from.y)}},
                        {"to_mm", {base::toMm(c.gap.to.x), base::toMm(c.gap.to.y)}}});
    }
    return {{"step", found.step->job.step}, {"clearances", list}};
}

void print(const std::vector<StepClearances>& found, const std::string& format) {
    if (format == "json") {
        nlohmann::ordered_json steps = nlohmann::ordered_json::array();
        for (const StepClearances& step : found) {
            steps.push_back(toJson(step));
        }
        std::fputs(jsonText({{"steps", steps}}).c_str(), stdout);
        return;
    }
    if (format == "csv") {
        std::printf("step,layer,gap um,net a,net b,x mm on a,y mm on a,x mm on b,y mm on b\n");
    }
    for (const StepClearances& step : found) {
        format == "csv" ? printCsv(step) : printText(step);
    }
}

/// Has the step copper that no net says anything about?
bool isCopperWithoutNets(const Document& step) {
    return step.nets.empty() && std::ranges::any_of(step.layers, [](const model::Layer& layer) {
               return layer.isCopper() && layer.elements.count > 0;
           });
}

/// Every step once; those without copper have nothing to say.
base::Result<std::vector<StepClearances>> measureSteps(const Document& board, const ClearanceArguments& arguments,
                                                       base::Progress& progress) {
    std::vector<StepClearances> found;
    bool hasNets = false;
    std::vector<std::string> unmeasured;
    for (const Document* step : model::distinctSteps(board)) {
        hasNets = hasNets || !step->nets.empty();
        if (isCopperWithoutNets(*step)) {
            unmeasured.push_back(step->job.step);
        }
        if (step->nets.empty()) {
            continue;
        }
        const base::Result<model::ClearanceQuestion> question = questionFor(*step, arguments);
        if (!question) {
            return question.error();
        }
        base::Result<std::vector<Clearance>> clearances = model::narrowestClearances(*step, *question, progress);
        if (!clearances) {
            return clearances.error();
        }
        found.push_back({step, std::move(*clearances)});
    }
    if (!hasNets) {
        return base::Error{base::ErrorCode::BadInput,
                           "the board has no nets, so nothing can be too close; --infer-nets finds them in the copper"};
    }
    for (const std::string& name : unmeasured) {
        std::fprintf(stderr, "copperscope: step %s has copper but no nets; it was not measured\n", name.c_str());
    }
    return found;
}

base::Result<model::RuleTable> readRules(const std::string& path) {
    if (path == "default") {
        return model::defaultRules();
    }
    std::ifstream file(path, std::ios::binary);
    if (!file) {
        return base::Error{base::ErrorCode::BadInput, path + " cannot be read"};
    }
    return model::parseRules(std::string(std::istreambuf_iterator<char>(file), {}));
}

int runRules(const ClearanceArguments& arguments, const Document& board, base::Progress& progress) {
    const base::Result<model::RuleTable> table = readRules(arguments.rules);
    if (!table) {
        return fail(table.error());
    }
    std::vector<StepRules> steps;
    for (const Document* step : model::distinctSteps(board)) {
        base::Result<model::RuleReport> report = model::checkRules(*step, *table, progress);
        if (!report) {
            return fail(report.error());
        }
        steps.push_back({step, std::move(*report)});
    }
    printRules(*table, steps, arguments.format, arguments.worst);
    const bool isPassed = std::ranges::all_of(steps, [](const StepRules& s) { return s.report.isPassed(); });
    return isPassed ? kDone : kTooClose;
}

}  // namespace

int runClearance(const ClearanceArguments& arguments) {
    ConsoleProgress console;
    const auto board = openDocument(arguments.board, console.progress());
    if (!board) {
        return fail(board.error());
    }
    if (!arguments.rules.empty()) {
        return runRules(arguments, **board, console.progress());
    }
    const auto found = measureSteps(**board, arguments, console.progress());
    if (!found) {
        return fail(found.error());
    }
    print(*found, arguments.format);
    const bool isAnyClose = std::ranges::any_of(*found, [](const StepClearances& s) { return !s.clearances.empty(); });
    return !arguments.below.empty() && isAnyClose ? kTooClose : kDone;
}

}  // namespace app
