#include "app/clearance/through_stackup.h"

#include <algorithm>
#include <cstdio>

#include "model/base/thickness_units.h"
#include "model/board/copies.h"
#include "model/export/stackup_clearance_export.h"

namespace app {

namespace {

base::Result<model::StackupClearanceRequest> requestFor(const model::Document& board,
                                                        const ClearanceArguments& arguments) {
    model::StackupClearanceRequest request;
    request.count = arguments.worst;
    if (!arguments.below.empty()) {
        ASSIGN_OR_RETURN(const base::Nm below, model::parseLength(arguments.below));
        request.below = static_cast<double>(below);
    }
    const std::vector<const model::Document*> steps = model::distinctSteps(board);
    for (const std::string& name : arguments.nets) {
        const auto hasNet = [&](const model::Document* step) { return step->findNet(name).isValid(); };
        if (std::ranges::none_of(steps, hasNet)) {
            return base::Error{base::ErrorCode::BadUsage, "the board has no net " + name};
        }
    }
    if (!arguments.nets.empty() && arguments.nets.front() == arguments.nets.back()) {
        return base::Error{base::ErrorCode::BadUsage, "a net has no clearance to itself: --nets names two"};
    }
    if (!arguments.nets.empty()) {
        request.between = {arguments.nets.front(), arguments.nets.back()};
    }
    return request;
}

/// Copper that is not measured, as it has no net.
void noteWithoutNets(const model::Document& board) {
    std::size_t count = 0;
    for (const model::Document* step : model::distinctSteps(board)) {
        for (const model::Layer& layer : step->layers) {
            for (std::uint32_t i = 0; layer.isCopper() && i < layer.elements.count; ++i) {
                count += step->elements.net[layer.elements.first + i].isValid() ? 0 : 1;
            }
        }
    }
    if (count > 0) {
        std::fprintf(stderr, "copperscope: %zu copper elements without a net were not measured\n", count);
    }
}

}  // namespace

base::Result<ThroughStackup> runThroughStackup(const ClearanceArguments& arguments, const model::Document& board,
                                               base::Progress& progress) {
    ASSIGN_OR_RETURN(const model::StackupClearanceRequest request, requestFor(board, arguments));
    ASSIGN_OR_RETURN(const std::vector<model::StackupClearance> found,
                     model::smallestThroughStackup(board, request, progress));
    noteWithoutNets(board);
    return ThroughStackup{
        model::stackupClearanceReport(board, found,
                                      model::reportFormatOf(arguments.format).value_or(model::ReportFormat::Text)),
        !arguments.below.empty() && !found.empty() ? kTooClose : kDone};
}

}  // namespace app
