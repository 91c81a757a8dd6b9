#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "model/board/document_builder.h"

namespace model::formats {

/// A point of a netlist, in the netlist's own coordinates. Its name, net and netlist are settled by addNetPoints.
struct NetlistPoint : NetPoint {
    std::int32_t number = -1;  ///< row of Netlist::names
    std::uint32_t line = 0;
};

/// What a netlist file says.
struct Netlist {
    std::vector<std::string> names;
    std::vector<NetlistPoint> points;
    std::string noNet;  ///< the name that stands for "no net"; empty if there is none
};

struct NetlistFile {
    const Netlist* netlist = nullptr;
    NetlistKind kind = NetlistKind::Design;
    std::string_view path;  ///< for diagnostics
};

/// Brings the points of netlists into the document and compares them with its nets, once elements and components are
/// there.
///
/// A netlist may count from another origin than everything else: when less than half of its points lie on a pad or hole
/// of their net, the shift that most points agree on is added, and reported. Names that no net has, and points that lie
/// on no pad or hole of their net, are reported with their number.
void addNetPoints(DocumentBuilder& builder, std::span<const NetlistFile> files);

}  // namespace model::formats
