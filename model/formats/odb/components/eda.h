#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "model/board/diagnostics.h"
#include "model/board/document.h"
#include "model/formats/odb/text/record_attributes.h"
#include "model/formats/odb/text/records.h"

namespace model::odb {

/// A FID record: a feature of a layer.
struct EdaFeature {
    std::uint32_t layer = 0;    ///< row of EdaData::layers
    std::uint32_t feature = 0;  ///< ordinal in the layer's features file
    std::uint32_t line = 0;
};

struct EdaNet {
    std::string name;
    std::vector<TextProperty> properties;  ///< attributes, then PRP
};

/// SNT record: what a group of a net's features is. Features right below a NET record are in a subnet of kind Other.
struct EdaSubnet {
    std::uint32_t net = 0;  ///< row of EdaData::nets
    SubnetKind kind = SubnetKind::Other;
    LayerSide side = LayerSide::None;  ///< PinPads: side of the component,
    std::int32_t component = -1;       ///< its number among the CMP records of that side,
    std::int32_t toeprint = -1;        ///< and the number of its TOP record
    PlaneFill planeFill = PlaneFill::NotSaid;
    PlaneCutout planeCutout = PlaneCutout::NotSaid;
    Nm planeCutoutSize = 0;
    std::uint32_t firstFeature = 0;  ///< rows of EdaData::features
    std::uint32_t featureCount = 0;
};

struct EdaPin {
    std::string name;
    PinKind kind = PinKind::Surface;
    Point position;       ///< in package coordinates, as seen from the top
    ShapeSketch outline;  ///< in package coordinates
};

/// PKG record with its pins.
struct EdaPackage {
    std::string name;
    Nm pitch = 0;
    Box box;
    ShapeSketch outline;  ///< may be empty; several outlines are several islands
    std::vector<EdaPin> pins;
    std::vector<TextProperty> properties;
};

/// FGR record: features that belong together, a text for example.
struct EdaGroup {
    std::string type;  ///< TEXT, PCB
    std::vector<TextProperty> properties;
    std::uint32_t firstFeature = 0;  ///< rows of EdaData::features
    std::uint32_t featureCount = 0;
};

/// What `eda/data` says about nets, packages and groups (odb-notes, Nets and parts).
struct EdaData {
    std::string generator;            ///< HDR
    std::vector<std::string> layers;  ///< LYR
    std::vector<EdaNet> nets;         ///< in file order: components refer to these by number
    std::vector<EdaSubnet> subnets;
    std::vector<EdaPackage> packages;
    std::vector<EdaGroup> groups;
    std::vector<EdaFeature> features;
};

/// The name that stands for "no net".
inline constexpr std::string_view kNoNet = "$NONE$";

/// `layerNames` are those of the matrix: LYR separates names by blanks, and names may hold blanks themselves, so the
/// longest known name wins. Records that are unknown, unreadable or in the wrong part of the file are reported.
[[nodiscard]] EdaData parseEda(std::string_view text, std::string_view path, Unit defaultUnit,
                               const std::vector<std::string>& layerNames, const AttributeTypes& types,
                               Diagnostics& diagnostics);

}  // namespace model::odb
