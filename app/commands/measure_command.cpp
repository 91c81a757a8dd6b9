#include "app/commands/measure_command.h"

#include <cstdio>
#include <nlohmann/json.hpp>

#include "app/commands/measure_item_text.h"
#include "app/common/console_progress.h"
#include "app/common/incomplete_job.h"
#include "model/base/thickness_units.h"
#include "model/measure/net_path.h"
#include "model/measure/separation.h"
#include "model/measure/sizes.h"
#include "model/text/formatting.h"
#include "model/text/json_text.h"

namespace app {

using model::BoardIndex;
using model::MeasureItem;
using model::NetPath;
using model::PieceDistance;
using model::Separation;
using nlohmann::ordered_json;

namespace {

/// What was requested, understood.
struct Request {
    MeasureItem from;
    MeasureItem to;
    std::optional<base::Nm> below;
};

base::Result<Request> requestFrom(const BoardIndex& index, const MeasureArguments& arguments) {
    ASSIGN_OR_RETURN(const MeasureItem from, parseItem(index, arguments.from));
    ASSIGN_OR_RETURN(const MeasureItem to, parseItem(index, arguments.to));
    Request request{from, to, {}};
    if (!arguments.below.empty()) {
        ASSIGN_OR_RETURN(const auto below, model::parseLength(arguments.below));
        request.below = below;
    }
    return request;
}

std::string layerName(const BoardIndex& index, model::LayerId layer) {
    return layer.isValid() ? index.board->layer(layer).name : "";
}

std::string netName(const BoardIndex& index, const model::Piece& piece) {
    const model::NetId net = model::netOf(index, piece.at);
    return net.isValid() ? index.stepOf(piece.at.copy).nets[net.row()].name : "";
}

struct NamedDistance {
    const char* key;
    const char* text;
    const std::optional<PieceDistance>& shortest;
};

std::array<NamedDistance, 3> distancesOf(const Separation& separation) {
    return {NamedDistance{"on_layer", "on one layer", separation.onLayer},
            NamedDistance{"through_stackup", "through the stackup", separation.throughStackup},
            NamedDistance{"in_plane", "in the plane", separation.inPlane}};
}

std::optional<double> angleOf(const BoardIndex& index, const Request& request) {
    const auto* a = std::get_if<model::BoardElement>(&request.from);
    const auto* b = std::get_if<model::BoardElement>(&request.to);
    return a != nullptr && b != nullptr ? model::angleBetween(index, *a, *b) : std::nullopt;
}

ordered_json endJson(const BoardIndex& index, const model::Piece& piece, base::PointD at) {
    ordered_json end = {{"copy", piece.at.copy},        {"element", nullptr}, {"layer", layerName(index, piece.layer)},
                        {"net", netName(index, piece)}, {"x_nm", at.x},       {"y_nm", at.y}};
    if (piece.at.element.isValid()) {
        end["element"] = piece.at.element.value;
    }
    return end;
}

ordered_json distanceJson(const BoardIndex& index, const std::optional<PieceDistance>& shortest) {
    if (!shortest) {
        return nullptr;
    }
    return {
        {"distance_nm", shortest->distance},
        {"spacing_nm", shortest->spacing.distance},
        {"gap_nm", shortest->spacing.distance},
        {"dx_nm", shortest->spacing.to.x - shortest->spacing.from.x},
        {"dy_nm", shortest->spacing.to.y - shortest->spacing.from.y},
        {"dz_nm", shortest->dz},
        {"relation", toString(shortest->relation)},
        {"overlap_nm", shortest->overlap},
        {"is_overlap_exact", shortest->isOverlapExact},
        {"ends",
         {endJson(index, shortest->from, shortest->spacing.from), endJson(index, shortest->to, shortest->spacing.to)}}};
}

void printJson(const BoardIndex& index, const Request& request, const Separation& separation) {
    ordered_json json = {{"from", nameOf(index, request.from)}, {"to", nameOf(index, request.to)}};
    for (const NamedDistance& named : distancesOf(separation)) {
        json[named.key] = distanceJson(index, named.shortest);
    }
    json["through_stack"] = json["through_stackup"];  // here and below: names of older versions
    const std::optional<double> angle = angleOf(index, request);
    json["angle_deg"] = angle ? ordered_json(*angle) : ordered_json(nullptr);
    json["notes"] = separation.notes;
    json["remarks"] = separation.notes;
    std::fputs(model::jsonText(json).c_str(), stdout);
}

/// Tables have no place for them.
void sayNotes(const std::vector<std::string>& notes) {
    for (const std::string& note : notes) {
        std::fprintf(stderr, "copperscope: %s\n", note.c_str());
    }
}

void printCsv(const BoardIndex& index, const Separation& separation) {
    sayNotes(separation.notes);
    std::printf(
        "kind,distance um,spacing um,dx um,dy um,dz um,relation,overlap um,layer a,layer b,net a,net b,x mm on a,"
        "y mm on a,x mm on b,y mm on b\n");
    for (const NamedDistance& named : distancesOf(separation)) {
        if (!named.shortest) {
            continue;
        }
        const PieceDistance& w = *named.shortest;
        const auto um = [](double nm) { return model::fixedText(nm / base::kNmPerUm, 3); };
        std::printf("%s,%s,%s,%s,%s,%s,%s,%s,%s,%s,%s,%s,%.6f,%.6f,%.6f,%.6f\n", named.key, um(w.distance).c_str(),
                    um(w.spacing.distance).c_str(), um(w.spacing.to.x - w.spacing.from.x).c_str(),
                    um(w.spacing.to.y - w.spacing.from.y).c_str(), um(w.dz).c_str(), toString(w.relation),
                    um(w.overlap).c_str(), model::csvField(layerName(index, w.from.layer)).c_str(),
                    model::csvField(layerName(index, w.to.layer)).c_str(),
                    model::csvField(netName(index, w.from)).c_str(), model::csvField(netName(index, w.to)).c_str(),
                    base::toMm(w.spacing.from.x), base::toMm(w.spacing.from.y), base::toMm(w.spacing.to.x),
                    base::toMm(w.spacing.to.y));
    }
}

std::string inBothUnits(double nm) {
    return model::formatted("%.6f mm (%.3f mil)", base::toMm(nm), nm / base::kNmPerMil);
}

void printDistance(const BoardIndex& index, const char* name, const PieceDistance& shortest) {
    std::string relation = toString(shortest.relation);
    if (shortest.relation == model::Relation::Overlapping) {
        relation += std::string(shortest.isOverlapExact ? " by " : " by at least ") + inBothUnits(shortest.overlap);
    }
    std::printf("%-18s %s, %s\n", name, inBothUnits(shortest.distance).c_str(), relation.c_str());
    const auto mm = [](double nm) { return model::fixedText(base::toMm(nm), 6); };
    std::printf("%-18s dx %s, dy %s, dz %s mm\n", "", mm(shortest.spacing.to.x - shortest.spacing.from.x).c_str(),
                mm(shortest.spacing.to.y - shortest.spacing.from.y).c_str(), mm(shortest.dz).c_str());
    for (const auto& [piece, at] :
         {std::pair(shortest.from, shortest.spacing.from), std::pair(shortest.to, shortest.spacing.to)}) {
        const std::string element =
            piece.at.element.isValid() ? "element " + std::to_string(piece.at.element.value) : "no element";
        const std::string net = netName(index, piece);
        std::printf("%-18s at %.6f, %.6f mm: %s%s%s%s%s\n", "", base::toMm(at.x), base::toMm(at.y), element.c_str(),
                    piece.layer.isValid() ? ", layer " : "", layerName(index, piece.layer).c_str(),
                    net.empty() ? "" : ", net ", net.c_str());
    }
}

void printSizes(const BoardIndex& index, const MeasureItem& item) {
    const auto* at = std::get_if<model::BoardElement>(&item);
    if (at == nullptr) {
        return;
    }
    const model::Sizes sizes = model::sizesOf(index.stepOf(at->copy), at->element);
    const std::pair<const char*, const std::optional<double>&> rows[] = {{"width", sizes.width},
                                                                         {"length", sizes.length},
                                                                         {"radius", sizes.radius},
                                                                         {"diameter", sizes.diameter},
                                                                         {"inner diameter", sizes.innerDiameter}};
    for (const auto& [name, value] : rows) {
        if (value) {
            std::printf("%-18s %s %s\n", nameOf(index, item).c_str(), name, inBothUnits(*value).c_str());
        }
    }
}

void printText(const BoardIndex& index, const Request& request, const Separation& separation) {
    std::printf("%s to %s\n", nameOf(index, request.from).c_str(), nameOf(index, request.to).c_str());
    for (const NamedDistance& named : distancesOf(separation)) {
        if (named.shortest) {
            printDistance(index, named.text, *named.shortest);
        }
    }
    if (const auto angle = angleOf(index, request)) {
        std::printf("%-18s %.4f degrees\n", "angle", *angle);
    }
    printSizes(index, request.from);
    printSizes(index, request.to);
    for (const std::string& note : separation.notes) {
        std::printf("%s\n", note.c_str());
    }
}

const char* kindName(model::PathLeg::Kind kind) {
    constexpr const char* kNames[] = {"track", "pad", "area", "hole"};
    return kNames[static_cast<std::size_t>(kind)];
}

void printPathJson(const BoardIndex& index, model::NetOfCopy net, const NetPath& path) {
    ordered_json layers = ordered_json::array();
    for (const auto& [layer, length] : path.perLayer) {
        layers.push_back({{"layer", layerName(index, layer)}, {"length_nm", length}});
    }
    ordered_json legs = ordered_json::array();
    for (const model::PathLeg& leg : path.legs) {
        legs.push_back({{"kind", kindName(leg.kind)},
                        {"layer", layerName(index, leg.layer)},
                        {"element", leg.element.element.value},
                        {"length_nm", leg.length},
                        {"from_nm", {leg.from.x, leg.from.y}},
                        {"to_nm", {leg.to.x, leg.to.y}}});
    }
    std::fputs(model::jsonText({{"net", nameOf(index, net)},
                                {"length_nm", path.length},
                                {"area_length_nm", path.areaLength},
                                {"pad_length_nm", path.padLength},
                                {"hole_count", path.holeCount},
                                {"hole_height_nm", path.holeHeight},
                                {"layers", layers},
                                {"legs", legs},
                                {"notes", path.notes},
                                {"remarks", path.notes}})
                   .c_str(),
               stdout);
}

void printPathCsv(const BoardIndex& index, const NetPath& path) {
    sayNotes(path.notes);
    std::printf("kind,layer,element,length um,x mm from,y mm from,x mm to,y mm to\n");
    for (const model::PathLeg& leg : path.legs) {
        std::printf("%s,%s,%u,%.3f,%.6f,%.6f,%.6f,%.6f\n", kindName(leg.kind),
                    model::csvField(layerName(index, leg.layer)).c_str(), leg.element.element.value,
                    leg.length / base::kNmPerUm, base::toMm(leg.from.x), base::toMm(leg.from.y), base::toMm(leg.to.x),
                    base::toMm(leg.to.y));
    }
}

void printPathText(const BoardIndex& index, model::NetOfCopy net, const NetPath& path) {
    std::printf("%-18s %s\n", nameOf(index, net).c_str(), inBothUnits(path.length).c_str());
    for (const auto& [layer, length] : path.perLayer) {
        std::printf("%-18s %s\n", layerName(index, layer).c_str(), inBothUnits(length).c_str());
    }
    std::printf("%-18s %zu, %s\n", "holes", path.holeCount, inBothUnits(path.holeHeight).c_str());
    for (const std::string& note : path.notes) {
        std::printf("%s\n", note.c_str());
    }
}

Outcome measurePath(const BoardIndex& index, const Request& request, const MeasureArguments& arguments,
                    base::Progress& progress) {
    ASSIGN_OR_RETURN(const auto net, parseNet(index, arguments.path));
    ASSIGN_OR_RETURN(const auto path, model::pathAlong(index, net, request.from, request.to, progress));
    arguments.format == "json"  ? printPathJson(index, net, path)
    : arguments.format == "csv" ? printPathCsv(index, path)
                                : printPathText(index, net, path);
    return int{kDone};
}

Outcome measureDistance(const BoardIndex& index, const Request& request, const MeasureArguments& arguments,
                        base::Progress& progress) {
    ASSIGN_OR_RETURN(const auto separation, model::separationOf(index, request.from, request.to, progress));
    arguments.format == "json"  ? printJson(index, request, separation)
    : arguments.format == "csv" ? printCsv(index, separation)
                                : printText(index, request, separation);
    if (request.below && separation.main() == nullptr) {
        return base::Error{base::ErrorCode::BadUsage, "there is no distance to compare: " + separation.notes.front()};
    }
    if (!request.below) {
        return int{kDone};
    }
    const model::Document* const jobs[] = {index.board.get()};
    const int code = separation.main()->distance < *request.below ? kTooClose : kDone;
    return verdictCode(code, jobs, arguments.allowsIncomplete);
}

}  // namespace

Outcome runMeasure(const MeasureArguments& arguments) {
    ConsoleProgress console;
    ASSIGN_OR_RETURN(const auto board, openDocument(arguments.board, console.progress()));
    ASSIGN_OR_RETURN(const auto index, model::indexBoard(board, console.progress()));
    ASSIGN_OR_RETURN(const auto request, requestFrom(*index, arguments));
    return arguments.path.empty() ? measureDistance(*index, request, arguments, console.progress())
                                  : measurePath(*index, request, arguments, console.progress());
}

}  // namespace app
